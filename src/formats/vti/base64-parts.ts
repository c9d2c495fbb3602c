const letters = 'ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/';

/** Six bits of each letter. */
const bits = new Uint8Array(256).fill(255);
for (let i = 0; i < 64; i++) bits[letters.charCodeAt(i)] = i;

/**
 * Decodes texts of Base64 that follow each other, each padded with "=": VTK encodes the header of an array apart from its
 * data. Blanks are ignored; anything else ends it.
 * Source: RFC 4648, section 4
 * @param most - bytes after which it may stop
 * @returns null if the text begins with other letters
 */
export function decodeBase64Parts(text: Uint8Array, most: number): Uint8Array<ArrayBuffer> | null {
  const bytes = new Uint8Array(Math.min(Math.floor((text.length * 3) / 4), most + 3));
  let [to, held, count] = [0, 0, 0];
  for (let i = 0; i < text.length && to < most; i++) {
    const code = text[i];
    if (code <= 32) continue;
    if (code === 61) {
      // The end of one part: what is left of the last letter is no data.
      [held, count] = [0, 0];
      continue;
    }
    if (bits[code] === 255) return to > 0 && code === 60 ? bytes.subarray(0, to) : null;
    held = ((held << 6) | bits[code]) & 0xffffff;
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes[to++] = (held >> count) & 255;
  }
  return bytes.subarray(0, to);
}
