// Numbers of 16 bits are counted slice by slice, while the next ones are read: with the counts, their range and their
// histogram need no look at all numbers together.
import type { Samples } from '../../volume/samples.ts';

/** Patterns of 16 bits. */
const patterns = 2 ** 16;

/** A processor waits where it adds to one place twice in a row, as in air: numbers are counted in so many tables in turns. */
const tables = 4;

/** How often each number occurs. */
export class NumberCounts {
  readonly #counts = new Uint32Array(tables * patterns);

  add(numbers: Uint16Array | Int16Array): void {
    const counts = this.#counts;
    const bits = new Uint16Array(numbers.buffer, numbers.byteOffset, numbers.length);
    const inTurns = bits.length - (bits.length % tables);
    for (let i = 0; i < inTurns; i += tables) {
      counts[bits[i]]++;
      counts[patterns + bits[i + 1]]++;
      counts[2 * patterns + bits[i + 2]]++;
      counts[3 * patterns + bits[i + 3]]++;
    }
    for (let i = inTurns; i < bits.length; i++) counts[bits[i]]++;
  }

  /**
   * The counts of all, from the smallest number that there can be: -32,768 for signed ones, else 0. @returns one for each number
   */
  sum(isSigned: boolean): Uint32Array<ArrayBuffer> {
    const sum = new Uint32Array(patterns);
    for (let i = 0; i < this.#counts.length; i++)
      sum[(i + (isSigned ? patterns / 2 : 0)) % patterns] += this.#counts[i];
    return sum;
  }
}

/** Samples as storeSamples makes them of the same numbers, in place. */
export interface CountedSamples {
  readonly samples: Samples;
  readonly scale: 1;
  readonly offset: number;
  /** How often each sample occurs. */
  readonly counts: Uint32Array<ArrayBuffer>;
}

/**
 * Stores numbers of 16 bits of which the counts are known, and takes them over: as `storeSamples` does, which looks at
 * all of them to find their range.
 * @returns null where their range fits into 8 bits: `storeSamples` then makes them smaller
 */
export function storeCounted(numbers: Uint16Array | Int16Array, known: NumberCounts): CountedSamples | null {
  const isSigned = numbers instanceof Int16Array;
  const all = known.sum(isSigned);
  const first = all.findIndex(Boolean);
  let last = all.length - 1;
  while (last > first && all[last] === 0) last--;
  if (last - first <= 0xff) return null;
  const samples = new Uint16Array(numbers.buffer as ArrayBuffer, numbers.byteOffset, numbers.length);
  const low = isSigned ? first - patterns / 2 : first;
  if (low >= 0) return { samples, scale: 1, offset: 0, counts: isSigned ? shiftCounts(all, patterns / 2) : all };
  subtract(samples, low);
  return { samples, scale: 1, offset: low, counts: shiftCounts(all, first) };
}

/** @returns counts of which those of `from` are the first */
function shiftCounts(counts: Uint32Array, from: number): Uint32Array<ArrayBuffer> {
  const shifted = new Uint32Array(counts.length);
  shifted.set(counts.subarray(from));
  return shifted;
}

/** Subtracts from numbers of 16 bits, two of them at once: that takes half as long. */
function subtract(numbers: Uint16Array, by: number): void {
  const isAligned = numbers.byteOffset % 4 === 0;
  const pairs = isAligned ? new Int32Array(numbers.buffer, numbers.byteOffset, numbers.length >> 1) : new Int32Array();
  const high = by << 16;
  for (let i = 0; i < pairs.length; i++) {
    const pair = pairs[i];
    pairs[i] = ((pair - high) & 0xffff_0000) | ((pair - by) & 0xffff);
  }
  for (let i = 2 * pairs.length; i < numbers.length; i++) numbers[i] -= by;
}
