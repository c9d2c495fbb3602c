import type { Macrocells } from '../../volume/macrocells.ts';
import type { Contribution } from './empty-space-distance.ts';

/**
 * In which macrocells something can be seen.
 * @param contributions - values show that all of them let through
 * @param slope - data value = slope * stored value + intercept
 * @returns a byte a cell, i fastest: 1 where something can, else 0
 */
export function findSeenCells(
  { low, high }: Macrocells, contributions: readonly Contribution[], { slope, intercept }: { slope: number; intercept: number },
): Uint8Array<ArrayBuffer> {
  return Uint8Array.from(low, (least, cell) => {
    if (!(least <= high[cell])) return 0; // no data
    const a = slope * least + intercept;
    const b = slope * high[cell] + intercept;
    return Number(contributions.every((shows) => shows(Math.min(a, b), Math.max(a, b), cell)));
  });
}
