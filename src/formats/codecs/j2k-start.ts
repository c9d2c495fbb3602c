/** Where a stream of JPEG 2000 begins: at once, or in boxes of a JP2 file, which some programs write; -1 where there is none. */
export function findJ2kStart(bytes: Uint8Array): number {
  for (let at = 0; at + 4 <= Math.min(bytes.length, 4096); at++)
    if (bytes[at] === 0xff && bytes[at + 1] === 0x4f && bytes[at + 2] === 0xff && bytes[at + 3] === 0x51) return at;
  return -1;
}
