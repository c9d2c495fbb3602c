/** True if bytes begin as a ZIP archive: with a file, with the end of an empty archive, or with the mark of one in parts. */
export function isZip(bytes: Uint8Array): boolean {
  return bytes[0] === 0x50 && bytes[1] === 0x4b && bytes[2] < 9;
}
