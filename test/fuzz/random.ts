// The one source of chance of all grammars. It notes what it drew, so that a case can be drawn again with some draws changed:
// such a change is one of structure, since it goes through the grammar, and not one of bytes.

/** Numbers that break readers: the ends of types, and their neighbours. */
const edges = [
  0,
  1,
  2,
  3,
  127,
  128,
  255,
  256,
  32767,
  32768,
  65535,
  65536,
  2 ** 24,
  2 ** 26,
  2 ** 28,
  2 ** 31 - 1,
  2 ** 31,
  2 ** 32 - 1,
  2 ** 40,
  2 ** 53,
];

/** Numbers that break geometry. */
const oddNumbers = [0, -0, -1, 1e-310, 1e-30, -1e30, 1e38, 1e39, 1e150, 1e308, -1e308, NaN, Infinity, -Infinity];

/** Numbers from 0 up to 2^32 that are the same in every run. Source: mulberry32, Tommy Ettinger, public domain. */
function makeDraws(seed: number): () => number {
  let state = seed | 0;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let t = Math.imul(state ^ (state >>> 15), 1 | state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return (t ^ (t >>> 14)) >>> 0;
  };
}

export class Random {
  /** All that was drawn, each from 0 up to 2^32. */
  readonly drawn: number[] = [];
  readonly #draw: () => number;
  readonly #given: readonly number[];
  /** How often a field is not what a sound file has. */
  readonly #wildness: number;
  #isHostile: boolean | null = null;

  /** @param given - draws that come first, of a case before @param isSound - whether nothing is to be wrong */
  constructor(seed: number, given: readonly number[] = [], isSound = false) {
    this.#draw = makeDraws(seed);
    this.#given = given;
    this.#wildness = isSound ? 0 : this.pick([0.0003, 0.001, 0.003, 0.01, 0.05]);
  }

  get isSound(): boolean {
    return this.#wildness === 0;
  }

  /** A whole number from 0 up to 2^32. */
  u32(): number {
    const value = this.#given[this.drawn.length] ?? this.#draw();
    this.drawn.push(value);
    return value;
  }

  /** A number from 0 up to 1. */
  unit(): number {
    return this.u32() / 2 ** 32;
  }

  /** A whole number from `from` to `to`, both included. */
  int(from: number, to: number): number {
    return from + Math.floor(this.unit() * (to - from + 1));
  }

  chance(share: number): boolean {
    return this.unit() < share;
  }

  pick<T>(list: readonly T[]): T {
    return list[this.int(0, list.length - 1)];
  }

  /** Whether something here is to be wrong. */
  isWild(): boolean {
    return this.chance(this.#wildness);
  }

  /** Whether something here is to be there many times, or far larger than its data, as a file of a stranger's may have it. */
  isHostile(): boolean {
    // A case is hostile as a whole: one such thing alone does little.
    this.#isHostile ??= this.chance(0.25);
    return this.#isHostile && !this.isSound && this.chance(0.4);
  }

  /** What a sound file has, or now and then another value. */
  or<T>(sound: T, ...others: readonly T[]): T {
    return this.isWild() ? this.pick(others) : sound;
  }

  /** A count, a length or an address: what a sound file has, or one at the ends of types, or near the sound one. */
  size(sound: number): number {
    if (!this.isWild()) return sound;
    const near = [sound + 1, sound - 1, 2 * sound, Math.floor(sound / 2), -sound];
    return Math.max(0, this.chance(0.3) ? this.pick(near) : this.pick(edges));
  }

  /** A number that stands for a length, an angle or a factor. */
  number(sound: number): number {
    return this.isWild() ? this.pick(oddNumbers) : sound;
  }

  /** Bytes of noise, of one draw. */
  bytes(length: number): Uint8Array<ArrayBuffer> {
    const draw = makeDraws(this.u32());
    return Uint8Array.from({ length }, () => draw() & 0xff);
  }

  /** Items, some of them twice, left out, or in another order where the case is wild. */
  shuffle<T>(items: readonly T[]): T[] {
    const list = [...items];
    if (list.length > 0 && this.isWild()) list.splice(this.int(0, list.length - 1), 1);
    if (list.length > 0 && this.isWild()) list.splice(this.int(0, list.length), 0, this.pick(list));
    if (list.length > 1 && this.isWild())
      list.splice(this.int(0, list.length - 1), 0, ...list.splice(this.int(0, list.length - 1), 1));
    return list;
  }
}

/** Draws of a case, some of them changed, left out or repeated. */
export function mutateDraws(draws: readonly number[], seed: number): number[] {
  const next = makeDraws(seed);
  const below = (count: number): number => Math.floor((next() / 2 ** 32) * count);
  const list = [...draws];
  for (let n = below(4); n >= 0 && list.length > 0; n--) {
    const at = below(list.length);
    const way = below(4);
    if (way === 0) list[at] = next();
    else if (way === 1) list[at] = [0, 2 ** 32 - 1, 2 ** 31, list[below(list.length)]][below(4)];
    else if (way === 2) list.splice(at, 1 + below(4));
    else list.splice(at, 0, ...list.slice(below(list.length)).slice(0, 1 + below(8)));
  }
  return list;
}
