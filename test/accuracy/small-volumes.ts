import type { Vector3 } from '../../src/volume/matrix.ts';
import { randomNumbers } from '../helpers/synthetic.ts';
import { drawText } from './draw-text.ts';
import { smoothNoise, VoxelBlock } from './voxel-block.ts';

/** A volume with known small things in it, and the same without them. */
export interface SmallVolume {
  readonly block: VoxelBlock;
  readonly bare: VoxelBlock;
  /** Where the things are, in voxel indices. */
  readonly places: readonly Vector3[];
}

/** For bright things in a veil, and for such in empty space: stops over the bytes. */
export const smallFunctions = {
  veil: '0 #247 0, 20 #247 0, 40 #247 0.6%, 120 #247 0.6%, 180 #fd8 60%, 255 #fd8 60%',
  solid: '0 #fd8 0, 100 #fd8 0, 180 #fd8 60%, 255 #fd8 60%',
};

/** Of the veil, and of what is bright. */
export const veilValue = 60;
const brightValue = 220;

/** One-voxel specks, or balls, at random places of a medium. */
export function scatter(edge: number, medium: number, count: number, radius: number): SmallVolume {
  const random = randomNumbers(edge + count);
  const bare = new VoxelBlock(edge, medium);
  const block = bare.copy();
  const place = (): number => 4 + Math.floor(random() * (edge - 8));
  const places = Array.from({ length: count }, (): Vector3 => [place(), place(), place()]);
  for (const center of places) {
    paintBall(block, center, radius, () => brightValue);
  }
  return { block, bare, places };
}

/** A ball of a radius in voxels, its rim by the share that is covered; one voxel where the radius is 0. */
function paintBall(block: VoxelBlock, [i, j, k]: Vector3, radius: number, value: () => number): void {
  const inside = value();
  const max = Math.ceil(radius);
  for (let c = -max; c <= max; c++) {
    for (let b = -max; b <= max; b++) {
      for (let a = -max; a <= max; a++) {
        const share = Math.min(1, Math.max(0, radius === 0 ? 1 : radius + 0.5 - Math.hypot(a, b, c)));
        const place: Vector3 = [i + a, j + b, k + c];
        const before = block.get(place);
        if (share > 0) block.set(place, Math.round(before + share * (inside - before)));
      }
    }
  }
}

/** Balls of radius 2 that are a little denser than what is around them. */
export function makeLesions(): SmallVolume {
  const edge = 64;
  const random = randomNumbers(7);
  const tissue = smoothNoise(edge, 16, random);
  const bare = new VoxelBlock(edge, (i, j, k) =>
    Math.hypot(i - 31.5, j - 31.5, k - 31.5) < 28 ? 80 + 40 * tissue(i, j, k) : 0,
  );
  const block = bare.copy();
  const places = Array.from({ length: 30 }, (): Vector3 => {
    const [theta, z, r] = [random() * 2 * Math.PI, 2 * random() - 1, 12 + 12 * random()];
    const across = Math.sqrt(1 - z * z);
    return [32 + r * across * Math.cos(theta), 32 + r * across * Math.sin(theta), 32 + r * z].map(
      Math.round,
    ) as unknown as Vector3;
  });
  for (const place of places) paintBall(block, place, 2, () => block.get(place) + 30);
  return { block, bare, places };
}

/** Straight lines of single voxels in random directions; looked at every few voxels. */
export function makeWires(edge: number, count: number): SmallVolume {
  const random = randomNumbers(11);
  const bare = new VoxelBlock(edge);
  const block = bare.copy();
  const places: Vector3[] = [];
  const end = (): Vector3 => [0, 1, 2].map(() => 6 + random() * (edge - 12)) as unknown as Vector3;
  for (let wire = 0; wire < count; wire++) {
    const [from, to] = [end(), end()];
    const steps = Math.ceil(Math.max(...from.map((x, axis) => Math.abs(x - to[axis]))));
    for (let s = 0; s <= steps; s++) {
      const place = from.map((x, axis) => Math.round(x + ((to[axis] - x) * s) / steps)) as unknown as Vector3;
      block.set(place, brightValue);
      if (s % 12 === 6) places.push(place);
    }
  }
  return { block, bare, places };
}

/** A plane of so many voxels across the whole volume, looked at every few voxels. */
export function makePlate(edge: number, thick: number, every: number): SmallVolume {
  const low = edge / 2;
  const block = new VoxelBlock(edge, (_i, _j, k) => (k >= low && k < low + thick ? brightValue : 0));
  const places: Vector3[] = [];
  for (let j = every; j < edge - 2; j += every)
    for (let i = every; i < edge - 2; i += every) places.push([i, j, low + (thick - 1) / 2]);
  return { block, bare: new VoxelBlock(edge), places };
}

/** A pattern on a plate of two voxels; without it the plate has the value in the middle. */
function makePattern(
  edge: number,
  value: (i: number, j: number) => number,
  places: readonly (readonly [number, number])[],
): SmallVolume {
  const low = edge / 2 - 1;
  const plate = (paint: (i: number, j: number) => number): VoxelBlock =>
    new VoxelBlock(edge, (i, j, k) => (k === low || k === low + 1 ? paint(i, j) : 0));
  return { block: plate(value), bare: plate(() => 130), places: places.map(([i, j]) => [i, j, low + 0.5]) };
}

/** Four bands of waves along i, 2, 3, 4 and 8 voxels long; looked at crests. */
export function makeWaves(edge: number): SmallVolume {
  const lengths = [2, 3, 4, 8];
  const bandOf = (j: number): number => Math.min(3, Math.floor((4 * j) / edge));
  const places = lengths.flatMap((length, band) =>
    [0.25, 0.5, 0.75].map((share): [number, number] => [
      Math.round((share * edge) / length) * length,
      Math.round(((band + 0.5) * edge) / 4),
    ]),
  );
  return makePattern(edge, (i, j) => 130 + 100 * Math.cos((2 * Math.PI * i) / lengths[bandOf(j)]), places);
}

export function makeChecker(edge: number): SmallVolume {
  const places = Array.from({ length: 36 }, (_, n): [number, number] => [
    6.5 + 10 * (n % 6),
    6.5 + 10 * Math.floor(n / 6),
  ]);
  return makePattern(
    edge,
    (i, j) => (((i >> 1) + (j >> 1)) % 2 ? 220 : 40),
    places.filter(([i, j]) => i < edge - 4 && j < edge - 4),
  );
}

/** Blobs of a smooth map that rise above a threshold; without them it stays below. */
export function makeMap(edge: number): SmallVolume {
  const noise = smoothNoise(edge, 4, randomNumbers(23));
  const block = new VoxelBlock(edge, (i, j, k) => Math.min(255, Math.max(0, 100 + 360 * (noise(i, j, k) - 0.5))));
  const bare = block.copy();
  bare.paint((i, j, k) => Math.min(149, block.get([i, j, k])));
  const places: Vector3[] = [];
  for (let k = 1; k < edge - 1; k++)
    for (let j = 1; j < edge - 1; j++)
      for (let i = 1; i < edge - 1; i++) {
        const value = block.get([i, j, k]);
        const around = [
          [1, 0, 0],
          [-1, 0, 0],
          [0, 1, 0],
          [0, -1, 0],
          [0, 0, 1],
          [0, 0, -1],
        ];
        if (value > 152 && around.every(([a, b, c]) => block.get([i + a, j + b, k + c]) < value))
          places.push([i, j, k]);
      }
  const fromMiddle = (place: Vector3): number => Math.hypot(...place.map((n) => n - edge / 2));
  places.sort((a, b) => fromMiddle(a) - fromMiddle(b));
  return { block, bare, places: places.slice(0, 60) };
}

/** Shells of about one voxel around the middle; looked at in many directions. */
export function makeShells(edge: number): SmallVolume {
  const middle = (edge - 1) / 2;
  const radii = [0.2, 0.32, 0.44].map((share) => share * edge);
  const block = new VoxelBlock(edge, (i, j, k) => {
    const r = Math.hypot(i - middle, j - middle, k - middle);
    return 220 * Math.max(...radii.map((radius) => Math.exp(-(((r - radius) * 1.5) ** 2))));
  });
  const random = randomNumbers(3);
  const places = radii.flatMap((radius) =>
    Array.from({ length: 16 }, (): Vector3 => {
      const [angle, z] = [random() * 2 * Math.PI, 2 * random() - 1];
      const across = Math.sqrt(1 - z * z);
      return [
        middle + radius * across * Math.cos(angle),
        middle + radius * across * Math.sin(angle),
        middle + radius * z,
      ];
    }),
  );
  return { block, bare: new VoxelBlock(edge), places };
}

export function makeText(edge: number): SmallVolume {
  const bare = new VoxelBlock(edge);
  const block = bare.copy();
  const places = drawText(edge).map(([i, j]): Vector3 => [i, j, edge / 2]);
  for (const place of places) block.set(place, brightValue);
  return { block, bare, places: places.filter((_, n) => n % 6 === 0) };
}

/** A plane of crossing bars of one voxel, looked at between the crossings. */
export function makeMesh(edge: number): SmallVolume {
  const block = new VoxelBlock(edge, (i, j, k) => (k === edge / 2 && (i % 6 === 3 || j % 6 === 3) ? brightValue : 0));
  const places: Vector3[] = [];
  for (let j = 3; j < edge - 6; j += 12)
    for (let i = 3; i < edge - 6; i += 12) places.push([i + 3, j, edge / 2], [i, j + 3, edge / 2]);
  return { block, bare: new VoxelBlock(edge), places };
}
