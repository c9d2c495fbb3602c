import type { Samples } from '../volume/samples.ts';
import { brickHalo, brickReach, brickSide, slotSide } from './brick-data.ts';

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

/** Voxels along each edge of a block, with those next to it. */
const span = blockSide + 2 * brickReach;

/** The same of a brick, and the first of them in its slot. */
const side = brickSide + 2 * brickReach;
const begin = brickHalo - brickReach;

/** @param samples - of a brick with its halo, see `BrickSamples` */
export function measureBlocks(samples: Samples): BlockRanges {
  // Of each line along x, by block: what its voxels in that block have. Then the lines of each block.
  const [low, high, roughness] = [0, 1, 2].map(() => new Float32Array(blocksAlong * side ** 2));
  const rough = new Float32Array(side);
  for (let k = 0, to = 0; k < side; k++)
    for (let j = 0; j < side; j++) {
      const line = begin + slotSide * (begin + j + slotSide * (begin + k));
      measureLine(samples, line, rough);
      for (let block = 0; block < blocksAlong; block++, to++) {
        let [least, most, roughest] = [Infinity, -Infinity, 0];
        const first = blockSide * block;
        for (let i = first, at = line + first; i < first + span; i++, at++) {
          const value = samples[at];
          // Comparisons with NaN are false: places without data change nothing.
          if (value < least) least = value;
          if (value > most) most = value;
          if (rough[i] > roughest) roughest = rough[i];
        }
        [low[to], high[to], roughness[to]] = [least, most, roughest];
      }
    }
  return {
    low: foldLines(low, -1, Infinity),
    high: foldLines(high, 1, -Infinity),
    roughness: foldLines(roughness, 1, 0),
  };
}

/** The second differences of the voxels of a line along x: the largest along any axis; 0 where a neighbour has no data. @param line - its first voxel */
function measureLine(samples: Samples, line: number, into: Float32Array): void {
  const [row, slice] = [slotSide, slotSide ** 2];
  for (let i = 0, at = line; i < side; i++, at++) {
    const twice = 2 * samples[at];
    const alongX = Math.abs(samples[at - 1] - twice + samples[at + 1]);
    const alongY = Math.abs(samples[at - row] - twice + samples[at + row]);
    const alongZ = Math.abs(samples[at - slice] - twice + samples[at + slice]);
    let most = 0;
    if (alongX > most) most = alongX;
    if (alongY > most) most = alongY;
    if (alongZ > most) most = alongZ;
    into[i] = most;
  }
}

/** Of each block, the largest (sign 1) or smallest (-1) of what the lines along x have in it. */
function foldLines(lines: Float32Array, sign: 1 | -1, none: number): Float64Array {
  const found = new Float64Array(blocksAlong ** 3);
  for (let block = 0; block < found.length; block++) {
    const [x, y, z] = [
      block % blocksAlong,
      Math.floor(block / blocksAlong) % blocksAlong,
      Math.floor(block / blocksAlong ** 2),
    ];
    let all = none;
    for (let k = blockSide * z; k < blockSide * z + span; k++)
      for (
        let j = blockSide * y, at = x + blocksAlong * (j + side * k);
        j < blockSide * y + span;
        j++, at += blocksAlong
      )
        if (sign * lines[at] > sign * all) all = lines[at];
    found[block] = all;
  }
  return found;
}
