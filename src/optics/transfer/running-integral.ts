import { domainOf, emission, meanOverSpan } from './emission.ts';
import type { Premultiplied, TransferFunction } from './transfer-function.ts';

/** The integral of a transfer function's emission from the low end of its domain, at the edges of equal cells. */
export interface RunningIntegral {
  /** Shape [cells + 1, 4]: extinction times colour, and extinction, per reference length, times cells. */
  readonly sums: Float64Array;
  readonly cells: number;
  /** The domain, in data values. */
  readonly low: number;
  readonly high: number;
  /** The emission of all values below and above the domain. */
  readonly first: Premultiplied;
  readonly last: Premultiplied;
}

/**
 * Integrates a transfer function's emission over its domain.
 * @throws {RangeError} if the transfer function has no stop
 */
export function integrateEmission(transferFunction: TransferFunction, cells: number): RunningIntegral {
  if (transferFunction.length === 0) throw new RangeError('integrateEmission got no stop; expected 1 or more');
  const [low, high] = domainOf(transferFunction);
  // If all stops have one value, the domain is a neighbourhood of it and lies wholly to its right, as the value itself does.
  const single = transferFunction[0].value === transferFunction[transferFunction.length - 1].value;
  const within = single ? transferFunction.slice(-1) : transferFunction;
  const sums = new Float64Array((cells + 1) * 4);
  const edge = (cell: number): number => low + ((high - low) * cell) / cells;
  for (let cell = 0; cell < cells; cell++) {
    const mean = meanOverSpan(within, edge(cell), edge(cell + 1));
    for (let c = 0; c < 4; c++) sums[cell * 4 + 4 + c] = sums[cell * 4 + c] + mean[c];
  }
  return {
    sums,
    cells,
    low,
    high,
    first: emission(transferFunction, -Infinity),
    last: emission(transferFunction, Infinity),
  };
}

/** The sum up to any position, in cells. Beyond the ends it continues as in the last cell, so it ignores a jump there. */
export function sumUpTo({ sums, cells }: RunningIntegral, cell: number, c: number): number {
  const low = Math.min(cells - 1, Math.max(0, Math.floor(cell)));
  const from = sums[low * 4 + c];
  return from + (cell - low) * (sums[low * 4 + 4 + c] - from);
}

/** The sum up to any position, in cells. Beyond the ends it continues with the emission there. */
export function sumUpToBeyond(integral: RunningIntegral, cell: number, c: number): number {
  const { cells, first, last } = integral;
  const inside = Math.min(cells, Math.max(0, cell));
  return sumUpTo(integral, inside, c) + Math.min(0, cell) * first[c] + Math.max(0, cell - cells) * last[c];
}
