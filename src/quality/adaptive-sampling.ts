import { emptyQuad, interpolateQuad } from '../optics/rays/between-pixels.ts';
import type { Pixels } from '../optics/rays/between-pixels.ts';
import { needsRays } from '../optics/rays/depth-jumps.ts';
import type { SamplingOutcome } from './sampling-outcome.ts';
import type { Waiting } from '../core/waiting.ts';
import { withoutThin } from './without-thin.ts';

/** Curvature limits to try, in 1/255. */
const triedCurvatures: readonly number[] = [4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128, 192, 256];

/** The largest second difference of bytes. */
const largestCurvature = 510;

/** About this many quads are tested on each lattice. */
const looks = 4096;

/** Mean square of the rounding error of a byte. */
const rounding = 1 / 12;

/** The picture of a volume that has opaque shapes in it. */
export interface AmongShapes {
  /** The picture of the volume alone. */
  readonly picture: Pixels;
  /**
   * The effect of shapes on the quads of a lattice with a stride, see optics/rays/depth-jumps.ts. Lines and points have no effect on coarse
   * lattices. @returns a function that reads the result; call it before others are drawn
   */
  readonly startJumps: (stride: number, isCoarse: boolean) => () => Pixels;
}

/** Quads of 2 x 2 pixels by the curvature of the picture in them. */
interface Quads {
  /** Shares of the whole picture. */
  readonly shares: Float64Array;
  /** What interpolation loses in them: squared errors, as a share of the whole picture's mean. */
  readonly losses: Float64Array;
  /** Share of the picture in which something is visible. */
  visible: number;
}

/**
 * Predicts how adaptive ray sampling changes a picture. It casts rays at every fourth pixel along each axis, then at every second
 * where the curvature is above the limit, then at every pixel where it still is. Graphics processors work on quads of at least
 * 2 x 2 pixels, so a pixel that needs a ray costs four.
 * @param picture - drawn with all its rays
 * @param stride - distance of the pixels of this picture that a smaller picture would have
 */
export function predictSampling(picture: Pixels, stride = 1): SamplingOutcome[] {
  return weigh(lookAtQuads(picture, stride), lookAtQuads(picture, 2 * stride));
}

function weigh(fine: Quads, coarse: Quads): SamplingOutcome[] {
  if (fine.visible === 0) return [];
  return triedCurvatures.map((maxCurvature) => {
    let cast = fine.visible / 16;
    let loss = 0;
    for (let curvature = 0; curvature <= largestCurvature; curvature++) {
      if (curvature > maxCurvature) cast += fine.shares[curvature] + coarse.shares[curvature] / 4;
      // An error in the picture of every second pixel is also in the pixels interpolated from it.
      else loss += fine.losses[curvature] + coarse.losses[curvature];
    }
    return { maxCurvature, share: cast / fine.visible, error: Math.sqrt(Math.max(0, loss)) };
  });
}

/**
 * The same at several strides.
 * @param among - if there are shapes in the picture: the volume's part of it
 */
export function* forecastSampling(
  picture: Pixels,
  strides: readonly number[],
  among: AmongShapes | null,
): Waiting<SamplingOutcome[][]> {
  function* waitForJumps(stride: number, isCoarse: boolean): Waiting<Pixels | undefined> {
    const read = among?.startJumps(stride, isCoarse);
    yield;
    return read?.();
  }
  const thin = yield* waitForJumps(1, false);
  const lattices = among && thin ? withoutThin(among.picture, thin) : picture;
  const outcomes: SamplingOutcome[][] = [];
  for (const stride of strides) {
    const fine = lookAtQuads(lattices, stride, yield* waitForJumps(stride, false));
    outcomes.push(weigh(fine, lookAtQuads(lattices, 2 * stride, yield* waitForJumps(2 * stride, true))));
  }
  return outcomes;
}

/** @param stride - distance of the pixels that are predicted; every second of them is known */
function lookAtQuads(picture: Pixels, stride: number, jumps?: Pixels): Quads {
  const { data, width, height } = picture;
  const [columns, rows] = [width, height].map((pixels) => Math.floor(pixels / (2 * stride)));
  const every = Math.max(1, Math.sqrt((columns * rows) / looks));
  const found: Quads = {
    shares: new Float64Array(largestCurvature + 1),
    losses: new Float64Array(largestCurvature + 1),
    visible: 0,
  };
  const quad = emptyQuad();
  let seen = 0;
  for (let y = 0; y < rows; y += every) {
    for (let x = 0; x < columns; x += every) {
      const place = [Math.floor(x), Math.floor(y)] as const;
      interpolateQuad(picture, 2 * stride, place, quad);
      if (jumps && needsRays(jumps.data[4 * (place[1] * jumps.width + place[0])] / 255, quad.brightest / 255))
        quad.curvature = largestCurvature;
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
