import { hostIsLittleEndian } from '../base/number-types.ts';

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
