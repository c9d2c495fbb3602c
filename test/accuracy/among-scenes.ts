// Small things where something cuts the volume, stands in it, or is painted in it.
import type { Vector3 } from '../../src/volume/matrix.ts';
import { randomNumbers } from '../helpers/synthetic.ts';
import { alongEdges, ontoPlane, ontoShape, writeShape } from './among-shapes.ts';
import type { LoneShape, Snap } from './among-shapes.ts';
import type { SmallScene } from './small-scenes.ts';
import { makeLesions, makeWires, smallFunctions, veilValue } from './small-volumes.ts';
import type { SmallVolume } from './small-volumes.ts';
import { VoxelBlock } from './voxel-block.ts';

/** A scene of small things and something else. */
export interface AmongScene extends SmallScene {
  readonly kind: 'cut' | 'shape' | 'slice';
  readonly attributes: Readonly<Record<string, string>>;
  /** Between the tags. */
  readonly children: string;
  readonly shape: LoneShape | null;
  /** Things that count, at each angle at the least: or nothing has been measured. */
  readonly fewest: number;
  /** What a thing has in a pixel that is all in the middle of it, 1/255; null where that is not the same for all. */
  readonly whole: number | null;
}

type WithoutKind = Omit<AmongScene, 'kind'>;

/** Voxels of 1 mm around the origin: a place of the world is an index less this, x and y with the other sign. */
const edge = 48;
const half = (edge - 1) / 2;
const toIndex = ([x, y, z]: Vector3): Vector3 => [half - x, half - y, half + z];

const count = 60;

/** What is stored in them, of 255. */
export const speckValue = 220;

const inside = (n: number): number => Math.min(edge - 4, Math.max(3, Math.round(n)));

/** Specks of one voxel, of which a share lies on surfaces, as nearly as voxels can. @param on - by turns */
export function scatterOn(medium: number, on: readonly Snap[], share = 0.5): SmallVolume {
  const random = randomNumbers(edge + on.length);
  const bare = new VoxelBlock(edge, medium);
  const block = bare.copy();
  const free = (): number => (random() - 0.5) * (edge - 10);
  const places = Array.from({ length: count }, (_, n): Vector3 => {
    const place: Vector3 = [free(), free(), free()];
    const snap = n < share * count ? on[n % on.length] : undefined;
    return toIndex(snap ? snap(place) : place).map(inside) as unknown as Vector3;
  });
  for (const place of places) block.set(place, speckValue);
  return { block, bare, places };
}

/** The six faces of a box along the world's axes. */
function ontoBox(box: readonly number[]): Snap[] {
  return box.map((at, i) => ontoPlane([0, 1, 2].map((axis) => Number(axis === i % 3)) as unknown as Vector3, at));
}

const view = (pixelsPerVoxel: number, [theta, phi]: readonly [number, number], pixels = 112): SmallScene['view'] => ({
  pixelsPerVoxel,
  pixels,
  ratio: 1,
  theta,
  phi,
});

const usual = { minContrast: 8, reach: 1, attributes: {}, children: '', shape: null, fewest: 15, whole: null };
const inVeil = { ...usual, transferFunction: smallFunctions.veil };
const alone = { ...usual, transferFunction: smallFunctions.solid };

const part = [-14.3, -12.6, -15.1, 16.2, 17.4, 13.9];
const corner = [-2.4, -22, 1.3, 23, 3.2, 23];
const oblique: Vector3 = [1, 0.4, 0.2];
const slab = [-30, -30, -0.4, 30, 30, 0.4];

const cuts: readonly WithoutKind[] = [
  {
    ...inVeil,
    name: 'Specks in a veil, `region`',
    view: view(2, [30, 75]),
    attributes: { region: part.join(' ') },
    make: () => scatterOn(veilValue, ontoBox(part)),
  },
  {
    ...alone,
    name: 'Specks in empty space, `cutout`',
    view: view(2, [200, 60]),
    attributes: { cutout: corner.join(' ') },
    make: () => scatterOn(0, ontoBox(corner)),
  },
  {
    ...inVeil,
    name: 'Specks in a veil, an oblique `<volume-clip>`',
    view: view(1.3, [70, 70], 80),
    children: `<volume-clip type="plane" normal="${oblique.join(' ')}" at="2.3"></volume-clip>`,
    make: () => scatterOn(veilValue, [ontoPlane(oblique, 2.3)], 0.7),
  },
  {
    ...alone,
    name: 'Wires of 1 voxel, a `<volume-clip>` that cuts a box out',
    view: view(1.2, [70, 70], 80),
    children: `<volume-clip type="box" keep="outside" box="${corner.join(' ')}"></volume-clip>`,
    make: () => makeWires(edge, 14),
  },
  {
    ...inVeil,
    name: 'Lesions of low contrast, radius 2, `ClipPlane`',
    fewest: 8,
    reach: 2,
    minContrast: 2,
    view: view(2.2, [10, 80], 128),
    transferFunction: '0 #400 0, 60 #400 0, 80 #a64 1.5%, 170 #fda 6%, 255 white 10%',
    children: '<ClipPlane plane="0 -1 0 3.4"></ClipPlane>',
    make: makeLesions,
  },
  {
    ...alone,
    name: 'Specks in a `region` that is 0.8 voxels thick',
    view: view(2, [20, 40]),
    attributes: { region: slab.join(' ') },
    make: () =>
      scatterOn(
        0,
        ontoBox(slab).filter((_, i) => i % 3 === 2),
        0.8,
      ),
  },
];

const plate: LoneShape = { kind: 'box', center: [0, 0, 0], size: [60, 0.6, 60], turn: 0.4, opacity: 1 };
const sheet: LoneShape = { ...plate, turn: -0.3, opacity: 0.5 };
const ball: LoneShape = { kind: 'ball', center: [3, 2, 1], size: [12, 12, 12], turn: 0, opacity: 1 };
const ground: LoneShape = { kind: 'box', center: [0, 0, -30], size: [90, 90, 1], turn: 0, opacity: 1 };
const block: LoneShape = { kind: 'box', center: [3, -4, 2], size: [11, 13, 12], turn: 0.7, opacity: 1 };

const shapes: readonly (WithoutKind & { readonly shape: LoneShape })[] = [
  {
    ...inVeil,
    name: 'Specks in a veil, on both sides of a plate',
    view: view(2, [30, 75]),
    shape: plate,
    make: () => scatterOn(veilValue, ontoShape(plate)),
  },
  {
    ...alone,
    name: 'Specks in empty space, on and around a ball',
    view: view(2, [120, 70]),
    shape: ball,
    make: () => scatterOn(0, ontoShape(ball)),
  },
  {
    ...alone,
    name: 'Specks in empty space, before a ground',
    view: view(1.4, [40, 30], 80),
    shape: ground,
    make: () => scatterOn(0, [], 0),
  },
  {
    ...alone,
    name: 'Wires of 1 voxel, around a block',
    view: view(1.2, [70, 70], 80),
    shape: block,
    make: () => makeWires(edge, 14),
  },
  {
    ...alone,
    name: 'Specks in empty space, along the edges of a block',
    fewest: 10,
    view: view(2, [70, 70]),
    shape: block,
    make: () => scatterOn(0, alongEdges(block), 1),
  },
  {
    ...inVeil,
    name: 'Specks in a veil, on both sides of a translucent sheet',
    view: view(2, [200, 65]),
    shape: sheet,
    make: () => scatterOn(veilValue, ontoShape(sheet)),
  },
];

const slice = (attributes: string): string =>
  `<volume-slice value-window="0 255" colors="gray" ${attributes}></volume-slice>`;
const onSlice = {
  ...alone,
  attributes: { 'opacity-factor': '0' },
  children: slice('type="axial" at="0.5"'),
  fewest: 30,
  make: () => scatterOn(0, [ontoPlane([0, 0, 1], 0.5)], 1),
};
const tilted: Vector3 = [1, 0.5, 0.7];
const three: readonly Snap[] = [ontoPlane([0, 0, 1], -6.5), ontoPlane([1, 0, 0], 4.5), ontoPlane([0, 1, 0], 8.5)];

const slices: readonly WithoutKind[] = [
  ...[1.05, 1.5, 2.3, 3.7].map((zoom, i) => ({
    ...onSlice,
    whole: speckValue,
    name: `Specks on a slice, ${zoom} pixels a voxel`,
    view: view(zoom, [20 + 30 * i, 6], zoom > 2 ? 144 : 80),
  })),
  {
    ...onSlice,
    name: 'Specks half a voxel from a slice',
    view: view(1.8, [20, 20], 100),
    children: slice('type="axial" at="0"'),
  },
  {
    ...onSlice,
    name: 'Specks on an oblique slice',
    view: view(1.8, [70, 60], 100),
    children: slice(`type="oblique" normal="${tilted.join(' ')}" at="1.5"`),
    make: () => scatterOn(0, [ontoPlane(tilted, 1.5)], 1),
  },
  {
    ...onSlice,
    name: 'Specks in a slice of 5 voxels, maximum',
    view: view(1.5, [40, 10], 80),
    children: slice('type="axial" at="0.5" thickness="5" projection="max"'),
    make: () =>
      scatterOn(
        0,
        [-1.5, 0.5, 2.5].map((at) => ontoPlane([0, 0, 1], at)),
        1,
      ),
  },
  {
    ...inVeil,
    name: 'Specks in a veil, on and before three slices',
    view: view(2, [35, 60]),
    children: ['type="axial" at="-6.5"', 'type="sagittal" at="4.5"', 'type="coronal" at="8.5"'].map(slice).join(''),
    make: () => scatterOn(veilValue, three),
  },
  {
    ...inVeil,
    name: 'Specks in a veil, on a slice in its colours',
    view: view(1.6, [50, 40], 96),
    children: slice('type="axial" at="0.5"').replace('gray', 'volume'),
    make: () => scatterOn(veilValue, [ontoPlane([0, 0, 1], 0.5)], 0.8),
  },
];

export const amongScenes: readonly AmongScene[] = [
  ...cuts.map((scene) => ({ ...scene, kind: 'cut' as const })),
  ...shapes.map((scene) => ({ ...scene, kind: 'shape' as const, children: writeShape(scene.shape) })),
  ...slices.map((scene) => ({ ...scene, kind: 'slice' as const })),
];
