import type { Samples } from '../volume/samples.ts';
import { brickSide } from './brick-data.ts';
import { brickHalo, slotSide } from './brick-layout.ts';

/** Voxels along each edge of a block. */
export const blockSide = 8;

/** Blocks along each edge of a brick. */
export const blocksAlong = brickSide / blockSide;

/** What the blocks of a brick have, x fastest: as the macrocells of a volume. */
export interface BlockRanges {
  /** Smallest and largest stored value that interpolation can give in a block; low > high where none has data. */
  readonly low: Float64Array;
  readonly high: Float64Array;
  /** The largest second difference along any axis, or more; stored units. See volume/macrocells.ts */
  readonly roughness: Float64Array;
}

/** @param samples - of a brick with its halo, see `BrickSamples` */
export function measureBlocks(samples: Samples): BlockRanges {
  return {
    low: foldBlocks(samples, smaller, Infinity),
    high: foldBlocks(samples, larger, -Infinity),
    roughness: foldBlocks(secondDifferences(samples), larger, 0),
  };
}

// Comparisons with NaN are false: places without data change nothing.
const smaller = (least: number, value: number): number => (value < least ? value : least);
const larger = (most: number, value: number): number => (value > most ? value : most);

/** Of each voxel, the largest along any axis along which it has both neighbours; 0 where one of them has no data. */
function secondDifferences(samples: Samples): Float32Array {
  const found = new Float32Array(samples.length);
  const [row, slice] = [slotSide, slotSide ** 2];
  const last = slotSide - 1;
  for (let k = 0, at = 0; k < slotSide; k++)
    for (let j = 0; j < slotSide; j++)
      for (let i = 0; i < slotSide; i++, at++) {
        const twice = 2 * samples[at];
        let most = 0;
        if (i > 0 && i < last) most = larger(most, Math.abs(samples[at - 1] - twice + samples[at + 1]));
        if (j > 0 && j < last) most = larger(most, Math.abs(samples[at - row] - twice + samples[at + row]));
        if (k > 0 && k < last) most = larger(most, Math.abs(samples[at - slice] - twice + samples[at + slice]));
        found[at] = most;
      }
  return found;
}

/** Folds the voxels of each block and those next to it: along x, then y, then z. */
function foldBlocks(values: ArrayLike<number>, fold: (a: number, b: number) => number, none: number): Float64Array {
  let lines = values;
  for (let axis = 0, length = slotSide ** 2; axis < 3; axis++, length = (length / slotSide) * blocksAlong) {
    // The folded axis becomes the slowest one: after three turns the order is that of the voxels again.
    const folded = new Float64Array(length * blocksAlong);
    for (let line = 0; line < length; line++)
      for (let block = 0; block < blocksAlong; block++) {
        let all = none;
        const first = slotSide * line + blockSide * block;
        for (let at = first; at < first + blockSide + 2 * brickHalo; at++) all = fold(all, lines[at]);
        folded[line + length * block] = all;
      }
    lines = folded;
  }
  return lines as Float64Array;
}
