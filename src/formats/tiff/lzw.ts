// Source: TIFF 6.0, section 13

const [clear, end, firstCode] = [256, 257, 258];
const maxCodes = 4096;

/** Unpacks LZW with codes of 9 to 12 bits, until `out` is full. @returns bytes written; null where the data are damaged */
export function unpackLzw(packed: Uint8Array, out: Uint8Array): number | null {
  // A code stands for the bytes of another one, and one byte more.
  const before = new Uint16Array(maxCodes);
  const [first, last] = [new Uint8Array(maxCodes), new Uint8Array(maxCodes)];
  const lengths = new Uint16Array(maxCodes);
  for (let code = 0; code < 256; code++) {
    first[code] = last[code] = code;
    lengths[code] = 1;
  }
  let [bits, count, width, next, previous] = [0, 0, 9, firstCode, -1];
  let [at, written] = [0, 0];
  while (written < out.length) {
    while (count < width && at < packed.length) {
      bits = ((bits << 8) | packed[at++]) & 0xffffff;
      count += 8;
    }
    if (count < width) return written;
    const code = (bits >> (count - width)) & ((1 << width) - 1);
    count -= width;
    if (code === end) return written;
    if (code === clear) {
      [width, next, previous] = [9, firstCode, -1];
      continue;
    }
    // The newest code may be used before it is known: it is the one before, and its own first byte.
    if (code > next || (code === next && previous < 0) || (code >= next && next === maxCodes)) return null;
    if (previous >= 0 && next < maxCodes) {
      before[next] = previous;
      lengths[next] = lengths[previous] + 1;
      first[next] = first[previous];
      last[next] = first[code === next ? previous : code];
      next++;
    }
    const length = lengths[code];
    for (let i = length - 1, one = code; i >= 0; i--, one = before[one])
      if (written + i < out.length) out[written + i] = last[one];
    written += length;
    previous = code;
    if (next + 1 >= 1 << width && width < 12) width++;
  }
  return out.length;
}
