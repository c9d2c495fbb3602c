import type { GroundMap } from '../radar/ground-map.ts';
import type { ShownSurface } from '../renderer/layers/shown-surfaces.ts';
import type { Vector3 } from '../volume/matrix.ts';
import type { X3dDocument, X3dOwned } from './x3dom-types.ts';

/** Lines in world coordinates, each a list of points. */
export type Lines = readonly (readonly Vector3[])[];

/** Lines around the volume, and the map below them. */
export interface Ground {
  readonly lines: Lines;
  readonly map?: GroundMap;
}

/** Red, green and blue, 0..1. */
export type LineColor = readonly [red: number, green: number, blue: number];

/** Visible on dark and on light, and through thin rain. */
const ringColor: LineColor = [0.33, 0.36, 0.4];

/** Quieter than the rings; a coast is the blue of water, a border a greyish brown. */
const coastColor: LineColor = [0.2, 0.36, 0.46];
const borderColor: LineColor = [0.34, 0.3, 0.24];

/** Owners of a map's lines. */
const [coastOwner, borderOwner] = [{}, {}];

/** The lines of one owner. */
interface Shown {
  readonly root: X3dOwned;
  readonly text: string;
}

/** Thin lines in the scene, as shapes among the author's: the parts of the volume in front of them cover them. */
export class SceneLines {
  readonly #shown = new Map<object, Shown>();
  #ground: Ground | null = null;

  /** @param showSurface - see `OtherShapes` */
  constructor(
    readonly document: X3dDocument,
    readonly showSurface: (shown: ShownSurface | null, owner: object) => Promise<void> = async () => {},
  ) {}

  /** Shows the lines around the volume and the map below them. Each picture calls it, most of them with the same ones. */
  showGround(ground: Ground | null): void {
    if (ground === this.#ground) return;
    this.#ground = ground;
    const { lines = [], map } = ground ?? {};
    this.show(map?.coasts ?? [], coastOwner, coastColor);
    this.show(map?.borders ?? [], borderOwner, borderColor);
    this.show(lines);
  }

  /** Replaces the lines of an owner; the same lines stay. */
  show(lines: Lines, owner: object = this, color = ringColor): void {
    const text = JSON.stringify([lines, color]);
    const before = this.#shown.get(owner);
    if (text === before?.text) return;
    if (before) this.#remove(before);
    this.#shown.delete(owner);
    if (lines.length === 0) return;
    const scene = this.document._scene;
    const root = buildLines(lines, color);
    this.#shown.set(owner, { root, text });
    scene._xmlNode!.append(root);
    scene.addChild(scene._nameSpace.setupTree(root)!);
    scene.nodeChanged();
    this.document.needRender = true;
  }

  #remove({ root }: Shown): void {
    const scene = this.document._scene;
    if (root._x3domNode) {
      scene.removeChild(root._x3domNode);
      scene.nodeChanged();
    }
    this.document.removeX3DOMBackendGraph(root);
    root.remove();
    this.document.needRender = true;
  }
}

function buildLines(lines: Lines, color: LineColor): X3dOwned {
  let next = 0;
  const indices = lines.map((line) =>
    line
      .map(() => next++)
      .concat(-1)
      .join(' '),
  );
  const shape = document.createElement('shape');
  shape.setAttribute('isPickable', 'false');
  shape.innerHTML = `<appearance><material diffuseColor="0 0 0" emissiveColor="${color.join(' ')}"></material></appearance>
    <indexedlineset coordIndex="${indices.join(' ')}"><coordinate point="${lines.flat(2).join(' ')}"></coordinate></indexedlineset>`;
  return shape;
}
