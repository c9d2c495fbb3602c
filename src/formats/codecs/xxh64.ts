// Zstandard's checksum. Source: XXH64, https://github.com/Cyan4973/xxHash/blob/dev/doc/xxhash_spec.md

const primes = [
  0x9e3779b185ebca87n,
  0xc2b2ae3d27d4eb4fn,
  0x165667b19e3779f9n,
  0x85ebca77c2b2ae63n,
  0x27d4eb2f165667c5n,
] as const;
const mask = 0xffffffffffffffffn;
const turn = (value: bigint, by: bigint): bigint => ((value << by) | (value >> (64n - by))) & mask;
const times = (a: bigint, b: bigint): bigint => (a * b) & mask;
const mix = (sum: bigint, word: bigint): bigint => times(turn((sum + times(word, primes[1])) & mask, 31n), primes[0]);

/** The low 32 bits of the hash of bytes. */
export function xxh64(bytes: Uint8Array): number {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  let at = bytes.length - (bytes.length % 32);
  let hash = at > 0 ? joinLanes(addStripes(view, at)) : primes[4];
  hash = (hash + BigInt(bytes.length)) & mask;
  for (; at + 8 <= bytes.length; at += 8) {
    hash ^= mix(0n, view.getBigUint64(at, true));
    hash = (times(turn(hash, 27n), primes[0]) + primes[3]) & mask;
  }
  for (; at + 4 <= bytes.length; at += 4) {
    hash ^= times(BigInt(view.getUint32(at, true)), primes[0]);
    hash = (times(turn(hash, 23n), primes[1]) + primes[2]) & mask;
  }
  for (; at < bytes.length; at++) hash = times(turn(hash ^ times(BigInt(bytes[at]), primes[4]), 11n), primes[0]);
  hash = times(hash ^ (hash >> 33n), primes[1]);
  hash = times(hash ^ (hash >> 29n), primes[2]);
  return Number((hash ^ (hash >> 32n)) & 0xffffffffn);
}

function joinLanes(lanes: readonly bigint[]): bigint {
  const turns = [1n, 7n, 12n, 18n];
  const sum = lanes.reduce((all, lane, i) => (all + turn(lane, turns[i])) & mask, 0n);
  return lanes.reduce((hash, lane) => (times(hash ^ mix(0n, lane), primes[0]) + primes[3]) & mask, sum);
}

const half = (value: bigint, shift: bigint): number => Number((value >> shift) & 0xffffffffn);
const [high1, low1] = [half(primes[0], 32n), half(primes[0], 0n)];
const [high2, low2] = [half(primes[1], 32n), half(primes[1], 0n)];

/** The four sums over all stripes of 32 bytes. Big integers would take ten times as long: each number is two of 32 bits. */
function addStripes(view: DataView, end: number): bigint[] {
  const starts = [(primes[0] + primes[1]) & mask, primes[1], 0n, -primes[0] & mask];
  const high = Int32Array.from(starts, (start) => half(start, 32n));
  const low = Int32Array.from(starts, (start) => half(start, 0n));
  for (let at = 0; at < end; at += 8) {
    const lane = (at >> 3) & 3;
    const [a, b] = [view.getUint32(at + 4, true), view.getUint32(at, true)];
    // sum + word * prime 2
    let top = multiplyTop(a, b, high2, low2);
    let bottom = (low[lane] >>> 0) + (Math.imul(b, low2) >>> 0);
    top = (top + high[lane] + (bottom > 0xffffffff ? 1 : 0)) | 0;
    bottom |= 0;
    // turned by 31, times prime 1
    const turnedTop = (top << 31) | (bottom >>> 1);
    const turnedBottom = (bottom << 31) | (top >>> 1);
    high[lane] = multiplyTop(turnedTop, turnedBottom >>> 0, high1, low1);
    low[lane] = Math.imul(turnedBottom, low1);
  }
  return Array.from(high, (top, lane) => (BigInt(top >>> 0) << 32n) | BigInt(low[lane] >>> 0));
}

/** The upper half of the low 64 bits of a product. @param b, d - lower halves, without a sign */
function multiplyTop(a: number, b: number, c: number, d: number): number {
  const [b0, b1, d0, d1] = [b & 0xffff, b >>> 16, d & 0xffff, d >>> 16];
  const first = b1 * d0 + ((b0 * d0) >>> 16);
  const second = b0 * d1 + (first % 65536);
  const carried = b1 * d1 + Math.floor(first / 65536) + Math.floor(second / 65536);
  return (carried + Math.imul(a, d) + Math.imul(b, c)) | 0;
}
