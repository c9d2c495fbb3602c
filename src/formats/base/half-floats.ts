import { floats, hostIsLittleEndian } from './number-types.ts';

/** Floats of 16 bits, all of which a 32-bit float holds exactly. Source: IEEE 754-2008, binary16 */
export function readHalfFloats({ buffer, byteOffset, byteLength }: Uint8Array): Float32Array<ArrayBuffer> {
  const view = new DataView(buffer, byteOffset, byteLength);
  const values = new Float32Array(byteLength / 2);
  for (let i = 0; i < values.length; i++) {
    const bits = view.getUint16(2 * i, hostIsLittleEndian);
    const exponent = (bits >> 10) & 0x1f;
    const fraction = bits & 0x3ff;
    const size =
      exponent === 0
        ? fraction * 2 ** -24
        : exponent === 0x1f
          ? fraction
            ? NaN
            : Infinity
          : (1 + fraction / 1024) * 2 ** (exponent - 15);
    values[i] = bits & 0x8000 ? -size : size;
  }
  return values;
}

export const float16 = floats('float16', 2, readHalfFloats);

/** The bits of the float of 16 bits that is nearest to a number. */
export function halfFloatBits(value: number): number {
  if (Number.isNaN(value)) return 0x7e00;
  // What is larger becomes infinite.
  const size = Math.min(Math.abs(value), 2 ** 16);
  const exponent = Math.max(-14, Math.floor(Math.log2(size)));
  // Of the smallest numbers the exponent is 0. A fraction that is rounded up to a whole number is the next exponent.
  const bits = (exponent + 14) * 1024 + Math.round(size * 2 ** (10 - exponent));
  return (value < 0 ? 0x8000 : 0) + bits;
}
