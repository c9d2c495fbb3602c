// Scenes in which the rays that pictures at rest need are counted: of people, of weather, of small things, and made to break the choice of rays.
import { transformPoint } from '../../src/volume/matrix.ts';
import type { Vector3 } from '../../src/volume/matrix.ts';
import type { Volume } from '../../src/volume/volume.ts';
import { randomNumbers } from '../helpers/synthetic.ts';
import { loadHere } from './small-page.ts';
import { smallScenes } from './small-scenes.ts';
import { VoxelBlock } from './voxel-block.ts';

/** What a scene shows. */
export interface Counted {
  readonly volume: Volume;
  /** The same without its small things; null where none are known. */
  readonly bare: Volume | null;
  /** Of the things, world. */
  readonly places: readonly Vector3[];
}

export interface CountScene {
  readonly name: string;
  /** The attribute; null for the default. */
  readonly transferFunction: string | null;
  /** Degrees. */
  readonly theta: number;
  readonly phi: number;
  /** Around a place its thing is looked for, voxels. */
  readonly reach: number;
  /** How many times as dense a scan is that is lit, as by default; absent without light. */
  readonly litFactor?: number;
  readonly make: () => Promise<Counted>;
}

const real = (name: string, file: string, transferFunction: string | null, litFactor?: number): CountScene => ({
  name,
  transferFunction,
  theta: 30,
  phi: 75,
  reach: 0,
  litFactor,
  make: async () => ({ volume: await loadHere(`/demos/data/${file}.nii.gz`), bare: null, places: [] }),
});

const small = (name: string): CountScene => {
  const { view, reach, transferFunction, make } = smallScenes.find((one) => one.name.startsWith(name))!;
  return {
    name,
    transferFunction,
    theta: view.theta,
    phi: view.phi,
    reach,
    make: () => {
      const { block, bare, places } = make();
      return Promise.resolve(countedOf(block, bare, places));
    },
  };
};

function countedOf(block: VoxelBlock, bare: VoxelBlock, places: readonly Vector3[]): Counted {
  const volume = block.toVolume();
  return {
    volume,
    bare: bare.toVolume(),
    places: places.map((place) => transformPoint(volume.grid.indexToWorld, place)),
  };
}

const edge = 48;
const middle = edge / 2;

/** Places on a plane in the middle, so many voxels apart. */
const grid = (count: number, apart: number): Vector3[] =>
  Array.from({ length: count ** 2 }, (_, n) => [
    middle + apart * ((n % count) - Math.floor(count / 2)),
    middle,
    middle + apart * (Math.floor(n / count) - Math.floor(count / 2)),
  ]);

/** A scene that was made to break the choice of rays. */
interface MadeScene extends Pick<CountScene, 'name' | 'transferFunction'> {
  /** Degrees. */
  readonly sight: readonly [theta: number, phi: number];
}

const made = (
  { name, transferFunction, sight: [theta, phi] }: MadeScene,
  value: (i: number, j: number, k: number) => number,
  places: readonly Vector3[] = [],
): CountScene => ({
  name,
  transferFunction,
  theta,
  phi,
  reach: 1,
  make: () => Promise.resolve(countedOf(new VoxelBlock(edge, value), new VoxelBlock(edge), places)),
});

const isSpeck = new Set(grid(8, 3).map(String));
const random = randomNumbers(5);
const noise = Float64Array.from({ length: edge ** 3 }, () => 255 * random());
const noiseAt = (i: number, j: number, k: number): number => noise[i + edge * (j + edge * k)];
const toMiddle = (i: number, j: number, k: number): number => Math.hypot(i - 23.5, j - 23.5, k - 23.5);

/** Only the tips of single voxels of 200 are seen. */
const tips = (opacity: string): string => `0 #fd8 0, 190 #fd8 0, 190 #fd8 ${opacity}, 255 #fd8 ${opacity}`;

export const countScenes: readonly CountScene[] = [
  real('MRI of a brain', 'mni152-t1', null),
  real('MRI of a brain, lit', 'mni152-t1', null, 6),
  real('CT phantom, bone', 'ct-phantom', 'ct-bone'),
  real('CT phantom, bone, lit', 'ct-phantom', 'ct-bone', 3),
  real('CT phantom, soft tissue', 'ct-phantom', 'ct-soft-tissue'),
  real('Storm', 'storm-synthetic', 'radar-dbz'),
  ...['Specks of 1 voxel in a veil, large', 'Lesions', 'Wires', 'Plate of 1 voxel, almost', 'Threshold', 'Shells'].map(
    small,
  ),
  made(
    { name: 'Tips of specks', transferFunction: tips('60%'), sight: [20, 80] },
    (...at) => (isSpeck.has(String(at)) ? 200 : 0),
    grid(8, 3),
  ),
  made(
    { name: 'Tips of a plate from its edge', transferFunction: tips('3%'), sight: [0, 90] },
    (i) => (i === middle ? 200 : 0),
    grid(3, 4).slice(3, 6),
  ),
  made(
    { name: 'Tips of wires from their ends', transferFunction: tips('3%'), sight: [0, 90] },
    (i, _j, k) => (i % 4 === 0 && k % 4 === 0 ? 200 : 0),
    grid(6, 4),
  ),
  made(
    {
      name: 'Thin shell of a ball',
      transferFunction: '0 #fd8 0, 190 #fd8 0, 191 #fd8 20%, 192 #fd8 0, 255 #fd8 0',
      sight: [40, 70],
    },
    (...at) => 255 * Math.max(0, 1 - toMiddle(...at) / 24),
  ),
  made(
    { name: 'Noise', transferFunction: '0 #234 0, 30 #48c 2%, 140 #c96 5%, 255 white 10%', sight: [40, 70] },
    noiseAt,
  ),
  made(
    {
      name: 'Noise through a peak',
      transferFunction: '0 #fd8 0, 190 #fd8 0, 200 #fd8 20%, 210 #fd8 0, 255 #fd8 0',
      sight: [40, 70],
    },
    noiseAt,
  ),
];
