/** A numeric type of a file, as its samples lie in memory. */
export interface NumberType {
  readonly name: string;
  readonly bytesPerSample: number;
  /** Bytes that are swapped together in the other byte order. */
  readonly bytesPerNumber: number;
  /** Integers, to be stored exactly, or numbers to be read as doubles. */
  readonly read:
    | { readonly kind: 'integers'; readonly view: View<Integers> }
    | { readonly kind: 'bigints'; readonly view: View<BigInt64Array | BigUint64Array> }
    | { readonly kind: 'floats'; readonly view: View<Float32Array<ArrayBuffer> | Float64Array> };
  /** Real and imaginary part, one after the other: the magnitude is shown. */
  readonly complex: boolean;
}

export type Integers = Uint8Array | Int8Array | Uint16Array | Int16Array | Uint32Array | Int32Array;

/** Numbers as they lie in a file's bytes, which begin at a multiple of 8 in their buffer. */
type View<T> = (bytes: Uint8Array<ArrayBuffer>) => T;

interface NumberArray<T> {
  readonly BYTES_PER_ELEMENT: number;
  new (buffer: ArrayBuffer, byteOffset: number, length: number): T;
}

const viewAs = <T>(Type: NumberArray<T>): View<T> => ({ buffer, byteOffset, byteLength }) =>
  new Type(buffer, byteOffset, byteLength / Type.BYTES_PER_ELEMENT);

const integers = (name: string, bytes: number, view: View<Integers>): NumberType => ({
  name,
  bytesPerSample: bytes,
  bytesPerNumber: bytes,
  read: { kind: 'integers', view },
  complex: false,
});

const bigints = (name: string, view: View<BigInt64Array | BigUint64Array>): NumberType => ({
  name,
  bytesPerSample: 8,
  bytesPerNumber: 8,
  read: { kind: 'bigints', view },
  complex: false,
});

const floats = (
  name: string,
  bytes: number,
  view: View<Float32Array<ArrayBuffer> | Float64Array>,
  complex = false,
): NumberType => ({
  name,
  bytesPerSample: complex ? 2 * bytes : bytes,
  bytesPerNumber: bytes,
  read: { kind: 'floats', view },
  complex,
});

/** Types that hold one number per voxel. */
export const numberTypes = {
  int8: integers('int8', 1, viewAs(Int8Array)),
  uint8: integers('uint8', 1, viewAs(Uint8Array)),
  int16: integers('int16', 2, viewAs(Int16Array)),
  uint16: integers('uint16', 2, viewAs(Uint16Array)),
  int32: integers('int32', 4, viewAs(Int32Array)),
  uint32: integers('uint32', 4, viewAs(Uint32Array)),
  int64: bigints('int64', viewAs(BigInt64Array)),
  uint64: bigints('uint64', viewAs(BigUint64Array)),
  float32: floats('float32', 4, viewAs(Float32Array)),
  float64: floats('float64', 8, viewAs(Float64Array)),
  float128: floats('float128', 16, readBinary128),
  complex64: floats('complex64', 4, viewAs(Float32Array), true),
  complex128: floats('complex128', 8, viewAs(Float64Array), true),
  complex256: floats('complex256', 16, readBinary128, true),
} as const;

/** NIfTI's datatype codes. Source: nifti1.h. */
export const niftiTypes: ReadonlyMap<number, NumberType> = new Map([
  [2, numberTypes.uint8],
  [4, numberTypes.int16],
  [8, numberTypes.int32],
  [16, numberTypes.float32],
  [32, numberTypes.complex64],
  [64, numberTypes.float64],
  [256, numberTypes.int8],
  [512, numberTypes.uint16],
  [768, numberTypes.uint32],
  [1024, numberTypes.int64],
  [1280, numberTypes.uint64],
  [1536, numberTypes.float128],
  [1792, numberTypes.complex128],
  [2048, numberTypes.complex256],
]);

/** What is said of the codes that hold something else. */
export const niftiTypesRefused: ReadonlyMap<number, string> = new Map([
  [1, 'one bit per voxel (binary), in an order of bits that the standard leaves open'],
  [128, 'colours (RGB24): a transfer function needs one number per voxel'],
  [2304, 'colours (RGBA32): a transfer function needs one number per voxel'],
]);

/** True where this machine stores the low byte first, as every one that runs a browser does. */
export const hostIsLittleEndian = new Uint8Array(new Uint16Array([1]).buffer)[0] === 1;

/** Reverse the bytes of every number of `size` bytes, in place. */
export function swapBytes(bytes: Uint8Array, size: number): void {
  for (let at = 0; at + size <= bytes.length; at += size) bytes.subarray(at, at + size).reverse();
}

/**
 * IEEE 754 binary128 to double: sign, 15 bits of exponent, 112 bits of fraction, of which a double keeps 52. (x86's
 * 80-bit numbers padded to 128 are not what the standard means; nibabel refuses those too.)
 */
function readBinary128({ buffer, byteOffset, byteLength }: Uint8Array<ArrayBuffer>): Float64Array {
  const view = new DataView(buffer, byteOffset, byteLength);
  const little = hostIsLittleEndian;
  const values = new Float64Array(byteLength / 16);
  for (let i = 0; i < values.length; i++) {
    const high = view.getUint32(16 * i + (little ? 12 : 0), little);
    const words = [8, 4, 0].map((at) => view.getUint32(16 * i + (little ? at : 12 - at), little));
    const sign = high >>> 31 ? -1 : 1;
    const exponent = (high >>> 16) & 0x7fff;
    const fraction = ((high & 0xffff) + (words[0] + (words[1] + words[2] / 2 ** 32) / 2 ** 32) / 2 ** 32) / 2 ** 16;
    if (exponent === 0x7fff) values[i] = fraction === 0 ? sign * Infinity : NaN;
    else if (exponent === 0) values[i] = 0; // Subnormals, below 2^-16382, are 0 as doubles.
    // In two steps, because 2^exponent alone overflows or vanishes before the product does.
    else values[i] = sign * (1 + fraction) * 2 ** Math.floor((exponent - 16383) / 2) * 2 ** Math.ceil((exponent - 16383) / 2);
  }
  return values;
}
