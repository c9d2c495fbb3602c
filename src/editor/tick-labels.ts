import { maxDigits } from '../messages/language.ts';
import type { Language } from '../messages/language.ts';
import { listTicks } from './ticks.ts';

/** Numbers along a scale. */
export interface TickLabels {
  readonly ticks: readonly { readonly value: number; readonly text: string }[];
  /** The number to which all labels are added, if only their last digits differ; else empty. */
  readonly offset: string;
}

/** The usual number of digits, and the maximum before only differences are written. */
const digits = { usual: 4, max: 7 } as const;

/** The number of characters that fit, with the space around them. */
const room = 6;

/**
 * Labels for numbers of a scale that differ from each other, and fit next to each other.
 * @param maxCount - how many short labels fit, at least 2
 */
export function labelTicks(domain: readonly [number, number], maxCount: number, language: Language): TickLabels {
  for (let count = maxCount; ; count--) {
    const labels = write(listTicks(domain, count), domain, language);
    const longest = Math.max(0, ...labels.ticks.map(({ text }) => text.length));
    if (count <= 2 || labels.ticks.length * (longest + 1) <= maxCount * room) return labels;
  }
}

function write(values: readonly number[], domain: readonly [number, number], language: Language): TickLabels {
  const needed = digitsOfSteps(values);
  if (needed <= digits.max) {
    return {
      ticks: values.map((value) => ({ value, text: language.number(value, Math.max(digits.usual, needed)) })),
      offset: '',
    };
  }
  const base = roundestWithin(domain);
  const apart = values.map((value) => value - base);
  const enough = Math.max(digits.usual, digitsOfSteps(apart));
  return {
    ticks: values.map((value, i) => ({ value, text: language.number(apart[i], enough) })),
    offset: `${language.number(base, maxDigits)} +`,
  };
}

/** Number of significant digits down to the first digit of the distance between evenly spaced values. */
function digitsOfSteps(values: readonly number[]): number {
  if (values.length < 2) return 1;
  const largest = Math.max(...values.map(Math.abs));
  return Math.min(
    maxDigits,
    1 + Math.floor(Math.log10(largest)) - Math.floor(Math.log10(Math.abs(values[1] - values[0])) + 1e-9),
  );
}

/** The number between two of the same sign that has the fewest digits. */
function roundestWithin([low, high]: readonly [number, number]): number {
  for (let power = Math.ceil(Math.log10(Math.max(Math.abs(low), Math.abs(high)))); ; power--) {
    const unit = Number(`1e${power}`);
    const base = Math.ceil(low / unit) * unit;
    if (base <= high || unit === 0) return Number(base.toPrecision(maxDigits - 1));
  }
}
