import { domainOf, emission as emissionOf } from './emission.ts';
import type { Premultiplied, TransferFunction } from './transfer-function.ts';

/** The smallest number of bins that a change is spread over: it is not known where in its bin a jump lies, so half of the jump counts. */
const minWidth = 2;

/** Number of equal bins over the domain. */
const bins = 512;

/** Whether any change counts, or only what averaging does not cancel. */
export type RangeKind = 'among' | 'offLine';

/** How much a transfer function's emission differs among values. */
export interface EmissionRange {
  /**
   * The largest difference of any channel's emission (per reference length; extinction is one channel) between two values that
   * lie between `low` and `high` and differ by at most `apart`. Rounded up to whole bins. Data units.
   */
  among(low: number, high: number, apart: number): number;
  /** The same for the deviation from a straight line between them, which averaging does not cancel. At most `among`. */
  offLine(low: number, high: number, apart: number): number;
  /** The largest emission of any channel among values, rounded up to whole bins. */
  largest(low: number, high: number): number;
}

/** Extremes over powers of two of bins: row n holds, for each bin, the extreme of the 2^n bins that start there. */
type Extremes = readonly Float32Array[];

/**
 * Prepares a transfer function.
 * @param transferFunction - already brightened
 * @param emission - measured instead of the emission, for instance the visible effect of a length
 */
export function rangeEmission(
  transferFunction: TransferFunction,
  emission: (transferFunction: TransferFunction, value: number) => Premultiplied = emissionOf,
): EmissionRange {
  const [low, high] = domainOf(transferFunction);
  // A bin's width may be too small for a float, so divide first.
  const inBins = (length: number): number => (length / (high - low)) * bins;
  const edges = Array.from({ length: bins + 1 }, (_, i) => emission(transferFunction, low + (i * (high - low)) / bins));
  const before = emission(transferFunction, -Infinity);
  // For each stop: its bin, its emission, and the limit of the emission from the left. At a jump, no value has this limit.
  const seen = transferFunction.map(({ value }, n) => ({
    bin: Math.min(bins - 1, Math.max(0, Math.floor(inBins(value - low)))),
    here: emission(transferFunction, value),
    left: n > 0 && transferFunction[n - 1].value < value ? emission([transferFunction[n]], value) : null,
  }));
  const channels = [0, 1, 2, 3].map((c) => {
    const [min, max] = [new Float32Array(bins), new Float32Array(bins)];
    for (let i = 0; i < bins; i++) {
      min[i] = Math.min(edges[i][c], edges[i + 1][c]);
      max[i] = Math.max(edges[i][c], edges[i + 1][c]);
    }
    include([min, max], 0, before[c]);
    for (const { bin, here, left } of seen) {
      include([min, max], bin, here[c]);
      if (left) include([min, max], bin, left[c]);
    }
    // A bin with a stop in it has no single slope: its additional difference may occur anywhere in it.
    const rise = Float32Array.from(min, (_, i) => edges[i + 1][c] - edges[i][c]);
    const [lowest, highest] = [rise.slice(), rise.slice()];
    for (let i = 0; i < bins; i++) {
      const beyond = max[i] - min[i] - Math.abs(rise[i]);
      lowest[i] -= beyond;
      highest[i] += beyond;
    }
    return {
      min: buildExtremes(min, Math.min),
      max: buildExtremes(max, Math.max),
      lowest: buildExtremes(lowest, Math.min),
      highest: buildExtremes(highest, Math.max),
    };
  });
  const binOf = (value: number): number => Math.min(bins - 1, Math.max(0, Math.floor(inBins(value - low))));
  type Channel = (typeof channels)[number];
  const difference = ({ min, max }: Channel, first: number, last: number): number =>
    extremeOf(max, first, last, Math.max) - extremeOf(min, first, last, Math.min);
  const bend = ({ lowest, highest }: Channel, first: number, last: number): number =>
    extremeOf(highest, first, last, Math.max) - extremeOf(lowest, first, last, Math.min);
  const differences = new Windows(1, (first, last) => [
    Math.max(...channels.map((channel) => difference(channel, first, last))),
  ]);
  const differencesAndBends = new Windows(2 * channels.length, (first, last) =>
    channels.flatMap((channel) => [difference(channel, first, last), bend(channel, first, last)]),
  );
  /**
   * The largest measure of windows. Together, the windows hold every pair of values that are near enough to each other.
   * @param parts - number of windows that begin per reach; each is wider than the reach by the distance between their starts
   * @param measure - of the known numbers, the index of a window's first number, and the number of bins in the window
   */
  const largestOf = (
    [from, to, apart]: readonly [number, number, number],
    parts: number,
    windows: Windows,
    measure: (known: Float64Array, at: number, count: number) => number,
  ): number => {
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
    largest: (from, to) => Math.max(...channels.map(({ max }) => extremeOf(max, binOf(from), binOf(to), Math.max))),
    among: (...where) => largestOf(where, 8, differences, (known, at) => known[at]),
    // A function whose slope lies between two slopes is off its chord by at most a quarter of their difference, times the width.
    offLine: (...where) =>
      largestOf(where, 2, differencesAndBends, (known, at, count) => {
        const times = Math.max(minWidth, Math.min(count, inBins(where[2]))) / 4;
        let largest = 0;
        for (let n = at; n < at + 2 * channels.length; n += 2)
          largest = Math.max(largest, Math.min(known[n], known[n + 1] * times));
        return largest;
      }),
  };
}

/** Measures of windows of bins. Thousands of cells ask for the same windows, so each is measured once. */
class Windows {
  /** By the number of bins. Each window has its numbers; NaN if it has not been measured. */
  readonly #known: Float64Array[] = [];

  /** @param numbers - how many numbers a window has */
  constructor(
    readonly numbers: number,
    readonly measure: (first: number, last: number) => readonly number[],
  ) {}

  /** All windows with this number of bins; the one from `first` to `last` has been measured. */
  with(first: number, last: number): Float64Array {
    const known = (this.#known[last - first] ??= new Float64Array(bins * this.numbers).fill(NaN));
    if (Number.isNaN(known[first * this.numbers])) known.set(this.measure(first, last), first * this.numbers);
    return known;
  }
}

function include([min, max]: readonly Float32Array[], bin: number, value: number): void {
  min[bin] = Math.min(min[bin], value);
  max[bin] = Math.max(max[bin], value);
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
