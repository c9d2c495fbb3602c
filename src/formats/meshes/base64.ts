const letters = 'ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/';

/** Six bits of each letter. */
const bits = new Uint8Array(128).fill(255);
for (let i = 0; i < 64; i++) bits[letters.charCodeAt(i)] = i;

/**
 * Decodes a Base64 text and ignores its blanks and line breaks. Source: RFC 4648, section 4
 * @returns null if it has other letters
 */
export function decodeBase64(text: string): Uint8Array<ArrayBuffer> | null {
  const bytes = new Uint8Array(Math.floor((text.length * 3) / 4));
  let [at, held, count] = [0, 0, 0];
  for (let i = 0; i < text.length; i++) {
    const code = text.charCodeAt(i);
    if (code <= 32 || code === 61) continue; // Blanks, and "=" at the end.
    const six = code < 128 ? bits[code] : 255;
    if (six === 255) return null;
    held = ((held << 6) | six) & 0xffffff;
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes[at++] = (held >> count) & 255;
  }
  return bytes.subarray(0, at);
}
