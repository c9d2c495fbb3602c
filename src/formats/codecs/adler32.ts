/** zlib's checksum. Source: RFC 1950, 8.2; sums are reduced every 5,552 bytes, before they pass 2^32. */
export class Adler32 {
  #low = 1;
  #high = 0;

  add(bytes: Uint8Array): void {
    let [low, high] = [this.#low, this.#high];
    for (let start = 0; start < bytes.length; start += 5552) {
      const end = Math.min(start + 5552, bytes.length);
      for (let i = start; i < end; i++) {
        low += bytes[i];
        high += low;
      }
      low %= 65521;
      high %= 65521;
    }
    [this.#low, this.#high] = [low, high];
  }

  get value(): number {
    return this.#high * 65536 + this.#low;
  }
}
