/** How far a picture is from its converged limit, in 1/255 of the full range. */
export interface PictureError {
  /** Root mean square over all pixels and the four premultiplied channels. */
  readonly rms: number;
  /** 99 % of the pixels differ by no more than this in any channel. */
  readonly p99: number;
}

/** An estimate, and the order with which the picture converges: halving the step divides the error by 2^order. */
export interface ErrorEstimate extends PictureError {
  readonly order: number;
  /** Root mean square from the steps alone, without rounding to 8 bits and interpolation between pixels. */
  readonly discretization: number;
}

/** Orders outside of this range are noise: the scheme has second order, and first order where a ray grazes a jump. */
const orders: readonly [number, number] = [1, 2.5];

/** Smaller differences (of 1) are float rounding and say nothing about the order. */
const noise = 2e-6;

/**
 * Estimate the error of a picture from pictures of the same rays with the step halved once and twice. Their differences
 * give the order of convergence, and with it the limit is extrapolated from the finest picture (Richardson 1911).
 * @param pictures - the picture, with half its step, and with a quarter: arrays of RGBA, premultiplied, 0..1
 * @param shown - the displayed bytes of the same pixels, if they differ from the picture's by more than rounding
 */
export function estimateError(
  pictures: readonly [ArrayLike<number>, ArrayLike<number>, ArrayLike<number>], shown?: ArrayLike<number>,
): ErrorEstimate {
  const [coarse, middle, fine] = pictures;
  const first = rmsDifference(coarse, middle);
  const second = rmsDifference(middle, fine);
  const measured = first > noise && second > noise ? Math.log2(first / second) : 2;
  const order = Math.min(orders[1], Math.max(orders[0], measured));
  const further = 1 / (2 ** order - 1);
  let seen = 0;
  let computed = 0;
  const worst: number[] = [];
  for (let i = 0; i < coarse.length; i += 4) {
    let most = 0;
    for (let c = i; c < i + 4; c++) {
      const limit = fine[c] + (fine[c] - middle[c]) * further;
      const off = (shown ? shown[c] : Math.round(coarse[c] * 255)) - limit * 255;
      most = Math.max(most, Math.abs(off));
      seen += off ** 2;
      computed += ((coarse[c] - limit) * 255) ** 2;
    }
    worst.push(most);
  }
  worst.sort((a, b) => a - b);
  return {
    rms: Math.sqrt(seen / coarse.length),
    p99: worst[Math.min(worst.length - 1, Math.floor(worst.length * 0.99))] ?? 0,
    order,
    discretization: Math.sqrt(computed / coarse.length),
  };
}

function rmsDifference(a: ArrayLike<number>, b: ArrayLike<number>): number {
  let sum = 0;
  for (let i = 0; i < a.length; i++) sum += (a[i] - b[i]) ** 2;
  return Math.sqrt(sum / Math.max(1, a.length));
}
