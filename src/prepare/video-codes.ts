import type { LossyError } from '../volume/volume.ts';

export type { Lossy, LossyError } from '../volume/volume.ts';

/** How the values of all frames of a video are numbers of 8 bits. Value = slope * code + intercept. */
export interface CodeScale {
  readonly slope: number;
  readonly intercept: number;
  /** The code of the smallest value. */
  readonly first: number;
  /** Codes below this have no data; 0 where all have. A lossy codec makes other numbers near 0 of 0. */
  readonly noDataBelow: number;
}

const highest = 255;

/** The value of pixels that are no place of the volume, as those of empty tiles. */
export const unused = Infinity;

/** Codes between those without data and those of the smallest value, where the video is lossy. */
const gap = 24;

/** The values of frames, as far as they have been seen. */
export class ValueRange {
  #low = Infinity;
  #high = -Infinity;
  #step: number | null = null;
  /** A value, from which others are whole steps away. */
  #origin: number | null = null;
  #isEven = true;
  #hasNoData = false;

  /** @param step - between two values of this frame, where it has whole numbers of such a step; @param values - NaN for no data, `unused` for no place of the volume */
  add(values: Float64Array, step: number): void {
    if (this.#step === null) this.#step = step;
    else this.#isEven &&= this.#step === step;
    for (const value of values) {
      if (value === unused) continue;
      if (!(value > -Infinity && value < Infinity)) this.#hasNoData = true;
      else {
        if (value < this.#low) this.#low = value;
        if (value > this.#high) this.#high = value;
        this.#origin ??= value;
        const steps = Math.abs(value - this.#origin) / Math.abs(step);
        if (this.#isEven && Math.abs(steps - Math.round(steps)) > 1e-6 * Math.max(1, steps)) this.#isEven = false;
      }
    }
  }

  /** One scale for all frames: the steps of the values where they have room, else as many as there are codes. */
  scale(isLossy: boolean): CodeScale {
    const first = this.#hasNoData ? (isLossy ? gap : 1) : 0;
    const [low, high] = this.#high < this.#low ? [0, 0] : [this.#low, this.#high];
    const step = Math.abs(this.#step ?? 1);
    const isExact = this.#isEven && (high - low) / step <= highest - first;
    const slope = isExact || high === low ? step : (high - low) / (highest - first);
    const noDataBelow = this.#hasNoData ? Math.ceil(first / 2) : 0;
    return { slope, intercept: low - first * slope, first, noDataBelow };
  }
}

/** The codes of values; NaN becomes 0. */
export function encodeValues(values: Float64Array, { slope, intercept, first }: CodeScale): Uint8Array<ArrayBuffer> {
  return Uint8Array.from(values, (value) =>
    Number.isFinite(value) ? Math.min(highest, Math.max(first, Math.round((value - intercept) / slope))) : 0,
  );
}

/** Adds up how far values are from those before. */
export class LossySum {
  /** Differences by size, in parts of a code. */
  readonly #counts: Float64Array;
  #squares = 0;
  #count = 0;
  #max = 0;
  /** Places that have data before or after alone. */
  changed = 0;

  constructor(private readonly scale: CodeScale) {
    this.#counts = new Float64Array(partsOfCode * (highest + 2));
  }

  /** @param before - values, NaN for no data, `unused` is left out @param codes - of the video */
  add(before: Float64Array, codes: Uint8Array): void {
    const { slope, intercept, noDataBelow } = this.scale;
    for (let i = 0; i < before.length; i++) {
      if (before[i] === unused) continue;
      const had = Number.isFinite(before[i]);
      const has = codes[i] >= noDataBelow;
      if (had !== has) this.changed++;
      if (!had || !has) continue;
      const off = Math.abs(slope * codes[i] + intercept - before[i]);
      this.#squares += off * off;
      this.#count++;
      if (off > this.#max) this.#max = off;
      this.#counts[Math.min(this.#counts.length - 1, Math.ceil((off / Math.abs(slope)) * partsOfCode))]++;
    }
  }

  /** In data values. `p99` is rounded up by a 64th of a code. */
  get error(): LossyError {
    let [at, sum] = [0, this.#counts[0]];
    while (sum < 0.99 * this.#count) sum += this.#counts[++at];
    return {
      rms: Math.sqrt(this.#squares / Math.max(1, this.#count)),
      p99: Math.min(this.#max, (at * Math.abs(this.scale.slope)) / partsOfCode),
      max: this.#max,
    };
  }
}

const partsOfCode = 64;
