import { corruptFile } from '../base/file-problem.ts';

/**
 * Unpacks a frame that is packed by runs: each byte of the numbers, the highest first, is a segment of its own.
 * Source: DICOM PS3.5, annex G
 * @param numbers - bytes of all numbers, little endian
 * @param size - bytes of a number
 */
export function unpackRle(packed: Uint8Array, numbers: Uint8Array, size: number, what: string): void {
  if (packed.length < 64) throw corruptFile(what, 'has packed pixels without a header');
  const view = new DataView(packed.buffer, packed.byteOffset, packed.byteLength);
  const segments = view.getUint32(0, true);
  if (segments !== size)
    throw corruptFile(
      what,
      `has packed pixels in ${segments} segments; expected ${size}, one for each byte of a number`,
    );
  for (let segment = 0; segment < size; segment++) {
    const start = view.getUint32(4 + 4 * segment, true);
    const end = segment + 1 < size ? view.getUint32(8 + 4 * segment, true) : packed.length;
    if (!(start >= 64 && start <= end && end <= packed.length))
      throw corruptFile(what, 'has packed pixels whose segments do not lie in them');
    if (!unpackSegment(packed.subarray(start, end), numbers, { first: size - 1 - segment, step: size }))
      throw corruptFile(what, 'has packed pixels that end early; copy the file again');
  }
}

/** Writes bytes from `first` on, each `step` bytes after the one before. @returns whether all of them were there */
function unpackSegment(
  packed: Uint8Array,
  numbers: Uint8Array,
  { first, step }: { first: number; step: number },
): boolean {
  let out = first;
  for (let at = 0; at < packed.length && out < numbers.length;) {
    const code = packed[at++];
    if (code === 128) continue;
    const isRun = code > 128;
    const count = isRun ? 257 - code : code + 1;
    if (at + (isRun ? 1 : count) > packed.length) return false;
    for (let i = 0; i < count && out < numbers.length; i++, out += step) numbers[out] = packed[isRun ? at : at + i];
    at += isRun ? 1 : count;
  }
  return out >= numbers.length;
}
