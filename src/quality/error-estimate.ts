/** What one cause leaves in a picture, in 1/255: see `PictureError`. */
export interface ErrorPart {
  readonly rms: number;
  readonly p99: number;
  /** null where no bound is known. */
  readonly max: number | null;
}

/** What each cause leaves, where there are several: all are in `rms`, `p99` and `max` of the picture's error. Its `probed` and `rays` are of the steps alone. */
export interface ErrorParts {
  readonly steps: ErrorPart;
  /** What a video lost, see `volume.lossy`: estimated for the present transfer function. */
  readonly lossy?: ErrorPart;
  /** What the bricks of a pyramid hide that are not there, see `max-gpu-bytes`: estimated from those that are. */
  readonly detail?: ErrorPart;
}

/**
 * How far a picture is from its converged limit, in 1/255 of the full range. Only pixels that the volume covers count,
 * not those around it. Where `parts` are there, it is how far the picture is from that of the data before they were changed.
 */
export interface PictureError {
  /** Root mean square over those pixels and the four premultiplied channels. */
  readonly rms: number;
  /** 99 % of these pixels differ by at most this in any channel. */
  readonly p99: number;
  /**
   * No pixel is expected to differ by more. null if no bound is known: a ray that only just misses opaque matter may be wrong by the full
   * range. Then see `probed`.
   */
  readonly max: number | null;
  /** The largest difference of the probed rays. */
  readonly probed: number;
  /**
   * Number of probed rays that met something; 0 if all of them are faint, so that nothing is visible. With 95 % confidence, at most a
   * share of 3 / `rays` of all pixels differs by more than `probed`.
   */
  readonly rays: number;
  /** Set where more than the steps changes the picture. */
  readonly parts?: ErrorParts;
}

/** An error estimate from some of a picture's rays. */
export interface ErrorEstimate extends Pick<PictureError, 'rms' | 'p99'> {
  /** The largest difference of these rays. */
  readonly max: number;
  /** 99.9 % of the pixels differ by at most this in any channel; where pictures have a `doubt`, with the confidence that it leaves. */
  readonly p999: number;
  /** The order with which the picture converges: halving the step divides the error by 2^order. */
  readonly order: number;
  /** Root mean square from the steps alone, without rounding to 8 bits. */
  readonly discretization: number;
  /** Share of the rays that met something. */
  readonly coverage: number;
  /** Their number; 0 if all of them are too faint to be visible. */
  readonly covered: number;
}

/** One pixel in a thousand may be off by more than `max-error` times this. */
export const fewPixelsFactor = 8;

/** The error that `max-error` limits: the root mean square or, if larger, an eighth of the error that 99.9 % of the pixels keep. */
export function keptError({ rms, p999 }: Pick<ErrorEstimate, 'rms' | 'p999'>): number {
  return Math.max(rms, p999 / fewPixelsFactor);
}

/** Orders outside of this range are noise: the scheme has second order, and half an order where rays graze a jump. */
const orders: readonly [number, number] = [0.5, 2.5];

/** From this order on, errors fall regularly, and the limit can be extrapolated. */
const even = 1;

/** Smaller differences (of 1) are float rounding and show nothing about the order. */
const noise = 2e-6;

/** Opacities below this are rounded to 0. Pixels with no more than that would dilute the errors of others, as around a cloud that fades. */
const visible = 0.5 / 255;

/** If no pixel has a larger opacity, a picture shows nothing: nobody sees so little contrast. */
export const faint = 2 / 255;

/** A picture, and the same rays with finer and finer steps: RGBA, premultiplied, 0..1. */
export interface ProbedPictures {
  readonly shown: ArrayLike<number>;
  /** Half the step of `shown`, or finer. */
  readonly middle: ArrayLike<number>;
  /** Half the step of `middle`. */
  readonly fine: ArrayLike<number>;
  /** Whether `middle` has half the step of `shown`, so that the three pictures give the order. */
  readonly isEven: boolean;
  /**
   * Where a few of all pixels may be off by much, as at the edges of opaque matter, and the probed pixels are a sample of them: the share of
   * cases in which more than one pixel in a thousand may be off by more than is found.
   */
  readonly doubt?: number;
}

/**
 * For a sample of pixels, the rank from the largest down. Except in a share of cases (`doubt`), the error at this rank is at least what all
 * pixels except a share keep.
 * The number of rare pixels in a sample has a Poisson distribution. If the sample is too small, the rank is that of the largest.
 */
function rankFor(share: number, count: number, doubt: number): number {
  const mean = share * count;
  let [rank, chance, sum] = [0, Math.exp(-mean), 0];
  while (sum + chance <= doubt) {
    sum += chance;
    rank++;
    chance *= mean / rank;
  }
  return Math.max(1, rank);
}

/**
 * Estimates the error of a picture from pictures of the same rays with finer steps. Their differences give the order of
 * convergence; with it, the limit is extrapolated from the finest picture (Richardson 1911). If the order is below
 * one, rays graze jumps, each at other steps. Then the errors of finer steps are added as independent errors.
 */
export function estimateError({ shown, middle, fine, isEven, doubt }: ProbedPictures): ErrorEstimate {
  const first = rmsDifference(shown, middle);
  const second = rmsDifference(middle, fine);
  const isMeasured = isEven && first > noise && second > noise;
  const order = Math.min(orders[1], Math.max(orders[0], isMeasured ? Math.log2(first / second) : 2));
  const further = order < even ? 0 : 1 / (2 ** order - 1);
  let [seen, computed, beyond] = [0, 0, 0];
  const worst: number[] = [];
  const isCovered = coverOf([shown, middle, fine]);
  for (let i = 0; i < shown.length; i += 4) {
    if (!isCovered(i + 3)) continue;
    let max = 0;
    for (let c = i; c < i + 4; c++) {
      const limit = fine[c] + (fine[c] - middle[c]) * further;
      const off = Math.round(shown[c] * 255) - limit * 255;
      max = Math.max(max, Math.abs(off));
      seen += off ** 2;
      computed += ((shown[c] - limit) * 255) ** 2;
      beyond += ((fine[c] - middle[c]) * 255) ** 2;
    }
    worst.push(max);
  }
  const covered = worst.length;
  worst.sort((a, b) => a - b);
  const shareOf = (share: number): number => worst[Math.min(covered - 1, Math.floor(covered * share))] ?? 0;
  const ratio = 2 ** (-2 * order);
  const tail = order < even ? (beyond * ratio) / (1 - ratio) : 0;
  const mean = (sum: number): number => Math.sqrt((sum + tail) / Math.max(1, 4 * covered));
  return {
    rms: mean(seen),
    p99: shareOf(0.99),
    p999: doubt ? (worst[covered - rankFor(0.001, covered, doubt)] ?? 0) : shareOf(0.999),
    max: worst.at(-1) ?? 0,
    order,
    discretization: mean(computed),
    coverage: covered / Math.max(1, shown.length / 4),
    covered: isFaint(shown) ? 0 : covered,
  };
}

/** Whether nothing in a picture (0..1) is visible. */
function isFaint(picture: ArrayLike<number>): boolean {
  for (let alpha = 3; alpha < picture.length; alpha += 4)
    if (Math.round(picture[alpha] * 255) > 255 * faint) return false;
  return true;
}

/** Pixels that are visible with 8 bits in one of the pictures; if there is none, those that are not empty. */
function coverOf(pictures: readonly ArrayLike<number>[]): (alpha: number) => boolean {
  const reaches =
    (min: number) =>
    (alpha: number): boolean =>
      pictures.some((picture) => picture[alpha] >= min);
  const isSeen = reaches(visible);
  for (let alpha = 3; alpha < pictures[0].length; alpha += 4) if (isSeen(alpha)) return isSeen;
  return reaches(Number.MIN_VALUE);
}

function rmsDifference(a: ArrayLike<number>, b: ArrayLike<number>): number {
  let sum = 0;
  for (let i = 0; i < a.length; i++) sum += (a[i] - b[i]) ** 2;
  return Math.sqrt(sum / Math.max(1, a.length));
}
