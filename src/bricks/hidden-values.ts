import type { Vector3 } from '../volume/matrix.ts';
import { blockFinder } from './resident-field.ts';
import type { ResidualTable } from './residuals.ts';

/** What is known of the values that the levels of a pyramid hide, block by block, in stored values. */
export interface HiddenValues {
  /** The block at a place of the unit cube. */
  blockAt(x: number, y: number, z: number): number;
  /** Root of the mean square, and the largest, of the differences between a level and level 0. */
  rms(block: number, level: number): number;
  max(block: number, level: number): number;
  /** Smallest and largest value of a block; low > high where it has no data. */
  low(block: number): number;
  high(block: number): number;
}

/** As a table says it that lies next to the pyramid. @param dimensions - of level 0 */
export function hiddenByTable({ side, low, high, levels }: ResidualTable, dimensions: Vector3): HiddenValues {
  return {
    blockAt: blockFinder(dimensions, side),
    rms: (block, level) => levels[level].rms[block],
    max: (block, level) => levels[level].max[block],
    low: (block) => low[block],
    high: (block) => high[block],
  };
}
