import { emptyQuad, interpolateQuad } from '../optics/between-pixels.ts';
import type { Pixels } from '../optics/between-pixels.ts';

/** What a picture costs and loses if pixels get their own rays only where its curvature is above a limit. */
export interface SamplingOutcome {
  /** The largest second difference between every second pixel that is interpolated over, 1/255; 0 where all get a ray. */
  readonly maxCurvature: number;
  /** Rays cast, as a share of those of the whole picture; above 1 if so little is saved that the tests cost more. */
  readonly share: number;
  /** What interpolation leaves, RMS, 1/255. */
  readonly error: number;
}

/** No pixel is interpolated. */
export const allRays: SamplingOutcome = { maxCurvature: 0, share: 1, error: 0 };

/** Curvature limits that are tried, 1/255. */
const triedCurvatures: readonly number[] = [4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128, 192, 256];

/** Second differences of bytes reach this. */
const largestCurvature = 510;

/** Quads that are tested on each lattice. */
const looks = 4096;

/** Mean square of the rounding error of a byte. */
const rounding = 1 / 12;

/** Quads of 2 x 2 pixels by the curvature of the picture in them. */
interface Quads {
  /** Shares of the whole picture. */
  readonly shares: Float64Array;
  /** What interpolation loses in them: squared errors, as a share of the picture's mean. */
  readonly losses: Float64Array;
  /** Share of the picture in which something is visible. */
  visible: number;
}

/**
 * Predict what adaptive ray sampling does to a picture: rays at every fourth pixel along each axis, then at every second
 * where the curvature is above the limit, then at all where it is again. Graphics processors work on quads of at least
 * 2 x 2 pixels, so a pixel that needs a ray costs four.
 * @param picture - drawn with all its rays
 * @param stride - of the pixels that a smaller picture would have of this one's
 */
export function predictSampling(picture: Pixels, stride = 1): SamplingOutcome[] {
  const fine = lookAtQuads(picture, stride);
  const coarse = lookAtQuads(picture, 2 * stride);
  if (fine.visible === 0) return [];
  return triedCurvatures.map((maxCurvature) => {
    let cast = fine.visible / 16;
    let loss = 0;
    for (let curvature = 0; curvature <= largestCurvature; curvature++) {
      if (curvature > maxCurvature) cast += fine.shares[curvature] + coarse.shares[curvature] / 4;
      // An error in the picture of every second pixel is also in what is interpolated from it.
      else loss += fine.losses[curvature] + coarse.losses[curvature];
    }
    return { maxCurvature, share: cast / fine.visible, error: Math.sqrt(Math.max(0, loss)) };
  });
}

/** @param stride - of the pixels that are predicted; every second of them is known */
function lookAtQuads(picture: Pixels, stride: number): Quads {
  const { data, width, height } = picture;
  const [columns, rows] = [width, height].map((pixels) => Math.floor(pixels / (2 * stride)));
  const every = Math.max(1, Math.sqrt((columns * rows) / looks));
  const found: Quads = { shares: new Float64Array(largestCurvature + 1), losses: new Float64Array(largestCurvature + 1), visible: 0 };
  const quad = emptyQuad();
  let seen = 0;
  for (let y = 0; y < rows; y += every) {
    for (let x = 0; x < columns; x += every) {
      const place = [Math.floor(x), Math.floor(y)] as const;
      interpolateQuad(picture, 2 * stride, place, quad);
      let [loss, alpha] = [-12 * rounding, 0];
      for (let i = 0; i < 4; i++) {
        const at = 4 * stride * ((2 * place[1] + (i >> 1)) * width + 2 * place[0] + (i & 1));
        for (let c = 0; c < 4; c++) loss += i > 0 ? (quad.colors[4 * i + c] - data[at + c]) ** 2 : 0;
        alpha = Math.max(alpha, data[at + 3]);
      }
      seen++;
      found.shares[quad.curvature]++;
      if (alpha === 0) continue;
      found.losses[quad.curvature] += loss / 16;
      found.visible++;
    }
  }
  for (let curvature = 0; curvature <= largestCurvature; curvature++) {
    found.shares[curvature] /= seen;
    found.losses[curvature] /= seen;
  }
  found.visible /= seen;
  return found;
}

/**
 * The adaptive sampling with which a picture of a given error takes the shortest time, with the steps that it then needs.
 * @param maxError - RMS, 1/255, of steps and interpolation together
 * @param order - halving the step divides its error by 2^order
 */
export function chooseSampling(outcomes: readonly SamplingOutcome[], maxError: number, order: number): SamplingOutcome {
  const cost = ({ share, error }: SamplingOutcome): number =>
    (error < maxError ? share * (maxError ** 2 - error ** 2) ** (-0.5 / order) : Infinity);
  const best = outcomes.reduce((a, b) => (cost(b) < cost(a) ? b : a), allRays);
  return cost(best) < worthwhile * cost(allRays) ? best : allRays;
}

/** The largest share of `maxError` that interpolation is planned to take. */
const aim = 0.9;

/** With a larger curvature, interpolation shows stairs along edges, however small the root mean square is. */
const curvaturePerError = 32;

/**
 * The adaptive sampling of a picture at rest.
 * @param maxError - RMS, 1/255, of steps, interpolation and rounding to 8 bits together
 * @param measured - how much larger the error was than predicted, and the curvature limit that was too large
 */
export function chooseAtRest(
  outcomes: readonly SamplingOutcome[], maxError: number, order: number, { worse = 1, below = Infinity } = {},
): SamplingOutcome {
  const left = Math.sqrt(Math.max(0, (aim * maxError) ** 2 - rounding));
  const possible = outcomes.filter(({ maxCurvature }) => maxCurvature < below && maxCurvature <= curvaturePerError * maxError);
  return chooseSampling(possible.map((one) => ({ ...one, error: one.error * worse })), left, order);
}

/** Saving less than a tenth is not worth it: a prediction from a few rows is only roughly right for all. */
const worthwhile = 0.9;
