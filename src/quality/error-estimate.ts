/**
 * How far a picture is from its converged limit, in 1/255 of the full range, over the pixels that the volume covers: what
 * lies around it does not count.
 */
export interface PictureError {
  /** Root mean square over those pixels and the four premultiplied channels. */
  readonly rms: number;
  /** 99 % of them differ by no more than this in any channel. */
  readonly p99: number;
  /** None is expected to differ by more. null where no bound is known, as a ray that only just misses what is opaque may be off by all of it: `probed` says what there is to say. */
  readonly max: number | null;
  /** The largest difference of the rays that were probed. */
  readonly probed: number;
  /** Their number, of those that met something; 0 where none of them is more than faint: then nothing is to be seen. That no more than 3 / `rays` of all pixels differ by more than `probed` is true with 95 % confidence. */
  readonly rays: number;
}

/** An estimate from some of a picture's rays. */
export interface ErrorEstimate extends Pick<PictureError, 'rms' | 'p99'> {
  /** The largest difference of these rays. */
  readonly max: number;
  /** 99.9 % of the pixels differ by no more than this in any channel; where `isRare`, with 95 % confidence. */
  readonly p999: number;
  /** The order with which the picture converges: halving the step divides the error by 2^order. */
  readonly order: number;
  /** Root mean square from the steps alone, without rounding to 8 bits. */
  readonly discretization: number;
  /** Share of the rays that met something. */
  readonly coverage: number;
  /** Their number; 0 where all of them are too faint to be seen. */
  readonly covered: number;
}

/** Of a picture, one pixel in a thousand may be off by this many times what `max-error` allows. */
export const fewPixelsFactor = 8;

/** What `max-error` limits: the root mean square, and an eighth of what all but one pixel in a thousand keep. */
export function keptError({ rms, p999 }: Pick<ErrorEstimate, 'rms' | 'p999'>): number {
  return Math.max(rms, p999 / fewPixelsFactor);
}

/** Orders outside of this range are noise: the scheme has second order, and half an order where rays graze a jump. */
const orders: readonly [number, number] = [0.5, 2.5];

/** From this order on errors fall evenly, and the limit can be extrapolated. */
const even = 1;

/** Smaller differences (of 1) are float rounding and say nothing about the order. */
const noise = 2e-6;

/** Opacities below this round to nothing. Pixels that have no more would dilute what is wrong in others, as around a cloud that fades. */
const visible = 0.5 / 255;

/** A picture without any pixel of a larger opacity shows nothing: so little contrast nobody sees. */
export const faint = 2 / 255;

/** A picture, and the same rays with finer and finer steps: RGBA, premultiplied, 0..1. */
export interface ProbedPictures {
  readonly shown: ArrayLike<number>;
  /** Half the step of `shown`, or finer. */
  readonly middle: ArrayLike<number>;
  /** Half the step of `middle`. */
  readonly fine: ArrayLike<number>;
  /** Whether `middle` has half the step of `shown`, so that the three tell the order. */
  readonly isEven: boolean;
  /** Whether few of all pixels may be off by much, of which these are a sample, as at the edges of what is opaque. */
  readonly isRare?: boolean;
}

/** In one of so many cases what is said with confidence may be wrong. */
const doubt = 0.05;

/**
 * Of a sample of pixels, that one from the largest on which is no less than what all but a share of all keep, with 95 % confidence: so many of that share are in
 * the sample, as rare things are (Poisson). Where the sample is too small for that it is the largest.
 */
function rankFor(share: number, count: number): number {
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
 * Estimate the error of a picture from pictures of the same rays with finer steps. Their differences give the order of
 * convergence, and with it the limit is extrapolated from the finest picture (Richardson 1911). Where the order is below
 * one, rays graze jumps, each at steps of its own: then errors of finer steps are added as independent ones are.
 */
export function estimateError({ shown, middle, fine, isEven, isRare = false }: ProbedPictures): ErrorEstimate {
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
    let most = 0;
    for (let c = i; c < i + 4; c++) {
      const limit = fine[c] + (fine[c] - middle[c]) * further;
      const off = Math.round(shown[c] * 255) - limit * 255;
      most = Math.max(most, Math.abs(off));
      seen += off ** 2;
      computed += ((shown[c] - limit) * 255) ** 2;
      beyond += ((fine[c] - middle[c]) * 255) ** 2;
    }
    worst.push(most);
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
    p999: isRare ? (worst[covered - rankFor(0.001, covered)] ?? 0) : shareOf(0.999),
    max: worst.at(-1) ?? 0,
    order,
    discretization: mean(computed),
    coverage: covered / Math.max(1, shown.length / 4),
    covered: isFaint(shown) ? 0 : covered,
  };
}

/** Whether nothing is to be seen of what is in a picture, 0..1. */
function isFaint(picture: ArrayLike<number>): boolean {
  for (let alpha = 3; alpha < picture.length; alpha += 4) if (Math.round(picture[alpha] * 255) > 255 * faint) return false;
  return true;
}

/** Pixels of which 8 bits show something in one of the pictures; where there is none, those that are not empty. */
function coverOf(pictures: readonly ArrayLike<number>[]): (alpha: number) => boolean {
  const reaches = (least: number) => (alpha: number): boolean => pictures.some((picture) => picture[alpha] >= least);
  const isSeen = reaches(visible);
  for (let alpha = 3; alpha < pictures[0].length; alpha += 4) if (isSeen(alpha)) return isSeen;
  return reaches(Number.MIN_VALUE);
}

function rmsDifference(a: ArrayLike<number>, b: ArrayLike<number>): number {
  let sum = 0;
  for (let i = 0; i < a.length; i++) sum += (a[i] - b[i]) ** 2;
  return Math.sqrt(sum / Math.max(1, a.length));
}
