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

/** Of the emission of one channel in each bin, and of how much it rises there. */
interface Channel {
  readonly min: Extremes;
  readonly max: Extremes;
  readonly lowest: Extremes;
  readonly highest: Extremes;
}

/**
 * Prepares a transfer function. Pages need this for each look, before the browser has optimised it: so it has loops, and makes no lists for a
 * single window. What it learns takes up to 10 MB: keep it no longer than it is asked.
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
  const channels = [0, 1, 2, 3].map((c): Channel => {
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
  const differences = new Windows(1, (first, last, known, at) => {
    let largest = -Infinity;
    for (const { min, max } of channels) largest = Math.max(largest, differenceOf(max, min, first, last));
    known[at] = largest;
  });
  const differencesAndBends = new Windows(2 * channels.length, (first, last, known, at) => {
    let n = at;
    for (const { min, max, lowest, highest } of channels) {
      known[n++] = differenceOf(max, min, first, last);
      known[n++] = differenceOf(highest, lowest, first, last);
    }
  });
  /**
   * The largest measure of windows. Together, the windows hold every pair of values that are near enough to each other.
   * @param apart - in bins
   */
  const largestOf = ({ parts, windows, measure }: Search, from: number, to: number, apart: number): number => {
    const first = binOf(from);
    const last = binOf(to);
    const reach = Math.min(last - first, Math.ceil(apart) + 1);
    const step = Math.floor(reach / parts);
    let largest = 0;
    for (let i = first; ; i += Math.max(1, step)) {
      const end = Math.min(last, i + reach + step);
      const known = windows.with(i, end);
      largest = Math.max(largest, measure(known, i * windows.numbers, end - i + 1, apart));
      if (end === last) return largest;
    }
  };
  const among: Search = { parts: 8, windows: differences, measure: firstNumber };
  const offLine: Search = { parts: 2, windows: differencesAndBends, measure: offChord };
  return {
    largest(from, to) {
      const [first, last] = [binOf(from), binOf(to)];
      let largest = -Infinity;
      for (const { max } of channels) largest = Math.max(largest, largestIn(max, first, last));
      return largest;
    },
    among: (from, to, apart) => largestOf(among, from, to, inBins(apart)),
    offLine: (from, to, apart) => largestOf(offLine, from, to, inBins(apart)),
  };
}

/** What is looked for in windows of bins. */
interface Search {
  /** The number of windows that begin per reach; each is wider than the reach by the distance between their starts. */
  readonly parts: number;
  readonly windows: Windows;
  /** Of the known numbers, the index of a window's first number, the number of bins in the window, and `apart` in bins. */
  readonly measure: (known: Float64Array, at: number, count: number, apart: number) => number;
}

function firstNumber(known: Float64Array, at: number): number {
  return known[at];
}

/** A function whose slope lies between two slopes is off its chord by at most a quarter of their difference, times the width. */
function offChord(known: Float64Array, at: number, count: number, apart: number): number {
  const times = Math.max(minWidth, Math.min(count, apart)) / 4;
  let largest = 0;
  for (let n = at; n < at + 8; n += 2) largest = Math.max(largest, Math.min(known[n], known[n + 1] * times));
  return largest;
}

/** Measures of windows of bins. Thousands of cells ask for the same windows, so each is measured once. */
class Windows {
  /** By the number of bins. Each window has its numbers; NaN if it has not been measured. */
  readonly #known: Float64Array[] = [];

  /**
   * @param numbers - how many numbers a window has
   * @param measure - writes them from a place on
   */
  constructor(
    readonly numbers: number,
    readonly measure: (first: number, last: number, known: Float64Array, at: number) => void,
  ) {}

  /** All windows with this number of bins; the one from `first` to `last` has been measured. */
  with(first: number, last: number): Float64Array {
    const known = (this.#known[last - first] ??= new Float64Array((bins - (last - first)) * this.numbers).fill(NaN));
    const at = first * this.numbers;
    if (Number.isNaN(known[at])) this.measure(first, last, known, at);
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
    const row = new Float32Array(bins - length + 1);
    for (let i = 0; i < row.length; i++) row[i] = of(last[i], last[i + length / 2]);
    rows.push(row);
  }
  return rows;
}

/** Of which row two stretches cover the bins from the first to the last. */
function rowOf(first: number, last: number): number {
  return 31 - Math.clz32(last - first + 1);
}

function largestIn(rows: Extremes, first: number, last: number): number {
  const row = rowOf(first, last);
  return Math.max(rows[row][first], rows[row][last - 2 ** row + 1]);
}

/** The largest value of the bins minus the smallest one. */
function differenceOf(largest: Extremes, smallest: Extremes, first: number, last: number): number {
  const row = rowOf(first, last);
  const second = last - 2 ** row + 1;
  return Math.max(largest[row][first], largest[row][second]) - Math.min(smallest[row][first], smallest[row][second]);
}
