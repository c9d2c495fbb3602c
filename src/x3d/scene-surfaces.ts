import type { ShownSurface } from '../renderer/layers/shown-surfaces.ts';
import type { Surface } from '../volume/surface.ts';
import type { X3dDocument, X3dGeometry, X3dOwned, X3dShape, X3dVector, X3dom } from './x3dom-types.ts';

/** The material of surfaces in X3D's terms: dull, with a soft highlight. */
const matter = { ambientIntensity: '0.25', specularColor: '0.02 0.02 0.02', shininess: '0.2' };

/**
 * The share of ambient light. x3dom's headlight has none: where a surface turns away it would end in black, in a seam
 * that is thinner than a pixel in some places and not in others. It is not used for surfaces with vertex colours: a
 * material has one ambient light for all, and a dark sea would be as grey as the land around it.
 */
const around = 0.2;

/** x3dom treats colours of materials and vertices as amounts of light, and writes the picture with this exponent. */
const gamma = 2.2;

const toLight = (channel: number): number => channel ** gamma;

/** The linear colours of vertices, which stay the same while their surface is cut again and again. */
const lights = new WeakMap<Float32Array, Float32Array>();

/** The surfaces of several owners in a scene, as shapes among the author's. */
export class SceneSurfaces {
  readonly #shown = new Map<object, { readonly shown: ShownSurface; readonly root: X3dOwned }>();

  constructor(
    readonly x3dom: X3dom,
    readonly document: X3dDocument,
  ) {}

  /** Show a surface in place of the one that its owner had before; null for none. */
  show(shown: ShownSurface | null, owner: object): void {
    const before = this.#shown.get(owner);
    if (shown === (before?.shown ?? null)) return;
    if (before) this.#remove(before.root);
    this.#shown.delete(owner);
    if (shown) this.#shown.set(owner, { shown, root: this.#add(shown) });
  }

  #add(shown: ShownSurface): X3dOwned {
    const scene = this.document._scene;
    const root = buildShape(shown);
    scene._xmlNode!.append(root);
    const shape = scene._nameSpace.setupTree(root) as X3dShape;
    fill(this.x3dom, shape._cf.geometry!.node, shown);
    scene.addChild(shape);
    scene.nodeChanged();
    shape.setAllDirty();
    scene.updateVolume();
    this.document.needRender = true;
    return root;
  }

  #remove(root: X3dOwned): void {
    const scene = this.document._scene;
    if (root._x3domNode) {
      scene.removeChild(root._x3domNode);
      scene.nodeChanged();
      scene.updateVolume();
    }
    this.document.removeX3DOMBackendGraph(root);
    root.remove();
    this.document.needRender = true;
  }
}

/** Not solid: both sides are visible, and lit. x3dom's own geometry is one point, which the triangles replace. */
function buildShape(shown: ShownSurface): X3dOwned {
  const light = shown.color.map(toLight);
  const build = (name: string, attributes: Record<string, string>, ...children: Element[]): Element => {
    const element = document.createElement(name);
    for (const [attribute, value] of Object.entries(attributes)) element.setAttribute(attribute, value);
    element.append(...children);
    return element;
  };
  return build(
    'shape',
    { isPickable: 'false' },
    build(
      'appearance',
      { sortType: 'opaque' },
      build('material', {
        diffuseColor: scaled(light, 1 - around),
        emissiveColor: scaled(light, ownColors(shown) ? 0 : around),
        ...matter,
      }),
    ),
    build(
      'indexedtriangleset',
      { solid: 'false', useGeoCache: 'false', index: '0 0 0' },
      build('coordinate', { point: '0 0 0' }),
      build('normal', { vector: '0 0 1' }),
    ),
  );
}

/** Typed arrays are uploaded as they are: as text, or as x3dom's own vectors, millions of numbers would take long. */
function fill(x3dom: X3dom, geometry: X3dGeometry, shown: ShownSurface): void {
  const mesh = geometry._mesh;
  const {
    surface,
    surface: { parts },
  } = shown;
  const hasColors = ownColors(shown);
  mesh._positions = parts.map((part) => part.positions);
  mesh._normals = parts.map((part) => part.normals);
  mesh._indices = parts.map((part) => part.indices);
  mesh._colors = hasColors ? parts.map((part) => lightsOf(part.colors!)) : [[]];
  mesh._texCoords = [[]];
  mesh._numColComponents = 3;
  mesh._numFaces = surface.triangles;
  mesh._numCoords = parts.reduce((sum, { positions }) => sum + positions.length / 3, 0);
  // x3dom looks only at the first part.
  const box = new x3dom.fields.BoxVolume(vectorOf(x3dom, surface.low), vectorOf(x3dom, surface.high));
  mesh.getVolume = () => box;
}

function lightsOf(colors: Float32Array): Float32Array {
  const known = lights.get(colors) ?? colors.map((channel) => (1 - around) * toLight(channel));
  lights.set(colors, known);
  return known;
}

function ownColors({ surface, usesOwnColors }: ShownSurface): boolean {
  return usesOwnColors && surface.parts.every(({ colors }) => colors);
}

function scaled(color: readonly number[], by: number): string {
  return color.map((channel) => by * channel).join(' ');
}

function vectorOf(x3dom: X3dom, [x, y, z]: Surface['low']): X3dVector {
  return new x3dom.fields.SFVec3f(x, y, z);
}
