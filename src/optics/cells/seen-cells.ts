import type { Macrocells } from '../../volume/macrocells.ts';
import type { Contribution } from './empty-space-distance.ts';

/**
 * In which macrocells something is visible.
 * @param contributions - a value is visible if all of them let it through
 * @param slope - data value = slope * stored value + intercept
 * @returns a byte per cell, i fastest: 1 if something is visible, else 0
 */
export function findSeenCells(
  { low, high }: Macrocells,
  contributions: readonly Contribution[],
  { slope, intercept }: { slope: number; intercept: number },
): Uint8Array<ArrayBuffer> {
  return Uint8Array.from(low, (min, cell) => {
    if (!(min <= high[cell])) return 0; // no data
    const a = slope * min + intercept;
    const b = slope * high[cell] + intercept;
    return Number(contributions.every((shows) => shows(Math.min(a, b), Math.max(a, b), cell)));
  });
}
