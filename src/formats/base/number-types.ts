import type { FileColors } from './decoded-volume.ts';
/** A numeric type of a file, as its samples lie in memory. */
export interface NumberType {
  readonly name: string;
  readonly bytesPerSample: number;
  /** Bytes that are swapped together to change the byte order. */
  readonly bytesPerNumber: number;
  /** How to read them: as integers, which are stored exactly, or as doubles. */
  readonly read:
    | { readonly kind: 'integers'; readonly view: View<Integers> }
    | { readonly kind: 'bigints'; readonly view: View<BigInt64Array | BigUint64Array> }
    | { readonly kind: 'floats'; readonly view: View<Float32Array<ArrayBuffer> | Float64Array> };
  /**
   * Whether several numbers become one that no scale of the file belongs to: of real and imaginary part, one after the other, the
   * magnitude. `read` makes one number of colours.
   */
  readonly complex: boolean;
  /** Of numbers that are made of colours: these, once they were read. */
  readonly colors?: () => FileColors | undefined;
}

export type Integers = Uint8Array | Int8Array | Uint16Array | Int16Array | Uint32Array | Int32Array;

/** Views a file's bytes as numbers. The bytes begin at a multiple of 8 in their buffer. */
type View<T> = (bytes: Uint8Array<ArrayBuffer>) => T;

interface NumberArray<T> {
  readonly BYTES_PER_ELEMENT: number;
  new (buffer: ArrayBuffer, byteOffset: number, length: number): T;
}

export const viewAs =
  <T>(Type: NumberArray<T>): View<T> =>
  ({ buffer, byteOffset, byteLength }) =>
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

export const floats = (
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
} as const;

/** NIfTI's datatype codes, except those in nifti-rare-types.ts. Source: nifti1.h. */
export const niftiTypes: ReadonlyMap<number, NumberType> = new Map([
  [2, numberTypes.uint8],
  [4, numberTypes.int16],
  [8, numberTypes.int32],
  [16, numberTypes.float32],
  [64, numberTypes.float64],
  [256, numberTypes.int8],
  [512, numberTypes.uint16],
  [768, numberTypes.uint32],
  [1024, numberTypes.int64],
  [1280, numberTypes.uint64],
]);

/** True if this machine stores the low byte first, as every machine that runs a browser does. */
export const hostIsLittleEndian = new Uint8Array(new Uint16Array([1]).buffer)[0] === 1;

/** Reverses the bytes of every number of `size` bytes, in place. */
export function swapBytes(bytes: Uint8Array, size: number): void {
  for (let start = 0; start + size <= bytes.length; start += size) {
    for (let low = start, high = start + size - 1; low < high; low++, high--) {
      const byte = bytes[low];
      bytes[low] = bytes[high];
      bytes[high] = byte;
    }
  }
}
