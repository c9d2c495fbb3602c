import { chooseOffset } from '../../volume/detail-offset.ts';
import type { IndexedSamples, Rounded, Unkept } from '../../volume/index-numbers.ts';
import type { Samples } from '../../volume/volume.ts';
import type { Budget } from './budget.ts';
import { loadReader } from './load-reader.ts';
import { hostIsLittleEndian, swapBytes } from './number-types.ts';
import type { Integers, NumberType } from './number-types.ts';
import type { chooseWhole as ChooseWhole } from './whole-numbers.ts';

/** Samples in one of the three stored types, and how to compute the file's own numbers from them. */
export interface StoredSamples {
  readonly samples: Samples;
  /** File's value = scale * sample + offset. */
  readonly scale: number;
  readonly offset: number;
  /** The file's exact values of whole numbers that float32 rounds; absent if none is rounded, or too many differ. */
  readonly indexed?: IndexedSamples;
  /** Whole numbers that are rounded and not indexed: how many, and by how much at most. */
  readonly rounded?: Rounded;
  /** Numbers of a file of floats that have no sample of their own; absent if there are none. */
  readonly unkept?: Unkept;
}

interface Rescale {
  /** The file's slope. Only complex numbers need it here, before their magnitude is taken. */
  readonly slope: number;
  readonly intercept: number;
  /** The load's budget. The bytes are taken from it already; a second copy has to be taken too. */
  readonly budget?: Budget;
  /** See `wholeNumbersOf`. */
  readonly chooseWhole?: typeof ChooseWhole;
}

/**
 * Loads what keeps whole numbers of a type that float32 may round. 32-bit floats don't need it: they are stored as they
 * are.
 */
export async function wholeNumbersOf({ bytesPerNumber, read }: NumberType): Promise<typeof ChooseWhole | undefined> {
  const mayRound = bytesPerNumber === 8 || (bytesPerNumber === 4 && read.kind === 'integers');
  return mayRound ? (await loadReader(() => import('#rare/formats/base/whole-numbers.ts'))).chooseWhole : undefined;
}

/** The largest whole number below which a float32 holds every whole number. */
const exactInFloat32 = 2 ** 24;

/**
 * Converts a file's samples to the stored type that keeps their precision: 8 or 16 bits if the range of values fits
 * after a shift. Else float32, less an offset that is subtracted in double precision if the detail lies far from 0. For
 * whole numbers the function compares offsets, and takes the one that rounds fewer of them. Infinities become NaN, no
 * data.
 * @param bytes - the samples alone, in the file's byte order. The function takes the buffer over: the caller must not
 * use it again
 * @throws {VolumeViewError} `format/too-large`
 */
export function storeSamples(
  bytes: Uint8Array<ArrayBuffer>,
  type: NumberType,
  littleEndian: boolean,
  rescale: Rescale,
): StoredSamples {
  const { budget } = rescale;
  const own = bytes.byteOffset % 8 === 0 ? bytes : bytes.slice();
  if (littleEndian !== hostIsLittleEndian) swapBytes(own, type.bytesPerNumber);
  switch (type.read.kind) {
    case 'integers':
      return storeIntegers(type.read.view(own), rescale);
    case 'bigints':
      return storeBigInts(type.read.view(own), rescale);
    case 'floats': {
      // Numbers of types that this machine lacks are copied as doubles.
      if (type.bytesPerNumber > 8) take(budget, own.length);
      const values = type.read.view(own);
      return storeFloats(type.complex ? magnitudes(values, rescale) : values, rescale);
    }
  }
}

function storeIntegers(values: Integers, { budget, chooseWhole }: Rescale): StoredSamples {
  if (values instanceof Uint8Array) return { samples: values as Uint8Array<ArrayBuffer>, scale: 1, offset: 0 };
  const [low, high] = rangeOf(values);
  const { store: Store, from } = chooseStore({ low, high, range: high - low });
  const detail = from === 'detail' ? chooseOffset(values) : 0;
  const whole = from === 'detail' ? chooseWhole?.(values, detail, Number, budget) : null;
  const offset = whole?.offset ?? (from === 'low' ? low : detail);
  if (values instanceof Store && offset === 0) return { samples: values as Samples, scale: 1, offset };
  // Numbers of the same width overwrite the file's: a large volume is not copied.
  const isAsWide = Store.BYTES_PER_ELEMENT === values.BYTES_PER_ELEMENT;
  if (!isAsWide) take(budget, values.length * Store.BYTES_PER_ELEMENT);
  const samples = isAsWide
    ? new Store(values.buffer as ArrayBuffer, values.byteOffset, values.length)
    : new Store(values.length);
  for (let i = 0; i < values.length; i++) samples[i] = values[i] - offset;
  return { samples, scale: 1, ...whole, offset };
}

function storeBigInts(values: BigInt64Array | BigUint64Array, { budget, chooseWhole }: Rescale): StoredSamples {
  take(budget, 2 * values.byteLength);
  let low = values[0];
  let high = values[0];
  for (const value of values) {
    if (value < low) low = value;
    if (value > high) high = value;
  }
  const { store: Store, from } = chooseStore({ low: Number(low), high: Number(high), range: Number(high - low) });
  // Subtracted as 64-bit integers, because doubles can't distinguish 2^60 from 2^60 + 1.
  const detail =
    from === 'detail' ? low + BigInt(chooseOffset(Float64Array.from(values, (value) => Number(value - low)))) : 0n;
  const whole = from === 'detail' ? chooseWhole?.(values, detail, BigInt, budget) : null;
  const offset = whole?.offset ?? (from === 'low' ? low : detail);
  const samples = new Store(values.length);
  for (let i = 0; i < values.length; i++) samples[i] = Number(values[i] - offset);
  // A double can't hold offset + sample exactly for such large values, so some are rounded.
  const stored = (i: number): bigint => BigInt(Number(offset) + samples[i]);
  const errors =
    from === 'low' && !Number.isSafeInteger(Number(high))
      ? Array.from(values, (value, i) => Math.abs(Number(stored(i) - value))).filter((error) => error > 0)
      : [];
  const rounded =
    errors.length > 0 ? { count: errors.length, by: errors.reduce((max, error) => Math.max(max, error)) } : undefined;
  return { samples, scale: 1, rounded, ...whole, offset: Number(offset) };
}

function take(budget: Budget | undefined, bytes: number): void {
  budget?.take(bytes, 'the samples');
}

/**
 * The smallest type that holds whole numbers of a range exactly (as exactly as float32 can), and the offset to
 * subtract.
 */
function chooseStore(values: { low: number; high: number; range: number }): {
  store: typeof Uint8Array | typeof Uint16Array | typeof Float32Array;
  from: 'zero' | 'low' | 'detail';
} {
  const { low, high, range } = values;
  if (range <= 0xff) return { store: Uint8Array, from: low >= 0 && high <= 0xff ? 'zero' : 'low' };
  if (range <= 0xffff) return { store: Uint16Array, from: low >= 0 && high <= 0xffff ? 'zero' : 'low' };
  const exact = Math.max(-low, high) <= exactInFloat32;
  return { store: Float32Array, from: exact ? 'zero' : 'detail' };
}

/** Floats from here on are stored as shares of a power of two: a GPU rounds the inverse of their span to 0. So are those below its inverse. */
const largestAsIs = 2 ** 100;

/** The smallest number that float32 holds with all its digits. */
const smallestNormal = 2 ** -126;

function storeFloats(
  values: Float32Array<ArrayBuffer> | Float64Array,
  { budget, chooseWhole }: Rescale,
): StoredSamples {
  const [low, high] = rangeOf(values);
  const isFloat32 = values instanceof Float32Array;
  const detail = chooseOffset(values);
  const farthest = Math.max(-low, high);
  const whole =
    chooseWhole && farthest > exactInFloat32 && farthest < 2 ** 64 && low < high && values.every(isWhole)
      ? chooseWhole(values, detail, Number, budget)
      : null;
  // A shift must not round values that 32 bits hold exactly. If all values are the same double, that one is the offset,
  // and is kept exactly.
  const isHarmed =
    isFloat32 && detail !== 0 && values.some((value) => Math.abs(Math.fround(value - detail) + detail - value) > 0);
  const offset = whole?.offset ?? (low === high && !isFloat32 ? low : isHarmed ? 0 : detail);
  const largest = low === high ? Math.max(1, Math.abs(low)) : Math.max(offset - low, high - offset);
  const isAsIs = isFloat32 && largest > 1 / largestAsIs && largest < largestAsIs;
  const scale = isAsIs ? 1 : chooseScale(largest);
  if (!isFloat32) take(budget, values.length * 4);
  const samples = isFloat32 ? values : new Float32Array(values.length);
  let [infinite, small] = [0, 0];
  for (let i = 0; i < values.length; i++) {
    const value = values[i];
    const sample = (samples[i] = Number.isFinite(value) ? (value - offset) / scale : NaN);
    if (Number.isNaN(sample) && !Number.isNaN(value)) infinite++;
    if (!isAsIs && sample !== 0 && Math.abs(sample) < smallestNormal) small++;
  }
  return { samples, ...whole, unkept: infinite + small ? { infinite, small } : undefined, scale, offset };
}

/** No data (NaN) does not count as a fraction. */
function isWhole(value: number): boolean {
  return value % 1 === 0 || !Number.isFinite(value);
}

/** A power of two that brings the largest magnitude near 1, if float32 (or a GPU) could not hold it well. */
function chooseScale(largest: number): number {
  if (!(largest > 0) || (largest > 2 ** -60 && largest < 2 ** 60)) return 1;
  return 2 ** Math.max(-1022, Math.floor(Math.log2(largest)));
}

function magnitudes(parts: Float32Array | Float64Array, rescale: Rescale): Float64Array {
  take(rescale.budget, parts.length * 4);
  const values = new Float64Array(parts.length / 2);
  const scaled = (part: number): number => rescale.slope * part + rescale.intercept;
  for (let i = 0; i < values.length; i++) values[i] = Math.hypot(scaled(parts[2 * i]), scaled(parts[2 * i + 1]));
  return values;
}

/** Smallest and largest finite value; 0 and 0 if there is none. */
function rangeOf(values: ArrayLike<number>): [number, number] {
  let low = Infinity;
  let high = -Infinity;
  for (let i = 0; i < values.length; i++) {
    const value = values[i];
    if (value < low && value > -Infinity) low = value;
    if (value > high && value < Infinity) high = value;
  }
  return low > high ? [0, 0] : [low, high];
}
