import { passPiece, searchPiece, weighPiece } from './line-pieces.ts';
import type { ProjectionKind } from './ray-style.ts';
import type { CubicPiece, GatherStage, Path, Sample, Seen, Segment } from './ray-stages.ts';

/** Rounds of samples around a possible extreme. Each round has a quarter of the previous round's step. */
export const refinements = 2;

/**
 * Shows one value per ray in the transfer function's colours. The largest opacity counts as 1: neither reference length
 * nor steps matter. A ray without data is transparent. Twin: shaders/chunks/gather/extreme.glsl and average.glsl
 * @param threshold - see `RayStyle.intensityThreshold`
 */
export function projectionGather(kind: ProjectionKind, threshold?: number): GatherStage {
  return kind === 'average' ? averageGather : (seen) => gatherExtreme(seen, kind === 'max' ? 1 : -1, threshold);
}

/** A value times the sign, and its place on the ray. */
interface Found {
  readonly value: number;
  readonly at: number;
}

function gatherExtreme({ classify, step }: Seen, sign: 1 | -1, threshold?: number): ReturnType<GatherStage> {
  const search = seekExtreme(step, sign, { threshold });
  return {
    add: (segment) => search.add(segment),
    addPiece: (piece, path) => search.addPiece(piece, path),
    chooseSubsteps: () => 1,
    finish: (path) => {
      const found = path && search.find(path);
      return found ? classify.classifyValue(sign * found.value) : [0, 0, 0, 0];
    },
  };
}

/**
 * Finds the largest value or, with sign -1, the smallest. For pieces between kinks it is exact. For samples, the error is of second order;
 * if steps are shorter than a voxel, it is of first order, as tri-linear interpolation has kinks at planes of voxels' centres. So more
 * samples are taken: at the top of the parabola through the three samples around the largest, and where straight lines from both sides
 * meet.
 * @param counts - whether a sample counts
 * @param threshold - if given, the first local extreme from this value on counts; if there is none, that of the whole ray
 */
export function seekExtreme(
  step: number,
  sign: 1 | -1,
  {
    counts = ({ valid }) => valid,
    threshold,
  }: { readonly counts?: (sample: Sample, at: number) => boolean; readonly threshold?: number } = {},
): { add(segment: Segment): void; addPiece(piece: CubicPiece, path: Path): void; find(path: Path): Found | null } {
  let best: Found = { value: -Infinity, at: 0 };
  let isExact = false;
  const consider = (sample: Sample, at: number): number => {
    const value = sign * sample.value;
    if (counts(sample, at) && value > best.value) best = { value, at };
    return best.value;
  };
  let isPast = false;
  const pass = (sample: Sample, at: number): void => {
    isPast ||=
      threshold !== undefined &&
      counts(sample, at) &&
      best.value >= sign * threshold &&
      sign * sample.value < best.value;
    if (!isPast) consider(sample, at);
  };
  return {
    add: ({ front, back, begin, span }) => {
      pass(front, begin);
      pass(back, begin + span);
    },
    addPiece: (piece, { sampleAt }) => {
      isExact = true;
      if (threshold !== undefined) passPiece(piece, sign, sampleAt, pass);
      else searchPiece(piece, sign, sampleAt, consider);
    },
    find: (path) => {
      if (best.value === -Infinity) return null;
      if (isExact) return best;
      for (let round = 0; round < refinements; round++)
        refine(best, { path, reach: step / 4 ** round, sign }, consider);
      return best;
    },
  };
}

/** Takes samples around the best one: at distances of up to two reaches, and where these suggest a peak. */
function refine(
  best: Found,
  { path, reach, sign }: { readonly path: Path; readonly reach: number; readonly sign: 1 | -1 },
  consider: (sample: Sample, at: number) => unknown,
): void {
  const probe = (at: number): number => {
    const found = path.sampleAt(at);
    consider(found, at);
    return found.valid ? sign * found.value : best.value;
  };
  const { pieces } = path;
  const [first, last] = pieces[pieces.length > 1 && best.at >= pieces[1][0] ? 1 : 0]; // The begin is exact, but an end may be rounded.
  const places = [-2, -1, 1, 2].map((steps) => Math.min(last, Math.max(first, best.at + steps * reach)));
  for (const at of findPeaks(best, places.map(probe), places)) probe(at);
}

/**
 * Places where a peak may be: the top of the parabola through three samples, and where straight lines from two sides meet, in
 * front and behind.
 * @param values - at two places before the best one, and at two after it
 */
function findPeaks(best: Found, values: readonly number[], places: readonly number[]): number[] {
  const before = best.at - places[1];
  const after = places[2] - best.at;
  const rise = divide(best.value - values[1], before);
  const fall = divide(values[2] - best.value, after);
  const curvature = divide(fall - rise, before + after);
  const slope = divide(rise * after + fall * before, before + after);
  const outerRise = divide(values[1] - values[0], places[1] - places[0]);
  const outerFall = divide(values[3] - values[2], places[3] - places[2]);
  const top = curvature < 0 ? -0.5 * divide(slope, curvature) : 0;
  const kinkBefore = divide(values[1] - best.value + outerRise * before, fall - outerRise);
  const kinkAfter = divide(values[2] - best.value - outerFall * after, rise - outerFall);
  const within = (offset: number, from: number, to: number): number => best.at + Math.min(to, Math.max(from, offset));
  return [within(top, -before, after), within(kinkBefore, -before, 0), within(kinkAfter, 0, after)];
}

function divide(a: number, b: number): number {
  return a / (Math.abs(b) < 1e-20 ? 1e-20 : b);
}

/** The integral over the length that has data, divided by that length: exact between kinks, with trapezoids between samples. */
const averageGather: GatherStage = ({ classify }) => {
  const { weigh, find } = meanOf();
  return {
    add: ({ front, back, span }) => {
      weigh(front, span / 2);
      weigh(back, span / 2);
    },
    addPiece: (piece, { sampleAt }) => weighPiece(piece, sampleAt, weigh),
    chooseSubsteps: () => 1,
    finish: () => {
      const { value, valid } = find();
      return valid ? classify.classifyValue(value) : [0, 0, 0, 0];
    },
  };
};

/** A running mean. The mean of a constant is that constant, to the last bit. */
function meanOf(): { weigh(sample: Sample, span: number): void; find(): Sample } {
  let [mean, length] = [0, 0];
  return {
    weigh: ({ value, valid }, span) => {
      if (!valid || !(span > 0)) return;
      length += span;
      mean += (value - mean) * (span / length);
    },
    find: () => (length > 0 ? { value: mean, valid: true } : nothing),
  };
}

const nothing: Sample = { value: NaN, valid: false };

/** Combines all values of a line into one, from kink to kink. */
export function mergeLine(kind: ProjectionKind): {
  addPiece(piece: CubicPiece, path: Path): void;
  find(path: Path): Sample;
} {
  if (kind === 'average') {
    const { weigh, find } = meanOf();
    return { addPiece: (piece, { sampleAt }) => weighPiece(piece, sampleAt, weigh), find };
  }
  const sign = kind === 'max' ? 1 : -1;
  const { addPiece, find } = seekExtreme(0, sign);
  return {
    addPiece,
    find: (path) => {
      const found = find(path);
      return found ? { value: sign * found.value, valid: true } : nothing;
    },
  };
}
