// Reads the numbers of a glTF, which lie in buffers.
import { decodeBase64 } from './base64.ts';
import { format, listOf } from './gltf-scene.ts';
import type { Json } from './gltf-scene.ts';
import { checkCounts, corrupt } from './mesh-limits.ts';

/** A list of numbers or of vectors. */
export interface Numbers {
  readonly count: number;
  /** Numbers per element: 3 for a vector of three. */
  readonly size: number;
  /** All numbers, one after the other. Normalized integers are converted to shares. */
  readonly values: Float64Array;
}

/** Bytes of a number, how to read it, and the integer that stands for 1. */
const types: ReadonlyMap<unknown, readonly [bytes: number, read: (view: DataView, at: number) => number, one: number]> =
  new Map([
    [5120, [1, (view, at) => view.getInt8(at), 127]],
    [5121, [1, (view, at) => view.getUint8(at), 255]],
    [5122, [2, (view, at) => view.getInt16(at, true), 32767]],
    [5123, [2, (view, at) => view.getUint16(at, true), 65535]],
    [5125, [4, (view, at) => view.getUint32(at, true), 4294967295]],
    [5126, [4, (view, at) => view.getFloat32(at, true), 1]],
  ]);

const sizes: ReadonlyMap<unknown, number> = new Map([
  ['SCALAR', 1],
  ['VEC2', 2],
  ['VEC3', 3],
  ['VEC4', 4],
]);

/**
 * Reads accessors by their index.
 * Source: *glTF 2.0 Specification*, Khronos Group, sections 3.6 and 5.1 to 5.11
 * @param chunk - the binary chunk of a `.glb`
 * @returns a function that throws {VolumeViewError} `format/corrupt` if the data do not fit their description, or
 * `format/too-large`
 */
export function numbersReader(json: Json, chunk: Uint8Array<ArrayBuffer> | null): (index: number) => Numbers {
  const [accessors, views, buffers] = ['accessors', 'bufferViews', 'buffers'].map((name) => listOf(json, name));
  const data = buffers.map(({ uri }, i) =>
    uri === undefined && i === 0 ? chunk : typeof uri === 'string' ? decodeUri(uri) : null,
  );

  /** Reads numbers of a type from an offset in a buffer view on. */
  const read = (
    { bufferView, byteOffset = 0, componentType, normalized }: Json,
    count: number,
    size: number,
  ): Float64Array => {
    const view = views[Number(bufferView)];
    const bytes = view && data[Number(view['buffer'])];
    const [length, readOne, one] = types.get(componentType) ?? [0, () => Number.NaN, 1];
    if (!view || !bytes || length === 0) throw corrupt(format, 'has numbers of no known type, or without data');
    const stride = Number(view['byteStride'] ?? length * size);
    const begin = Number(view['byteOffset'] ?? 0) + Number(byteOffset);
    const end = begin + (count - 1) * stride + length * size;
    if (!(begin >= 0 && stride > 0 && end <= bytes.length))
      throw corrupt(
        format,
        `ends early: its data have ${bytes.length.toLocaleString('en')} bytes; expected at least ${end.toLocaleString('en')}`,
      );
    const values = new Float64Array(count * size);
    const reader = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
    const unit = normalized === true ? one : 1;
    for (let i = 0; i < count; i++)
      for (let c = 0; c < size; c++)
        values[i * size + c] = Math.max(
          normalized === true ? -1 : -Infinity,
          readOne(reader, begin + i * stride + c * length) / unit,
        );
    return values;
  };

  return (index) => {
    const accessor = accessors[index];
    const count = Number(accessor['count']);
    const size = sizes.get(accessor['type']);
    if (!size || !(count > 0)) throw corrupt(format, 'has lists of no known kind, or empty ones');
    checkCounts(format, count, 0);
    // Without a buffer view all values are 0.
    const values = accessor['bufferView'] === undefined ? new Float64Array(count * size) : read(accessor, count, size);
    const sparse = accessor['sparse'] as
      | { readonly count?: unknown; readonly indices?: Json; readonly values?: Json }
      | undefined;
    if (sparse?.indices && sparse.values) {
      const few = Number(sparse.count);
      if (!(few > 0 && few <= count)) throw corrupt(format, 'has more numbers that stand apart than numbers');
      const places = read(sparse.indices, few, 1);
      const others = read({ ...accessor, byteOffset: 0, ...sparse.values }, few, size);
      places.forEach(
        (place, i) => place < count && values.set(others.subarray(i * size, (i + 1) * size), place * size),
      );
    }
    return { count, size, values };
  };
}

function decodeUri(uri: string): Uint8Array<ArrayBuffer> | null {
  const [, base64] = /^data:[^,]*;base64,(.*)$/s.exec(uri) ?? [];
  return base64 === undefined ? null : decodeBase64(base64);
}
