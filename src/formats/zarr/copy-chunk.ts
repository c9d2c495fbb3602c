import type { ArrayBox } from './list-chunks.ts';
import type { ZarrArray } from './zarr-array.ts';

/** The numbers of a chunk as whole numbers of their size, whatever they stand for. */
export type Numbers = Uint8Array | Uint16Array | Uint32Array | BigUint64Array;

/** The same bytes as numbers of a size, without their order; copied where they do not begin at a multiple of it. */
export function asNumbers(bytes: Uint8Array<ArrayBuffer>, size: number): Numbers {
  const { buffer, byteOffset, length } = byteOffsetFits(bytes, size) ? bytes : bytes.slice();
  if (size === 1) return new Uint8Array(buffer, byteOffset, length);
  if (size === 2) return new Uint16Array(buffer, byteOffset, length / 2);
  if (size === 4) return new Uint32Array(buffer, byteOffset, length / 4);
  return new BigUint64Array(buffer, byteOffset, length / 8);
}

const byteOffsetFits = ({ byteOffset }: Uint8Array, size: number): boolean => byteOffset % size === 0;

/**
 * Copies what a box needs of a chunk to its places: i fastest, then j and k.
 * @param chunk - the numbers of a chunk @param place - of the chunk, in chunks along each axis
 * @param output - the numbers of the box
 */
export function copyChunk(
  chunk: Numbers,
  place: readonly number[],
  { array, box, output }: { readonly array: ZarrArray; readonly box: ArrayBox; readonly output: Numbers },
): void {
  // Both are of one type, which makes no difference here.
  const [source, target] = [chunk as Uint8Array, output as Uint8Array];
  const steps: number[] = [];
  let step = 1;
  for (let i = array.order.length - 1; i >= 0; i--) {
    steps[array.order[i]] = step;
    step *= array.chunk[array.order[i]];
  }
  const origin = place.map((n, axis) => n * array.chunk[axis]);
  let start = 0;
  for (const [axis, index] of box.at.entries())
    if (!box.axes.includes(axis)) start += (index - origin[axis]) * steps[axis];
  // Along i, j and k: from which voxel to which of the box, and the steps of the chunk.
  const parts = box.axes.map((axis, which) => {
    const chunkStart = axis === null ? 0 : origin[axis];
    const length = axis === null ? 1 : array.chunk[axis];
    const from = Math.max(0, chunkStart - box.first[which]);
    const to = Math.min(box.dimensions[which], chunkStart + length - box.first[which]);
    const stride = axis === null ? 0 : steps[axis];
    return { from, to, stride, base: (from + box.first[which] - chunkStart) * stride };
  });
  const [x, y, z] = parts;
  const [nx, ny] = box.dimensions;
  for (let k = z.from; k < z.to; k++) {
    for (let j = y.from; j < y.to; j++) {
      let from = start + x.base + y.base + (j - y.from) * y.stride + z.base + (k - z.from) * z.stride;
      const row = (k * ny + j) * nx;
      if (x.stride === 1) target.set(source.subarray(from, from + x.to - x.from), row + x.from);
      else for (let i = x.from; i < x.to; i++, from += x.stride) target[row + i] = source[from];
    }
  }
}
