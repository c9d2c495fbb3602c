import { domainOf, emission as emissionOf } from './emission.ts';
import type { Premultiplied, TransferFunction } from './transfer-function.ts';

/** Bins that values count as apart at least: where in its bin a jump lies is not known, and half of it counts. */
const leastWidth = 2;

/** Equal bins over the domain. */
const bins = 512;

/** Whether any change counts, or what averaging does not even out. */
export type RangeKind = 'among' | 'offLine';

/** Asks how much a transfer function's emission differs among values. */
export interface EmissionRange {
  /**
   * The largest difference of any channel's emission (per reference length, extinction among them) between two values that
   * lie between `low` and `high` and no more than `apart` from each other; rounded up to whole bins. Data units.
   */
  among(low: number, high: number, apart: number): number;
  /** The same of how far it is from a straight line among them: what averaging does not even out. Never more than `among`. */
  offLine(low: number, high: number, apart: number): number;
  /** The largest of any channel's emission among values, rounded up to whole bins. */
  largest(low: number, high: number): number;
}

/** Ranges of powers of two of bins: row n holds, for each bin, the extreme of the 2^n bins from it on. */
type Extremes = readonly Float32Array[];

/**
 * Prepare a transfer function.
 * @param transferFunction - brightened
 * @param emission - what is asked for instead of the emission, for instance what is seen of a length
 */
export function rangeEmission(transferFunction: TransferFunction, emission: (transferFunction: TransferFunction, value: number) => Premultiplied = emissionOf): EmissionRange {
  const [low, high] = domainOf(transferFunction);
  // The width of a bin may be too small to be a number.
  const inBins = (length: number): number => (length / (high - low)) * bins;
  const edges = Array.from({ length: bins + 1 }, (_, i) => emission(transferFunction, low + (i * (high - low)) / bins));
  const before = emission(transferFunction, -Infinity);
  // Of each stop the bin, and what it emits; and what is all but reached on its left: of a jump that is what no value has.
  const seen = transferFunction.map(({ value }, n) => ({
    bin: Math.min(bins - 1, Math.max(0, Math.floor(inBins(value - low)))),
    here: emission(transferFunction, value),
    left: n > 0 && transferFunction[n - 1].value < value ? emission([transferFunction[n]], value) : null,
  }));
  const channels = [0, 1, 2, 3].map((c) => {
    const [least, most] = [new Float32Array(bins), new Float32Array(bins)];
    for (let i = 0; i < bins; i++) {
      least[i] = Math.min(edges[i][c], edges[i + 1][c]);
      most[i] = Math.max(edges[i][c], edges[i + 1][c]);
    }
    include([least, most], 0, before[c]);
    for (const { bin, here, left } of seen) {
      include([least, most], bin, here[c]);
      if (left) include([least, most], bin, left[c]);
    }
    // A bin with a stop in it has no one slope: then its own difference may be anywhere in it.
    const rise = Float32Array.from(least, (_, i) => edges[i + 1][c] - edges[i][c]);
    const [lowest, highest] = [rise.slice(), rise.slice()];
    for (let i = 0; i < bins; i++) {
      const beyond = most[i] - least[i] - Math.abs(rise[i]);
      lowest[i] -= beyond;
      highest[i] += beyond;
    }
    return {
      least: buildExtremes(least, Math.min), most: buildExtremes(most, Math.max),
      lowest: buildExtremes(lowest, Math.min), highest: buildExtremes(highest, Math.max),
    };
  });
  const binOf = (value: number): number => Math.min(bins - 1, Math.max(0, Math.floor(inBins(value - low))));
  type Channel = (typeof channels)[number];
  const difference = ({ least, most }: Channel, first: number, last: number): number =>
    extremeOf(most, first, last, Math.max) - extremeOf(least, first, last, Math.min);
  const bend = ({ lowest, highest }: Channel, first: number, last: number): number =>
    extremeOf(highest, first, last, Math.max) - extremeOf(lowest, first, last, Math.min);
  const differences = new Windows(1, (first, last) => [Math.max(...channels.map((channel) => difference(channel, first, last)))]);
  const differencesAndBends = new Windows(2 * channels.length, (first, last) => channels.flatMap((channel) => [difference(channel, first, last), bend(channel, first, last)]));
  /**
   * The largest of what windows measure that together hold any two values so near to each other.
   * @param parts - windows begin so many to a reach, and are so much wider than it
   * @param measure - of what is known of a window, from where on that is, and how many bins it has
   */
  const largestOf = ([from, to, apart]: readonly [number, number, number], parts: number, windows: Windows, measure: (known: Float64Array, at: number, count: number) => number): number => {
    const [first, last] = [binOf(from), binOf(to)];
    const reach = Math.min(last - first, Math.ceil(inBins(apart)) + 1);
    const step = Math.floor(reach / parts);
    let largest = 0;
    for (let i = first; ; i += Math.max(1, step)) {
      const end = Math.min(last, i + reach + step);
      const known = windows.with(i, end);
      largest = Math.max(largest, measure(known, i * windows.numbers, end - i + 1));
      if (end === last) return largest;
    }
  };
  return {
    largest: (from, to) => Math.max(...channels.map(({ most }) => extremeOf(most, binOf(from), binOf(to), Math.max))),
    among: (...where) => largestOf(where, 8, differences, (known, at) => known[at]),
    // A function whose slope is between two is off its chord by a quarter of their difference, times the width.
    offLine: (...where) => largestOf(where, 2, differencesAndBends, (known, at, count) => {
      const times = Math.max(leastWidth, Math.min(count, inBins(where[2]))) / 4;
      let largest = 0;
      for (let n = at; n < at + 2 * channels.length; n += 2) largest = Math.max(largest, Math.min(known[n], known[n + 1] * times));
      return largest;
    }),
  };
}

/** What windows of bins measure. Thousands of cells ask for the same ones: each is measured once. */
class Windows {
  /** By the number of bins; of each window its numbers, NaN where it was not asked for. */
  readonly #known: Float64Array[] = [];

  /** @param numbers - of each window */
  constructor(readonly numbers: number, readonly measure: (first: number, last: number) => readonly number[]) {}

  /** Those with as many bins, among which that from one to another is known. */
  with(first: number, last: number): Float64Array {
    const known = (this.#known[last - first] ??= new Float64Array(bins * this.numbers).fill(NaN));
    if (Number.isNaN(known[first * this.numbers])) known.set(this.measure(first, last), first * this.numbers);
    return known;
  }
}

function include([least, most]: readonly Float32Array[], bin: number, value: number): void {
  least[bin] = Math.min(least[bin], value);
  most[bin] = Math.max(most[bin], value);
}

function buildExtremes(values: Float32Array, of: (a: number, b: number) => number): Extremes {
  const rows = [values];
  for (let length = 2; length <= bins; length *= 2) {
    const last = rows[rows.length - 1];
    rows.push(Float32Array.from({ length: bins - length + 1 }, (_, i) => of(last[i], last[i + length / 2])));
  }
  return rows;
}

function extremeOf(rows: Extremes, first: number, last: number, of: (a: number, b: number) => number): number {
  const row = Math.floor(Math.log2(last - first + 1));
  return of(rows[row][first], rows[row][last - 2 ** row + 1]);
}
