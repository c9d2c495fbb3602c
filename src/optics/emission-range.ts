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
  const width = (high - low) / bins;
  const edges = Array.from({ length: bins + 1 }, (_, i) => emission(transferFunction, low + i * width));
  const before = emission(transferFunction, -Infinity);
  const channels = [0, 1, 2, 3].map((c) => {
    const [least, most] = [new Float32Array(bins), new Float32Array(bins)];
    for (let i = 0; i < bins; i++) {
      least[i] = Math.min(edges[i][c], edges[i + 1][c]);
      most[i] = Math.max(edges[i][c], edges[i + 1][c]);
    }
    include([least, most], 0, before[c]);
    transferFunction.forEach(({ value }, n) => {
      const bin = Math.min(bins - 1, Math.max(0, Math.floor((value - low) / width)));
      include([least, most], bin, emission(transferFunction, value)[c]);
      // The left side of a jump, which no value has, is all but reached.
      if (n > 0 && transferFunction[n - 1].value < value) include([least, most], bin, emission([transferFunction[n]], value)[c]);
    });
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
  const binOf = (value: number): number => Math.min(bins - 1, Math.max(0, Math.floor((value - low) / width)));
  type Channel = (typeof channels)[number];
  /** @param parts - windows begin so many to a reach, and are so much wider than it */
  const largestOf = ([from, to, apart]: readonly [number, number, number], parts: number, measure: (channel: Channel, first: number, last: number) => number): number => {
    const [first, last] = [binOf(from), binOf(to)];
    const reach = Math.min(last - first, Math.ceil(apart / width) + 1);
    const step = Math.floor(reach / parts);
    let largest = 0;
    for (const channel of channels) {
      for (let i = first; ; i += Math.max(1, step)) {
        const end = Math.min(last, i + reach + step);
        largest = Math.max(largest, measure(channel, i, end));
        if (end === last) break;
      }
    }
    return largest;
  };
  const difference = ({ least, most }: Channel, first: number, last: number): number =>
    extremeOf(most, first, last, Math.max) - extremeOf(least, first, last, Math.min);
  return {
    largest: (from, to) => Math.max(...channels.map(({ most }) => extremeOf(most, binOf(from), binOf(to), Math.max))),
    among: (...where) => largestOf(where, 8, difference),
    // A function whose slope is between two is off its chord by a quarter of their difference, times the width.
    offLine: (...where) => largestOf(where, 2, (channel, first, last) => Math.min(
      difference(channel, first, last),
      ((extremeOf(channel.highest, first, last, Math.max) - extremeOf(channel.lowest, first, last, Math.min)) * Math.max(leastWidth, Math.min(last - first + 1, where[2] / width))) / 4,
    )),
  };
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
