// JPEG-LS: each number is the difference from what its neighbours predict, and equal ones are counted. Names of variables are those of the
// standard. Source: ITU-T T.87, annex A
import { corruptFile } from '../base/file-problem.ts';
import type { JpegParts } from './jpeg-parts.ts';
import { PackedBits } from './packed-bits.ts';

/** Bits of the lengths of runs. Source: T.87, A.2.1 */
const J = [0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3, 4, 4, 5, 5, 6, 6, 7, 7, 8, 9, 10, 11, 12, 13, 14, 15];

/** The contexts of numbers, then two of numbers that end a run. */
const contexts = 365;

/** @param numbers - of the whole frame, to be written */
export function unpackLs(parts: JpegParts, numbers: Uint16Array): void {
  const { rows, columns, what, restart } = parts;
  const [near, interleave] = parts.selected;
  const maxval = parts.presets[0] || 2 ** parts.precision - 1;
  if (restart > 0 || interleave > 2 || near > Math.min(255, maxval >> 1) || maxval >= 2 ** parts.precision)
    throw corruptFile(
      what,
      'has packed pixels (JPEG-LS) that are damaged, or that start again in between; copy the file again',
    );
  const coder = new LsCoder(parts, near, maxval);
  let [before, line] = [new Int32Array(columns + 2), new Int32Array(columns + 2)];
  for (let row = 0; row < rows; row++) {
    before[columns + 1] = before[columns];
    line[0] = before[1];
    coder.readLine(before, line, columns);
    numbers.set(line.subarray(1, columns + 1), row * columns);
    [before, line] = [line, before];
  }
}

class LsCoder {
  readonly #bits: LsBits;
  readonly #near: number;
  readonly #maxval: number;
  readonly #range: number;
  readonly #qbpp: number;
  readonly #limit: number;
  readonly #thresholds: readonly number[];
  readonly #reset: number;
  readonly #A: Int32Array;
  readonly #B = new Int32Array(contexts);
  readonly #C = new Int32Array(contexts);
  readonly #N = new Int32Array(contexts + 2).fill(1);
  /** How many numbers that ended a run were smaller than predicted. */
  readonly #Nn = new Int32Array(2);
  #run = 0;

  constructor({ bytes, start, presets, what }: JpegParts, near: number, maxval: number) {
    this.#bits = new LsBits(bytes, start, what);
    this.#near = near;
    this.#maxval = maxval;
    this.#range = Math.floor((maxval + 2 * near) / (2 * near + 1)) + 1;
    this.#qbpp = Math.ceil(Math.log2(this.#range));
    const bpp = Math.max(2, Math.ceil(Math.log2(maxval + 1)));
    this.#limit = 2 * (bpp + Math.max(8, bpp));
    this.#thresholds = chooseThresholds(presets, near, maxval);
    this.#reset = presets[4] || 64;
    this.#A = new Int32Array(contexts + 2).fill(Math.max(2, (this.#range + 32) >> 6));
  }

  /** Lines have one number before the first, and one after the last. */
  readLine(before: Int32Array, line: Int32Array, columns: number): void {
    const near = this.#near;
    for (let x = 1; x <= columns;) {
      const [Ra, Rb, Rc, Rd] = [line[x - 1], before[x], before[x - 1], before[x + 1]];
      const isRun = Math.abs(Rd - Rb) <= near && Math.abs(Rb - Rc) <= near && Math.abs(Rc - Ra) <= near;
      if (isRun) x = this.#readRun(before, line, x, columns);
      else {
        line[x] = this.#readNumber(
          Ra,
          Rb,
          Rc,
          this.#quantize(Rd - Rb) * 81 + this.#quantize(Rb - Rc) * 9 + this.#quantize(Rc - Ra),
        );
        x++;
      }
    }
    this.#bits.check();
  }

  #quantize(difference: number): number {
    const [T1, T2, T3] = this.#thresholds;
    const size = Math.abs(difference);
    const level = size <= this.#near ? 0 : size < T1 ? 1 : size < T2 ? 2 : size < T3 ? 3 : 4;
    return difference < 0 ? -level : level;
  }

  /** Source: T.87, A.4 to A.6 */
  #readNumber(Ra: number, Rb: number, Rc: number, signed: number): number {
    const [A, B, C, N] = [this.#A, this.#B, this.#C, this.#N];
    const sign = signed < 0 ? -1 : 1;
    const q = Math.abs(signed);
    const [low, high] = Ra < Rb ? [Ra, Rb] : [Rb, Ra];
    const predicted = (Rc >= high ? low : Rc <= low ? high : Ra + Rb - Rc) + sign * C[q];
    const Px = Math.max(0, Math.min(this.#maxval, predicted));
    let k = 0;
    while (N[q] * 2 ** k < A[q]) k++;
    const mapped = this.#bits.readGolomb(k, this.#limit, this.#qbpp);
    const isTurned = this.#near === 0 && k === 0 && 2 * B[q] <= -N[q];
    const isOdd = mapped % 2 === 1;
    const half = mapped >> 1;
    const error = isTurned ? (isOdd ? half : -half - 1) : isOdd ? -half - 1 : half;
    B[q] += error * (2 * this.#near + 1);
    A[q] += Math.abs(error);
    if (N[q] === this.#reset) {
      A[q] >>= 1;
      B[q] >>= 1;
      N[q] >>= 1;
    }
    N[q]++;
    if (B[q] <= -N[q]) {
      B[q] = Math.max(B[q] + N[q], 1 - N[q]);
      if (C[q] > -128) C[q]--;
    } else if (B[q] > 0) {
      B[q] = Math.min(B[q] - N[q], 0);
      if (C[q] < 127) C[q]++;
    }
    return this.#rebuild(Px, sign * error);
  }

  /** Source: T.87, A.4.5 */
  #rebuild(predicted: number, error: number): number {
    const step = 2 * this.#near + 1;
    const value = predicted + error * step;
    const inRange =
      value < -this.#near
        ? value + this.#range * step
        : value > this.#maxval + this.#near
          ? value - this.#range * step
          : value;
    return Math.max(0, Math.min(this.#maxval, inRange));
  }

  /** Source: T.87, A.7. @returns where the next number is */
  #readRun(before: Int32Array, line: Int32Array, from: number, columns: number): number {
    const value = line[from - 1];
    let x = from;
    while (this.#bits.read(1) === 1) {
      const length = 2 ** J[this.#run];
      const count = Math.min(length, columns + 1 - x);
      line.fill(value, x, x + count);
      x += count;
      if (count === length && this.#run < 31) this.#run++;
      if (x > columns) return x;
    }
    const count = Math.min(this.#bits.read(J[this.#run]), columns - x);
    line.fill(value, x, x + count);
    x += count;
    line[x] = this.#readEnd(value, before[x]);
    if (this.#run > 0) this.#run--;
    return x + 1;
  }

  /** The number that ends a run. Source: T.87, A.7.2 */
  #readEnd(Ra: number, Rb: number): number {
    const [A, N, Nn] = [this.#A, this.#N, this.#Nn];
    const type = Math.abs(Ra - Rb) <= this.#near ? 1 : 0;
    const q = contexts + type;
    const sum = type === 1 ? A[q] + (N[q] >> 1) : A[q];
    let k = 0;
    while (N[q] * 2 ** k < sum) k++;
    const mapped = this.#bits.readGolomb(k, this.#limit - J[this.#run] - 1, this.#qbpp);
    const isOdd = (mapped + type) % 2 === 1;
    const size = (mapped + type + 1) >> 1;
    const error = (k !== 0 || 2 * Nn[type] >= N[q]) === isOdd ? -size : size;
    if (error < 0) Nn[type]++;
    A[q] += (mapped + 1 - type) >> 1;
    if (N[q] === this.#reset) {
      A[q] >>= 1;
      N[q] >>= 1;
      Nn[type] >>= 1;
    }
    N[q]++;
    return this.#rebuild(type === 1 ? Ra : Rb, type === 0 && Ra > Rb ? -error : error);
  }
}

/** Source: T.87, C.2.4.1.1.1 */
function chooseThresholds([, T1, T2, T3]: readonly number[], near: number, maxval: number): readonly number[] {
  const clamp = (value: number, least: number): number => (value > maxval || value < least ? least : value);
  const usual = (basic: number, less: number, times: number): number => {
    if (maxval >= 128) return Math.floor((Math.min(maxval, 4095) + 128) / 256) * (basic - less) + less + times * near;
    return Math.max(less, Math.floor(basic / Math.floor(256 / (maxval + 1))) + times * near);
  };
  const first = T1 || clamp(usual(3, 2, 3), near + 1);
  const second = T2 || clamp(usual(7, 3, 5), first);
  return [first, second, T3 || clamp(usual(21, 4, 7), second)];
}

/** Reads the codes of a JPEG-LS stream. */
class LsBits extends PackedBits {
  constructor(bytes: Uint8Array, at: number, what: string) {
    super(bytes, at, 1, what);
  }

  /** A number in a code with a limited length. Source: T.87, A.5.3 */
  readGolomb(k: number, limit: number, qbpp: number): number {
    let zeros = 0;
    while (zeros < limit && this.read(1) === 0) zeros++;
    if (zeros >= limit - qbpp - 1) return this.read(qbpp) + 1;
    return zeros * 2 ** k + (k > 16 ? this.read(k - 16) * 65536 + this.read(16) : this.read(k));
  }
}
