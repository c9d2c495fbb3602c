import type { Macrocells } from '../../volume/macrocells.ts';

/** A share of the domain that is added to the largest value of a cell: rounding on a GPU may add that much. */
const margin = 1e-4;

/**
 * The largest value that each cell can hold (with sign -1: the smallest), as a share of a domain. It is rounded outward, so that
 * no value of a cell is beyond it.
 * @param toShare - share of the domain = scale * stored value + offset
 * @returns a byte per cell: 0 if it holds no data, else from 1 for the domain's low end to 255 for its high end; with sign
 * -1 the other way round
 */
export function measureCellLimits(
  { low, high }: Macrocells,
  { scale, offset }: { readonly scale: number; readonly offset: number },
  sign: 1 | -1,
): Uint8Array<ArrayBuffer> {
  return Uint8Array.from(low, (min, cell) => {
    if (!(min <= high[cell])) return 0;
    const shares = [scale * min + offset, scale * high[cell] + offset];
    const extreme = sign > 0 ? Math.max(...shares) : 1 - Math.min(...shares);
    return 1 + Math.ceil(254 * Math.min(1, Math.max(0, extreme + margin)));
  });
}
