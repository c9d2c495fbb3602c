// HDF5's filter that keeps the distances of numbers from the smallest one, in as few bits as they need. Source: HDF5 1.14, H5Zscaleoffset.c
import { swapBytes } from '../base/number-types.ts';
import { corruptHdf5, unsupportedHdf5 } from './hdf5-bytes.ts';

/** Bytes before the packed numbers: how many bits each has, and the smallest number. */
export const scaleOffsetHead = 21;

/** Where the words of the number that stands for no data begin among the parameters. */
const fillAt = 8;

/**
 * @param parameters - kind of scale and its factor, count, class (1 for floats), size, sign, byte order (1 for big-endian), whether there is a
 * number that stands for no data, and that
 * @param expected - bytes of the numbers
 * @throws {VolumeViewError} `format/corrupt`, `format/unsupported`
 */
export function unpackScaleOffset(
  bytes: Uint8Array<ArrayBuffer>,
  parameters: readonly number[],
  expected: number,
): Uint8Array<ArrayBuffer> {
  const [kind, digits, count, type, size, , order, hasFill] = parameters;
  const isFloat = type === 1;
  if (isFloat && kind !== 0) throw unsupportedHdf5('floats whose exponents are scaled (scale-offset)', 'h5py');
  // As many bits as the numbers have: they are as they were.
  if (!isFloat && digits === 8 * size) return bytes;
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
  const bits = bytes.length < scaleOffsetHead ? NaN : view.getUint32(0, true);
  const isSound =
    (isFloat ? [4, 8] : [1, 2, 4, 8]).includes(size) &&
    count * size === expected &&
    bits <= 8 * size &&
    scaleOffsetHead + Math.ceil((count * bits) / 8) <= bytes.length;
  if (!isSound) throw corruptHdf5('has a chunk that is not packed as it says (scale-offset)');
  const out = new Uint8Array(expected);
  const isWhole = bits === 8 * size;
  if (isWhole) out.set(bytes.subarray(scaleOffsetHead, scaleOffsetHead + expected));
  else {
    const write = chooseWriter(new DataView(out.buffer), { isFloat, size, digits: digits | 0, low: view });
    const next = bitReader(bytes, bits);
    const fill = hasFill === 1 ? 2n ** BigInt(bits) - 1n : -1n;
    const ofFill = new Uint8Array(Uint32Array.from(parameters.slice(fillAt, fillAt + 2)).buffer).subarray(0, size);
    for (let i = 0, at = 0; i < count; i++, at += size) {
      const step = next();
      if (BigInt(step) === fill) out.set(ofFill, at);
      else write(at, step);
    }
  }
  if (order === 1) swapBytes(out, size);
  return out;
}

/** Reads one number after the other, the highest bit first. */
function bitReader(bytes: Uint8Array, bits: number): () => number | bigint {
  let at = 8 * scaleOffsetHead;
  const take = (wanted: number): number => {
    let value = 0;
    for (let left = wanted; left > 0;) {
      const free = 8 - (at % 8);
      const some = Math.min(free, left);
      value = value * 2 ** some + ((bytes[Math.floor(at / 8)] >> (free - some)) & (2 ** some - 1));
      at += some;
      left -= some;
    }
    return value;
  };
  return bits <= 32 ? () => take(bits) : () => (BigInt(take(bits - 32)) << 32n) + BigInt(take(32));
}

interface Packed {
  readonly isFloat: boolean;
  readonly size: number;
  /** Decimal ones that floats keep. */
  readonly digits: number;
  /** Of the chunk: where the smallest number is. */
  readonly low: DataView;
}

/** Writes the smallest number and a distance, little-endian. */
function chooseWriter(
  out: DataView,
  { isFloat, size, digits, low }: Packed,
): (at: number, step: number | bigint) => void {
  const at = 5;
  if (isFloat && size === 4) {
    const [least, scale] = [low.getFloat32(at, true), Math.fround(10 ** digits)];
    return (to, step) => out.setFloat32(to, Math.fround(Math.fround(Number(step) | 0) / scale) + least, true);
  }
  if (isFloat) {
    const [least, scale] = [low.getFloat64(at, true), 10 ** digits];
    return (to, step) => out.setFloat64(to, Number(step) / scale + least, true);
  }
  const least = low.getBigInt64(at, true);
  if (size === 8) return (to, step) => out.setBigInt64(to, least + BigInt(step), true);
  // A sum that is too large for its size loses the bits above it, as it did when it was packed.
  const small = Number(least);
  if (size === 4) return (to, step) => out.setInt32(to, small + Number(step), true);
  if (size === 2) return (to, step) => out.setInt16(to, small + Number(step), true);
  return (to, step) => out.setInt8(to, small + Number(step));
}
