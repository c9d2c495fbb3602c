import type { Numbers, NumberType } from './data-tree.ts';
import { readHalfFloats } from './half-floats.ts';
import { hostIsLittleEndian, swapBytes } from './number-types.ts';

export const bytesOfNumber: Readonly<Record<NumberType, number>> = {
  int8: 1,
  uint8: 1,
  int16: 2,
  uint16: 2,
  int32: 4,
  uint32: 4,
  int64: 8,
  uint64: 8,
  float16: 2,
  float32: 4,
  float64: 8,
};

/**
 * Decodes the numbers of a file.
 * @param bytes - the numbers alone. The function takes the buffer over: the caller must not use it again
 */
export function decodeNumbers(bytes: Uint8Array<ArrayBuffer>, type: NumberType, littleEndian: boolean): Numbers {
  const size = bytesOfNumber[type];
  const isAligned = bytes.byteOffset % size === 0;
  const own = littleEndian === hostIsLittleEndian && isAligned ? bytes : bytes.slice();
  if (littleEndian !== hostIsLittleEndian) swapBytes(own, size);
  const { buffer, byteOffset } = own;
  const length = Math.floor(own.length / size);
  switch (type) {
    case 'int8':
      return new Int8Array(buffer, byteOffset, length);
    case 'uint8':
      return own;
    case 'int16':
      return new Int16Array(buffer, byteOffset, length);
    case 'uint16':
      return new Uint16Array(buffer, byteOffset, length);
    case 'int32':
      return new Int32Array(buffer, byteOffset, length);
    case 'uint32':
      return new Uint32Array(buffer, byteOffset, length);
    case 'int64':
      return Float64Array.from(new BigInt64Array(buffer, byteOffset, length), Number);
    case 'uint64':
      return Float64Array.from(new BigUint64Array(buffer, byteOffset, length), Number);
    case 'float16':
      return readHalfFloats(new Uint8Array(buffer, byteOffset, 2 * length));
    case 'float32':
      return new Float32Array(buffer, byteOffset, length);
    case 'float64':
      return new Float64Array(buffer, byteOffset, length);
  }
}
