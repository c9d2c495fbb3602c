/** The error of a picture over the pixels that its volume covers, in 1/255. */
export interface CoveredError {
  /** Root mean square over these pixels and their channels. */
  readonly rms: number;
  /** Percentiles over these pixels of the worst channel. */
  readonly p99: number;
  readonly p999: number;
  readonly max: number;
  /** The error that `max-error` limits: the larger of the root mean square and an eighth of the 99.9th percentile. */
  readonly e: number;
  /** Number of these pixels. */
  readonly covered: number;
}

/** Sums up the errors of a picture, pixel by pixel. */
export class ErrorSum {
  readonly #worst: number[] = [];
  #squares = 0;

  /** @param channels - the number of channels of a pixel */
  constructor(readonly channels: number) {}

  /** @param max - the largest error of the pixel's channels, in 1/255 @param squares - the sum of squares of all channels */
  add({ max, squares }: { readonly max: number; readonly squares: number }): void {
    this.#worst.push(max);
    this.#squares += squares;
  }

  result(): CoveredError {
    const worst = Float64Array.from(this.#worst);
    worst.sort();
    const covered = worst.length;
    const at = (share: number): number => worst[Math.min(covered - 1, Math.floor(covered * share))] ?? 0;
    const rms = Math.sqrt(this.#squares / Math.max(1, this.channels * covered));
    const p999 = at(0.999);
    return { rms, p99: at(0.99), p999, max: at(1), e: Math.max(rms, p999 / 8), covered };
  }
}

/**
 * The difference of two pictures in the pixels where one of them is not empty.
 * @param a - RGBA, premultiplied @param scale - factor from their numbers to 1/255
 * @param channels - the number of channels that count: 4; or 3 for pictures over black, where a pixel that is black in both is empty
 */
export function compareCovered(
  a: ArrayLike<number>,
  b: ArrayLike<number>,
  scale: number,
  channels: 3 | 4 = 4,
): CoveredError {
  const sum = new ErrorSum(channels);
  for (let i = 0; i < a.length; i += 4) {
    let [max, squares, isCovered] = [0, 0, false];
    for (let c = i; c < i + channels; c++) {
      const off = scale * Math.abs(a[c] - b[c]);
      max = Math.max(max, off);
      squares += off ** 2;
      isCovered ||= a[c] > 0 || b[c] > 0;
    }
    if (isCovered) sum.add({ max, squares });
  }
  return sum.result();
}
