import { add, scale } from '../../volume/matrix.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import { countSteps } from './count-steps.ts';
import type {
  CubicPiece,
  FieldStage,
  Gathering,
  Interval,
  Path,
  RayStages,
  Sample,
  SecondFieldStage,
  Seen,
} from './ray-stages.ts';
import type { Ray } from './rays.ts';
import { composite } from './segment.ts';
import { slackOf } from './slack.ts';
import type { Premultiplied } from '../transfer/transfer-function.ts';

/**
 * Casts one ray in plain float64. The ray is cut into steps from its entry on; the last step is the rest. Steps on which more must be
 * seen are cut into substeps. Along each, the data value is assumed to change linearly between the values at its ends.
 * No early termination, no skipping, no tables. Twin: shaders/programs/ray-caster.frag.glsl
 */
export function castRay(stages: RayStages, ray: Ray): Premultiplied {
  const interval = enterVolume(stages, ray);
  const gathering = stages.gather(see(stages, ray));
  const path = interval.exit > interval.entry ? pathOf(stages, ray, interval) : null;
  if (path) walk(stages, path, gathering);
  const color: Premultiplied = [...gathering.finish(path)];
  if (interval.behind) composite(color, interval.behind);
  return color;
}

function enterVolume({ intervals, eyeT }: RayStages, ray: Ray): Interval {
  const open: Interval = { entry: eyeT, exit: Infinity, behind: null };
  return intervals.reduce((interval, stage) => stage(ray, interval), open);
}

function see({ field, moreFields, classify, shades, step }: RayStages, ray: Ray): Seen {
  return {
    field,
    classify,
    ray,
    step,
    sampleAt: (place) => sampleAll(field, moreFields, place),
    seeSegment: (segment) =>
      shades.reduce((seen, stage) => stage(segment, seen, ray), classify.classifySegment(segment)),
  };
}

function sampleAll(field: FieldStage, moreFields: readonly SecondFieldStage[], place: Vector3): Sample {
  return moreFields.reduce((known, stage) => stage(place, known), field.sampleAt(place));
}

function pathOf({ field, moreFields, minSubsteps, step }: RayStages, ray: Ray, { entry, exit, gap }: Interval): Path {
  const isWhole = !gap || exit <= gap[0];
  const spans: [number, number][] = isWhole
    ? [[entry, exit]]
    : [[entry, gap[0]], ...(exit > gap[1] + slackOf(ray) ? [[gap[1], exit] as [number, number]] : [])];
  const pieces = spans.map((span) => span.map((t) => (t - entry) * ray.lengthPerT) as [number, number]);
  const placeAt = (along: number): Vector3 => add(ray.point, scale(ray.direction, entry + along / ray.lengthPerT));
  return {
    total: pieces[pieces.length - 1][1],
    pieces,
    sampleAt: (along) => sampleAll(field, moreFields, placeAt(along)),
    minSubstepsAt: minSubsteps && ((along) => minSubsteps(placeAt(along), scale(ray.direction, step / ray.lengthPerT))),
    kinksAlong:
      field.kinksAlong &&
      ((from, to) => field.kinksAlong!(placeAt(from), placeAt(to)).map((share) => from + share * (to - from))),
    jumpBetween: field.jumpBetween && ((from, to) => field.jumpBetween!(placeAt(from), placeAt(to))),
    turnsBetween: (from, to) =>
      moreFields
        .map((stage) => stage.turnBetween?.(placeAt(from), placeAt(to)) ?? null)
        .filter((share) => share !== null)
        .map((share) => from + share * (to - from)),
  };
}

function walk(stages: RayStages, path: Path, gathering: Gathering): void {
  const isCubic = (stages.maxSubsteps > 1 || stages.minSubsteps) && gathering.addPiece && path.kinksAlong;
  for (const piece of path.pieces) {
    if (isCubic) walkKinks(path, piece, (cubic) => gathering.addPiece!(cubic, path));
    else walkPiece(stages, path, piece, gathering);
  }
}

/** Goes through a piece of a path from kink to kink. Twin: shaders/chunks/walk/walk-voxels.glsl */
export function walkKinks(
  { sampleAt, kinksAlong }: Path,
  [begin, end]: readonly [number, number],
  add: (piece: CubicPiece) => void,
): void {
  let [from, front] = [begin, sampleAt(begin)];
  for (const to of [...kinksAlong!(begin, end), end]) {
    const back = sampleAt(to);
    add({ from, to, front, back });
    [from, front] = [to, back];
  }
}

function walkPiece(
  { step, maxSubsteps }: RayStages,
  { sampleAt, minSubstepsAt }: Path,
  [from, to]: readonly [number, number],
  gathering: Gathering,
): void {
  const count = countSteps(to - from, step);
  let front = sampleAt(from);
  for (let i = 0, next = 0; i < count; i = next) {
    const begin = from + i * step;
    const min = minSubstepsAt?.(begin) ?? 1;
    // Steps that the samples at their ends may cut are not taken together.
    next = maxSubsteps > 1 ? i + 1 : Math.min(count, i + Math.max(1, Math.round(1 / min)));
    const end = next < count ? from + next * step : to;
    const last = sampleAt(end);
    const wanted =
      maxSubsteps > 1 && (front.valid || last.valid) ? Math.min(maxSubsteps, gathering.chooseSubsteps(front, last)) : 1;
    const substeps = Math.max(wanted, min);
    const span = (end - begin) / substeps;
    for (let substep = 1; substep <= substeps; substep++) {
      const back = substep < substeps ? sampleAt(begin + substep * span) : last;
      gathering.add({ front, back, begin: begin + (substep - 1) * span, span });
      front = back;
    }
  }
}

/** The values at both ends. If one end has no data, it gets the value of the other end. */
export function dataEnds(front: Sample, back: Sample): [number, number] {
  return [front.valid ? front.value : back.value, back.valid ? back.value : front.value];
}
