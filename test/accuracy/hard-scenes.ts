// Scenes that were made to break what is said of a picture's errors.
import { orbitCamera } from '../../src/optics/rays/camera.ts';
import type { Camera } from '../../src/optics/rays/camera.ts';
import { buildDefaultPreset } from '../../src/optics/transfer/default-preset.ts';
import { parseTransferFunction } from '../../src/optics/transfer/parse-transfer-function.ts';
import { outlinePatches } from '../../src/optics/transfer/patches.ts';
import type { Patch } from '../../src/optics/transfer/patches.ts';
import type { VolumeStyle } from '../../src/optics/transfer/volume-styles.ts';
import { createClip } from '../../src/renderer/ray/modules/clip.ts';
import { createCutout } from '../../src/renderer/ray/modules/cutout.ts';
import { unitToWorld } from '../../src/volume/grid.ts';
import { transformPoint } from '../../src/volume/matrix.ts';
import type { Vector3 } from '../../src/volume/matrix.ts';
import { cutRegion } from '../../src/volume/region.ts';
import type { Volume } from '../../src/volume/volume.ts';
import { changePlan } from '../helpers/change-plan.ts';
import type { RestScene } from '../helpers/at-rest.ts';
import { cutBox, keep } from '../helpers/clips.ts';
import { labelMap, plainAppearance } from '../helpers/labels.ts';
import { askew, overlayOf } from '../helpers/overlays.ts';
import { ball, byIndex, farGates, holes, masked, noise, scatter, sheared, withVoxels } from './hard-volumes.ts';

/** A scene to be drawn. */
interface MadeScene extends RestScene {
  /** All is behind the eye or beside the picture: there is no error to be told. */
  readonly isOutOfSight?: boolean;
}

/** A scene, and how a table names its kind. */
export interface HardScene {
  readonly kind: string;
  readonly name: string;
  readonly make: () => MadeScene;
}

const outOfSight = { isOutOfSight: true } as const;

/** By what shows, of values from 0 to 1. */
const looks = {
  bright: '0.3 #fa6 0, 1 #fa6 60%',
  opaque: '0.5 #fa6 0, 0.5 #fa6 100%, 1 #fff 100%',
  peak: '0.45 #0cf 0, 0.5 #0cf 60%, 0.55 #0cf 0',
  fog: '0 #246 0, 0.3 #c85 3%, 1 #fff 30%',
  veil: '0 #8ac 1%, 1 #fc8 60%',
  thin: '0.4995 #0cf 0, 0.5 #0cf 60%, 0.5005 #0cf 0',
  tips: '0.93 #fff 0, 1 #fff 99%',
} as const;

const wide = { width: 56, height: 56 } as const;
const block: Vector3 = [40, 40, 40];

interface Aim {
  readonly theta?: number;
  readonly phi?: number;
  /** World length. */
  readonly far: number;
  /** Shares of the grid. */
  readonly at?: Vector3;
  readonly angle?: number;
}

/** Look at a place of a volume. */
function aim({ grid }: Volume, { theta = 0.7, phi = 1.1, far, at = [0.5, 0.5, 0.5], angle = 0.5 }: Aim): Camera {
  return orbitCamera({ theta, phi, radius: far }, transformPoint(unitToWorld(grid), at), angle);
}

/** A volume as it is, in one of the looks. */
function plain(volume: Volume, appearance: keyof typeof looks, aimed: Aim, more: Partial<MadeScene> = {}): MadeScene {
  return {
    volume,
    style: null,
    transferFunction: parseTransferFunction(looks[appearance], [0, 1]),
    camera: aim(volume, aimed),
    size: wide,
    ...more,
  };
}

/** Two things as far from each other as can be. */
const farApart: readonly Vector3[] = [
  [2, 2, 2],
  [61, 61, 61],
];
const specks = (): Volume => withVoxels(block, scatter(block, 24));
const rod = (axis: number, place: number): Volume =>
  byIndex(block, (...at) => Number(at.every((n, other) => other === axis || n === place)));
const boundary: VolumeStyle = { kind: 'boundary', retained: 0.1, boundary: 0.9, power: 2 };
const silhouette: VolumeStyle = { kind: 'silhouette', retained: 0.1, boundary: 0.9, sharpness: 4 };
const band: Patch = { kind: 'box', values: [0.05, 0.95], gradients: [0.15, 0.45], color: [1, 0.5, 0.2], opacity: 0.6 };
const surfaces = [
  { value: 0.4, color: [1, 0.6, 0.4], opacity: 0.4 },
  { value: 0.6, color: [0.8, 0.9, 1], opacity: 1 },
] as const;
const cubeOf = (edge: number): Vector3 => [edge, edge, edge];

/** Scenes of a kind, by name. */
const kinds: Record<string, Record<string, () => MadeScene>> = {
  'few pixels of many': {
    'two voxels far apart, 700 × 700': () =>
      plain(withVoxels(cubeOf(64), farApart), 'bright', { far: 220 }, { size: { width: 700, height: 700 } }),
    'two voxels far apart, 1100 × 800': () =>
      plain(withVoxels(cubeOf(64), farApart), 'bright', { far: 330 }, { size: { width: 1100, height: 800 } }),
    'eight voxels of 128 × 128 × 128, 700 × 700': () =>
      plain(
        withVoxels(cubeOf(128), scatter(cubeOf(128), 8)),
        'bright',
        { far: 500 },
        { size: { width: 700, height: 700 } },
      ),
    'two voxels of 160 × 160 × 160, 2 pixels each': () =>
      plain(
        withVoxels(cubeOf(160), [
          [3, 4, 2],
          [155, 153, 157],
        ]),
        'bright',
        { far: 640 },
        { size: { width: 700, height: 700 } },
      ),
    'the tips of two voxels, 700 × 700': () =>
      plain(withVoxels(cubeOf(64), farApart), 'tips', { far: 220 }, { size: { width: 700, height: 700 } }),
    'the tips of specks, 400 × 400': () => plain(specks(), 'tips', { far: 130 }, { size: { width: 400, height: 400 } }),
    'the tips of specks': () => plain(specks(), 'tips', { far: 110 }),
    'a wire across, 700 × 700': () => plain(rod(0, 20), 'bright', { far: 300 }, { size: { width: 700, height: 700 } }),
    'an opaque voxel in a corner and one in the other': () =>
      plain(withVoxels(cubeOf(64), farApart), 'opaque', { far: 220 }, { size: { width: 700, height: 700 } }),
    'a plate from its edge': () =>
      plain(
        byIndex(block, (...at) => Number(at[2] === 20)),
        'bright',
        { far: 160, phi: Math.PI / 2 },
        { size: { width: 400, height: 400 } },
      ),
    'a speck in a veil, near, 160 × 160': () =>
      plain(
        withVoxels(block, [[20, 20, 20]], { around: 0.05 }),
        'veil',
        { far: 40 },
        { size: { width: 160, height: 160 } },
      ),
  },
  'at the edge of the picture': {
    'a sliver on the left': () =>
      plain(
        byIndex(block, () => 0.5),
        'peak',
        { far: 120, at: [2.3, 0.5, 0.5], theta: Math.PI, phi: Math.PI / 2 },
        { size: { width: 600, height: 400 } },
      ),
    'a sliver of specks': () =>
      plain(
        specks(),
        'bright',
        { far: 120, at: [2.1, 0.5, 0.5], theta: Math.PI, phi: Math.PI / 2 },
        { size: { width: 600, height: 400 } },
      ),
    'noise at a corner': () =>
      plain(
        noise(block),
        'peak',
        { far: 120, at: [1.85, 0.5, 1.85], theta: Math.PI, phi: Math.PI / 2 },
        { size: { width: 500, height: 500 } },
      ),
    'all of it beside the picture': () =>
      plain(specks(), 'bright', { far: 120, at: [3, 0.5, 0.5], theta: Math.PI, phi: Math.PI / 2 }, outOfSight),
  },
  'behind the eye': {
    'specks behind, nothing ahead': () =>
      plain(
        withVoxels(block, scatter([40, 12, 40], 20)),
        'bright',
        { far: 1, at: [0.5, 0.6, 0.5], theta: 0, phi: Math.PI / 2 },
        outOfSight,
      ),
    'the volume behind': () =>
      plain(specks(), 'bright', { far: 20, at: [0.5, 3, 0.5], theta: 0, phi: Math.PI / 2 }, outOfSight),
    'noise behind, fog ahead': () =>
      plain(
        byIndex(block, (i, j, k) => (j > 20 ? 0.4 : (i * 7 + j * 11 + k * 5) % 2)),
        'fog',
        { far: 1, at: [0.5, 0.6, 0.5], theta: 0, phi: Math.PI / 2 },
      ),
    'specks behind and one ahead': () =>
      plain(
        withVoxels(block, [...scatter([40, 12, 40], 20), [20, 36, 22]]),
        'bright',
        { far: 1, at: [0.5, 0.55, 0.5], theta: 0, phi: Math.PI / 2 },
        { size: { width: 500, height: 500 } },
      ),
  },
  'the eye inside': {
    'of specks': () => plain(specks(), 'bright', { far: 4 }),
    'of noise': () => plain(noise(block), 'fog', { far: 4 }),
    'of noise, through a narrow peak': () => plain(noise(block), 'peak', { far: 4 }),
    'of an opaque ball, at its rim': () => plain(ball(40, 14, 2), 'opaque', { far: 3, at: [0.85, 0.5, 0.5] }),
    'one voxel fills the picture': () =>
      plain(withVoxels(block, [[20, 20, 20]]), 'bright', { far: 0.6, at: [0.5125, 0.5125, 0.5125] }),
    'one voxel fills the picture, opaque': () =>
      plain(withVoxels(block, [[20, 20, 20]]), 'opaque', { far: 2.5, at: [0.5125, 0.5125, 0.5125] }),
  },
  "patterns at the grid's own frequency": {
    'comb along the view': () =>
      plain(
        byIndex(block, (i) => i % 2),
        'peak',
        { far: 110, theta: Math.PI / 2, phi: Math.PI / 2 },
      ),
    'comb from the side': () =>
      plain(
        byIndex(block, (i) => i % 2),
        'peak',
        { far: 110 },
      ),
    'comb, opaque': () =>
      plain(
        byIndex(block, (i) => i % 2),
        'opaque',
        { far: 110 },
      ),
    'checkerboard, peak': () =>
      plain(
        byIndex(block, (i, j, k) => (i + j + k) % 2),
        'peak',
        { far: 110 },
      ),
    'checkerboard, fog': () =>
      plain(
        byIndex(block, (i, j, k) => (i + j + k) % 2),
        'fog',
        { far: 110 },
      ),
    'comb with twice the samples': () =>
      plain(
        byIndex(block, (i) => Math.floor(i / 2) % 2),
        'peak',
        { far: 110, theta: Math.PI / 2, phi: Math.PI / 2 },
      ),
  },
  'grids of odd shapes': {
    '1 × 40 × 40': () => plain(noise([1, 40, 40]), 'bright', { far: 90 }),
    '40 × 1 × 1': () =>
      plain(
        withVoxels(
          [40, 1, 1],
          [
            [20, 0, 0],
            [39, 0, 0],
          ],
        ),
        'bright',
        { far: 90 },
      ),
    'one voxel': () =>
      plain(
        byIndex([1, 1, 1], () => 1),
        'fog',
        { far: 3 },
      ),
    '3 × 5 × 200': () => plain(noise([3, 5, 200]), 'peak', { far: 400 }),
    'thick slices, 1 : 20': () =>
      plain(withVoxels([40, 40, 8], scatter([40, 40, 8], 20, { margin: 1 }), { spacing: [1, 1, 20] }), 'bright', {
        far: 380,
      }),
    'thin slices, 20 : 1': () =>
      plain(withVoxels([8, 8, 60], scatter([8, 8, 60], 20, { margin: 1 }), { spacing: [20, 20, 1] }), 'bright', {
        far: 380,
      }),
    'thin slices of noise, 20 : 1': () => plain(noise([8, 8, 60], 3, { spacing: [20, 20, 1] }), 'peak', { far: 380 }),
    sheared: () => plain(sheared(block, scatter(block, 24)), 'bright', { far: 110 }),
    'sheared, 1 : 20': () =>
      plain(sheared([40, 40, 8], scatter([40, 40, 8], 20, { margin: 1 }), [1, 1, 20]), 'bright', { far: 380 }),
    'faces and corners': () =>
      plain(
        byIndex(block, (...at) => Number(at.filter((n) => n === 0 || n === 39).length > 1)),
        'bright',
        { far: 110 },
      ),
    'sheets, 1 : 200, from their side': () =>
      plain(
        withVoxels([40, 40, 40], scatter([40, 40, 40], 24), { spacing: [0.005, 1, 1] }),
        'bright',
        { far: 110, theta: Math.PI / 2, phi: Math.PI / 2 },
        { optics: { referenceLength: 0.005 } },
      ),
    'sheets of noise, 1 : 200, from their side': () =>
      plain(
        noise([40, 40, 40], 3, { spacing: [0.005, 1, 1] }),
        'peak',
        { far: 110, theta: Math.PI / 2, phi: Math.PI / 2 },
        { optics: { referenceLength: 0.01 } },
      ),
    'where cells meet': () =>
      plain(
        withVoxels(
          block,
          scatter([4, 4, 4], 30, { margin: 0 }).map((place) => place.map((n) => 8 * n + 7) as unknown as Vector3),
        ),
        'bright',
        { far: 110 },
      ),
  },
  'holes and masks': {
    'no data beside specks': () => plain(holes(40, 24), 'veil', { far: 110 }),
    'a mask of zeros, peak': () => plain(masked(40), 'peak', { far: 110 }),
    'surfaces cut by a mask of zeros': () =>
      plain(masked(40), 'bright', { far: 110 }, { style: { lit: true, surfaces, clear: true } }),
    'surfaces of noise': () => plain(noise([20, 20, 20]), 'bright', { far: 55 }, { style: { surfaces, clear: true } }),
    'surfaces of specks': () =>
      plain(specks(), 'bright', { far: 110 }, { style: { lit: true, surfaces, clear: true } }),
    'surfaces in a comb': () =>
      plain(
        byIndex(block, (i) => i % 2),
        'bright',
        { far: 110 },
        { style: { surfaces, clear: true } },
      ),
  },
  'opaque things': {
    'a ball that is opaque at once': () => plain(ball(40, 14, 1), 'opaque', { far: 110 }),
    'a ball with a soft rim': () => plain(ball(40, 14, 12), 'opaque', { far: 110 }),
    specks: () => plain(specks(), 'opaque', { far: 110 }),
    noise: () => plain(noise([24, 24, 24]), 'opaque', { far: 66 }),
    'fog as thick as can be': () =>
      plain(ball(40, 14, 12), 'fog', { far: 110 }, { optics: { referenceLength: 0.001 } }),
    'a ball that is opaque at once, 300 × 300': () =>
      plain(ball(40, 14, 1), 'opaque', { far: 80 }, { size: { width: 300, height: 300 } }),
    'cubes, 240 × 240': () =>
      plain(
        byIndex(block, (...at) => Number(at.every((n) => n % 10 < 5))),
        'opaque',
        { far: 90 },
        { size: { width: 240, height: 240 } },
      ),
    'noise, 200 × 200': () => plain(noise([16, 16, 16]), 'opaque', { far: 40 }, { size: { width: 200, height: 200 } }),
    'a plate, almost from its edge': () =>
      plain(
        byIndex(block, (...at) => Number(at[2] === 20)),
        'opaque',
        { far: 110, phi: Math.PI / 2 - 0.01 },
      ),
  },
  'cuts and parts': {
    'a plane through specks': () => {
      const volume = specks();
      return plain(
        volume,
        'bright',
        { far: 110 },
        {
          set: (gpu) =>
            changePlan(gpu, {
              slices: [],
              cuts: [{ create: createClip, items: [keep(volume.grid, [0.3, 1, 0.2], 0.3)] }],
            }),
        },
      );
    },
    'a corner cut out of noise': () => {
      const volume = noise(block);
      return plain(
        volume,
        'peak',
        { far: 110 },
        {
          set: (gpu) =>
            changePlan(gpu, {
              slices: [],
              cuts: [{ create: createCutout, items: [cutBox(volume.grid, [-1.3, 0.4, 0], [40, 40, 40])] }],
            }),
        },
      );
    },
    'all of it cut away': () => {
      const volume = specks();
      return plain(
        volume,
        'bright',
        { far: 110 },
        {
          set: (gpu) =>
            changePlan(gpu, {
              slices: [],
              cuts: [{ create: createClip, items: [keep(volume.grid, [0, 0, 1], 19.99)] }],
            }),
        },
      );
    },
    'a thin slab': () => {
      const volume = specks();
      const items = [keep(volume.grid, [0, 0, 1], 0.1), keep(volume.grid, [0, 0, -1], -0.4)];
      return plain(
        volume,
        'bright',
        { far: 110 },
        {
          size: { width: 400, height: 400 },
          set: (gpu) => changePlan(gpu, { slices: [], cuts: [{ create: createClip, items }] }),
        },
      );
    },
    'a part of noise': () => {
      const volume = noise(block);
      return plain(
        volume,
        'fog',
        { far: 110 },
        { set: (gpu) => changePlan(gpu, { region: cutRegion(volume.grid, [-3.3, -5.1, -2.2, 4.4, 1.7, 6.1]) }) },
      );
    },
    'a part far smaller than the picture': () => {
      const volume = specks();
      return plain(
        volume,
        'veil',
        { far: 110 },
        {
          size: { width: 400, height: 400 },
          set: (gpu) => changePlan(gpu, { region: cutRegion(volume.grid, [15.3, 15.1, 15.2, 16.4, 16.7, 16.1]) }),
        },
      );
    },
    'a label of one voxel': () => {
      const volume = byIndex(block, () => 0.6);
      const [i, j, k] = [22, 19, 23];
      const map = labelMap(block, (...at) => Number(at[0] === i && at[1] === j && at[2] === k), 2);
      return plain(
        volume,
        'bright',
        { far: 110 },
        {
          size: { width: 400, height: 400 },
          set: (gpu) => gpu.setLabels({ map, styles: [{ ...plainAppearance, opacityFactor: 0 }, plainAppearance] }),
        },
      );
    },
  },
  'styles, light, second fields': {
    'lit specks': () => plain(specks(), 'bright', { far: 110 }, { style: { lit: true } }),
    'lit noise': () => plain(noise([24, 24, 24]), 'fog', { far: 66 }, { style: { lit: true } }),
    'lit comb': () =>
      plain(
        byIndex(block, (i) => i % 2),
        'peak',
        { far: 110 },
        { style: { lit: true } },
      ),
    'boundaries of specks': () =>
      plain(specks(), 'bright', { far: 110 }, { style: { styles: [{ weight: 1, styles: [boundary] }] } }),
    'silhouettes of noise': () =>
      plain(noise([24, 24, 24]), 'fog', { far: 66 }, { style: { styles: [{ weight: 1, styles: [silhouette] }] } }),
    'a peak of a thousandth in noise': () => plain(noise([24, 24, 24]), 'thin', { far: 66 }),
    'a peak of a thousandth on a slope': () =>
      plain(
        byIndex(block, (i, j, k) => (i + 0.4 * j + 0.2 * k) / 64, { kind: 'float32' }),
        'thin',
        { far: 110 },
      ),
    'a second field ten times as fine': () => {
      const volume = byIndex(cubeOf(12), () => 0.1);
      const fine = cubeOf(96);
      const other = withVoxels(fine, scatter(fine, 40), { indexToWorld: askew(volume, fine, 0.85) });
      const overlay = overlayOf(volume, other, {
        transferFunction: parseTransferFunction(looks.bright, [0, 1]),
        opacityFactor: 12,
      });
      return plain(volume, 'bright', { far: 30 }, { overlay });
    },
    'value and gradient of specks': () =>
      plain(
        specks(),
        'bright',
        { far: 110 },
        { style: { patches: [band] }, transferFunction: outlinePatches([band], [0, 1]) },
      ),
    'specks of a second field where nothing is': () => {
      const volume = byIndex(block, () => 0.1);
      const fine = cubeOf(64);
      const places = scatter(fine, 12);
      const other = withVoxels(fine, places, { indexToWorld: askew(volume, fine, 0.85) });
      const overlay = overlayOf(volume, other, {
        transferFunction: parseTransferFunction(looks.bright, [0, 1]),
        opacityFactor: 4,
      });
      return plain(volume, 'bright', { far: 110 }, { overlay });
    },
  },
  'fixed steps': {
    'specks, 20 steps': () => plain(specks(), 'bright', { far: 110 }, { steps: 20 }),
    'specks in a veil, 30 steps': () =>
      plain(withVoxels(block, scatter(block, 24), { around: 0.05 }), 'veil', { far: 110 }, { steps: 30 }),
    'noise, 10 steps': () => plain(noise(block), 'peak', { far: 110 }, { steps: 10 }),
    'an opaque ball, 25 steps': () => plain(ball(40, 14, 1), 'opaque', { far: 110 }, { steps: 25 }),
    'a plate, 7 steps': () =>
      plain(
        byIndex(block, (...at) => Number(at[2] === 20)),
        'bright',
        { far: 110, phi: 0.3 },
        { steps: 7 },
      ),
    'two voxels, 400 × 400, 40 steps': () =>
      plain(withVoxels(cubeOf(64), farApart), 'bright', { far: 220 }, { size: { width: 400, height: 400 }, steps: 40 }),
  },
  projections: {
    'the largest, one voxel': () =>
      plain(withVoxels(block, [[20, 21, 18]]), 'bright', { far: 110 }, { style: { projection: 'max' } }),
    'the largest, specks, 400 × 400': () =>
      plain(specks(), 'bright', { far: 150 }, { style: { projection: 'max' }, size: { width: 400, height: 400 } }),
    'the largest of noise': () => plain(noise(block), 'peak', { far: 110 }, { style: { projection: 'max' } }),
    'the smallest, one voxel': () =>
      plain(
        withVoxels(block, [[20, 21, 18]], { value: 0, around: 1 }),
        'bright',
        { far: 110 },
        { style: { projection: 'min' } },
      ),
    'the mean of specks': () => plain(specks(), 'veil', { far: 110 }, { style: { projection: 'average' } }),
    'the mean of noise through a narrow peak': () =>
      plain(noise(block), 'peak', { far: 110 }, { style: { projection: 'average' } }),
    'the largest of a comb': () =>
      plain(
        byIndex(block, (i) => i % 2),
        'bright',
        { far: 110 },
        { style: { projection: 'max' } },
      ),
  },
  radar: {
    'a huge first gate': () => plain(farGates(), 'bright', { far: 250_000 }, { optics: { referenceLength: 2000 } }),
    'a huge first gate, 600 × 600': () =>
      plain(
        farGates(),
        'bright',
        { far: 500_000 },
        { optics: { referenceLength: 2000 }, size: { width: 600, height: 600 } },
      ),
    'in the eye of it': () =>
      plain(farGates(), 'bright', { far: 100 }, { optics: { referenceLength: 2000 }, ...outOfSight }),
  },
  'odd pictures': {
    '4 × 4': () => plain(specks(), 'bright', { far: 110 }, { size: { width: 4, height: 4 } }),
    '1 × 1': () => plain(noise(block), 'fog', { far: 110 }, { size: { width: 1, height: 1 } }),
    '400 × 5': () => plain(noise(block), 'peak', { far: 110 }, { size: { width: 400, height: 5 } }),
    '5 × 700': () => plain(specks(), 'bright', { far: 110 }, { size: { width: 5, height: 700 } }),
    'from very far': () => plain(noise(block), 'bright', { far: 20_000 }),
    'through a pinhole': () => plain(specks(), 'bright', { far: 2000, angle: 0.001 }),
    'all around': () => plain(specks(), 'bright', { far: 30, angle: 3 }),
  },
  'what is asked': {
    'max-error 8 of specks': () => plain(specks(), 'bright', { far: 110 }, { maxError: 8 }),
    'max-error 8 of noise': () => plain(noise(block), 'peak', { far: 110 }, { maxError: 8 }),
    'max-error 0.4 of specks': () => plain(specks(), 'bright', { far: 110 }, { maxError: 0.4 }),
    'max-error 0.1 of noise': () => plain(noise(block), 'fog', { far: 110 }, { maxError: 0.1 }),
    'the default colours in the widest window': () => {
      const window = [-1e38, 1e38] as const;
      return plain(
        noise(block, 3, { kind: 'float32', slope: 2e38, intercept: -1e38 }),
        'fog',
        { far: 110 },
        { transferFunction: buildDefaultPreset(window) },
      );
    },
  },
};

/** All scenes, in their order. */
export const hardScenes: readonly HardScene[] = Object.entries(kinds).flatMap(([kind, scenes]) =>
  Object.entries(scenes).map(([name, make]) => ({ kind, name, make })),
);
