import { mostDigits } from '../messages/language.ts';
import type { Language } from '../messages/language.ts';
import { listTicks } from './ticks.ts';

/** Numbers along a scale. */
export interface TickLabels {
  readonly ticks: readonly { readonly value: number; readonly text: string }[];
  /** What all numbers are to be added to, where only their last digits differ; else empty. */
  readonly offset: string;
}

/** Digits that numbers usually have, and that they have at the most before only differences are written. */
const digits = { usual: 4, most: 7 } as const;

/** So many characters have room where a number is wanted, with the space beside them. */
const room = 6;

/**
 * Numbers of a scale that can be told apart, and have room beside each other.
 * @param most - how many short ones have room, at least 2
 */
export function labelTicks(domain: readonly [number, number], most: number, language: Language): TickLabels {
  for (let count = most; ; count--) {
    const labels = write(listTicks(domain, count), domain, language);
    const longest = Math.max(0, ...labels.ticks.map(({ text }) => text.length));
    if (count <= 2 || labels.ticks.length * (longest + 1) <= most * room) return labels;
  }
}

function write(values: readonly number[], domain: readonly [number, number], language: Language): TickLabels {
  const needed = digitsOfSteps(values);
  if (needed <= digits.most) {
    return { ticks: values.map((value) => ({ value, text: language.number(value, Math.max(digits.usual, needed)) })), offset: '' };
  }
  const base = roundestWithin(domain);
  const apart = values.map((value) => value - base);
  const enough = Math.max(digits.usual, digitsOfSteps(apart));
  return {
    ticks: values.map((value, i) => ({ value, text: language.number(apart[i], enough) })),
    offset: `${language.number(base, mostDigits)} +`,
  };
}

/** Significant digits down to the first one of the distance between values that are spaced evenly. */
function digitsOfSteps(values: readonly number[]): number {
  if (values.length < 2) return 1;
  const largest = Math.max(...values.map(Math.abs));
  return Math.min(mostDigits, 1 + Math.floor(Math.log10(largest)) - Math.floor(Math.log10(Math.abs(values[1] - values[0])) + 1e-9));
}

/** The number between two, of the same sign, that has the fewest digits. */
function roundestWithin([low, high]: readonly [number, number]): number {
  for (let power = Math.ceil(Math.log10(Math.max(Math.abs(low), Math.abs(high)))); ; power--) {
    const unit = Number(`1e${power}`);
    const base = Math.ceil(low / unit) * unit;
    if (base <= high || unit === 0) return Number(base.toPrecision(mostDigits - 1));
  }
}
