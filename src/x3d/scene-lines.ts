import type { Vector3 } from '../volume/matrix.ts';
import type { X3dDocument, X3dOwned } from './x3dom-types.ts';

/** Lines in world coordinates, each from point to point. */
export type Lines = readonly (readonly Vector3[])[];

/** Seen on dark and on light, and through thin rain. */
const lineColor = '0.33 0.36 0.4';

/** Thin lines in the scene, as a shape among the author's: what of the volume is before them covers them. */
export class SceneLines {
  #root: X3dOwned | null = null;
  #shown = '[]';

  constructor(readonly document: X3dDocument) {}

  /** Put lines in place of those before; the same ones stay. */
  show(lines: Lines): void {
    const text = JSON.stringify(lines);
    if (text === this.#shown) return;
    this.#shown = text;
    this.#remove();
    if (lines.length === 0) return;
    const scene = this.document._scene;
    this.#root = buildLines(lines);
    scene._xmlNode!.append(this.#root);
    scene.addChild(scene._nameSpace.setupTree(this.#root)!);
    scene.nodeChanged();
    this.document.needRender = true;
  }

  #remove(): void {
    if (!this.#root) return;
    const scene = this.document._scene;
    if (this.#root._x3domNode) {
      scene.removeChild(this.#root._x3domNode);
      scene.nodeChanged();
    }
    this.document.removeX3DOMBackendGraph(this.#root);
    this.#root.remove();
    this.#root = null;
    this.document.needRender = true;
  }
}

function buildLines(lines: Lines): X3dOwned {
  let next = 0;
  const indices = lines.map((line) => line.map(() => next++).concat(-1).join(' '));
  const shape = document.createElement('shape');
  shape.setAttribute('isPickable', 'false');
  shape.innerHTML = `<appearance><material diffuseColor="0 0 0" emissiveColor="${lineColor}"></material></appearance>
    <indexedlineset coordIndex="${indices.join(' ')}"><coordinate point="${lines.flat(2).join(' ')}"></coordinate></indexedlineset>`;
  return shape;
}
