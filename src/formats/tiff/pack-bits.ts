/** Unpacks runs of bytes until `out` is full. @returns bytes written. Source: TIFF 6.0, section 9 */
export function unpackBits(packed: Uint8Array, out: Uint8Array): number {
  let written = 0;
  for (let at = 0; at < packed.length && written < out.length;) {
    const code = packed[at++];
    if (code === 128) continue;
    if (code > 128) {
      out.fill(packed[at++] ?? 0, written, written + 257 - code);
      written += 257 - code;
      continue;
    }
    const bytes = packed.subarray(at, at + Math.min(code + 1, out.length - written));
    out.set(bytes, written);
    written += bytes.length;
    at += code + 1;
  }
  return Math.min(written, out.length);
}
