// Whole numbers that float32 rounds: loaded for files of 32-bit and 64-bit numbers.
import { indexNumbers } from '../../volume/index-numbers.ts';
import type { IndexedSamples, Rounded } from '../../volume/index-numbers.ts';
import type { Budget } from './budget.ts';

/** The offset that was chosen, and what is kept or rounded. */
export interface WholeNumbers<T> {
  readonly offset: T;
  readonly indexed?: IndexedSamples;
  readonly rounded?: Rounded;
}

/**
 * For whole numbers that become float32: the offset to subtract so that fewer are rounded, and the numbers that are
 * rounded all the same.
 * @param detail - the offset that suits most of the values that differ little from their neighbours
 * @param of - converts a number to the values' own type
 */
export function chooseWhole<T extends number | bigint>(
  values: ArrayLike<T>,
  detail: T,
  of: (value: number) => T,
  budget?: Budget,
): WholeNumbers<T> {
  const roundedBy = (offset: T): Rounded => {
    let [count, by] = [0, 0];
    for (let i = 0; i < values.length; i++) {
      const apart = subtract(values[i], offset);
      const off = Math.abs(Number(subtract(of(Math.fround(Number(apart))), apart)));
      if (!(off > 0)) continue;
      count++;
      by = Math.max(by, off);
    }
    return { count, by };
  };
  const shifted = roundedBy(detail);
  const usual = shifted.count === 0 ? shifted : roundedBy(of(0));
  const [offset, rounded]: readonly [T, Rounded] = shifted.count <= usual.count ? [detail, shifted] : [of(0), usual];
  if (rounded.count === 0) return { offset };
  const indexed = indexNumbers(values, (value) =>
    Number.isNaN(value) || Math.abs(Number(value)) === Infinity ? 0 : Number(value),
  );
  if (!indexed) return { offset, rounded };
  budget?.take(indexed.samples.byteLength, 'the samples');
  return { offset, indexed };
}

/** Subtracts two numbers of one type. */
function subtract<T extends number | bigint>(a: T, b: T): T {
  return ((a as number) - (b as number)) as T;
}
