import { add, scale } from '../volume/matrix.ts';
import type { Vector3 } from '../volume/matrix.ts';
import { castRay, walkKinks } from './rays/cast-ray.ts';
import { groupOf, isHidden } from './attachments/labels.ts';
import { findJump } from './pick-jump.ts';
import type { Rise } from './pick-jump.ts';
import type { ProjectionKind } from './rays/ray-style.ts';
import { seekExtreme } from './rays/projection.ts';
import type { GatherStage, Gathering, Interval, Path, RayStages, Sample, Seen, Segment } from './rays/ray-stages.ts';
import type { Ray } from './rays/rays.ts';
import { evaluate } from './transfer/transfer-function.ts';
import type { Premultiplied, TransferFunction } from './transfer/transfer-function.ts';

/** Which place of a ray is meant: see `pickRay`. */
export type PickAt = 'jump' | 'surface' | 'max';

export const pickPlaces: readonly PickAt[] = ['jump', 'surface', 'max'];

/** What is shown of values along a ray. */
export interface PickedLook {
  /** Brightened. */
  readonly transferFunction: TransferFunction;
  /** Brightened: of groups of labels, from 1. */
  readonly functions?: readonly TransferFunction[];
  readonly projection: ProjectionKind | null;
  /** See `RayStyle.intensityThreshold`. */
  readonly intensityThreshold?: number;
  /** Whether there is nothing but surfaces. */
  readonly isClear?: boolean;
}

/** A place on a ray. */
export interface RayPick {
  /** In the unit cube. */
  readonly place: Vector3;
  /** What the whole ray shows. */
  readonly color: Premultiplied;
  /** The value of the surface that is there. */
  readonly surface?: number;
}

/** Where on a ray. */
interface Found {
  readonly at: number;
  /** See `RayPick`. */
  readonly surface?: number;
}

/** Below this opacity, half a level of a picture, nothing shows. */
const invisible = 1 / 510;

/** Where a ray is as opaque as this, a person takes what is there for its surface. */
const surfaceOpacity = 0.5;

/** More than rounding of a length in bounding diameters. */
const gapSlack = 1e-9;

/** Parts of a segment in which a place is looked for, and how often. */
const [parts, rounds] = [16, 2];

/**
 * The place of a ray that a person means who points at its pixel. The ray runs through the same stages as in the picture.
 *
 * - `jump`: where the opacity gathered so far jumps most; of this jump, the place where half of it is reached.
 * - `surface`: where the opacity gathered so far passes a half; nowhere if it never does.
 * - `max`: where the largest value is that shows, and is not hidden by what is before it.
 *
 * With a projection it is where the value is that the ray shows; of an average, where the largest value is.
 * @returns null where nothing shows
 */
export function pickRay(stages: RayStages, ray: Ray, { at, look }: { readonly at: PickAt; readonly look: PickedLook }): RayPick | null {
  let crossed: Interval | null = null;
  let found: Found | null = null;
  const color = castRay({
    ...stages,
    intervals: [...stages.intervals, (_, interval) => (crossed = interval)],
    gather: (seen) => record(seen, stages.gather, (walked) => (found = findPlace(walked, { at, look }, crossed!))),
  }, ray);
  const { entry, exit, behind } = crossed!;
  if (!(color[3] >= invisible) || (found === null && !behind)) return null;
  // What stands where a ray begins, as a slice on a cut face does, has no way before it.
  const { at: along, surface } = (found as Found | null) ?? { at: null };
  const t = along === null ? exit : entry + along / ray.lengthPerT;
  return { place: add(ray.point, scale(ray.direction, t)), color, ...(surface !== undefined && { surface }) };
}

/** A ray that has been walked. */
interface Walked {
  readonly seen: Seen;
  readonly path: Path;
  readonly segments: readonly Segment[];
  readonly rises: readonly Rise[];
  /** What it shows of the volume itself. */
  readonly color: Premultiplied;
}

/** Gather as the picture does, and keep what was gathered where. */
function record(seen: Seen, gather: GatherStage, tell: (walked: Walked) => void): Gathering {
  const segments: Segment[] = [];
  const rises: Rise[] = [];
  let [opacity, alpha] = [0, 0];
  const seeSegment = (segment: Segment): Premultiplied => {
    const color = seen.seeSegment(segment);
    alpha = color[3];
    return color;
  };
  const pieces: (readonly [piece: Segment, opacity: number])[] = [];
  const gathering = gather({ ...seen, seeSegment, tell: (piece, opacity) => pieces.push([piece, opacity]) });
  const keep = (segment: Segment, height: number): void => {
    segments.push(segment);
    rises.push({ begin: segment.begin, span: segment.span, height });
  };
  /** Where the pieces so far end. What comes later has been cut out, and what stands on both sides of it are two things. */
  const walkedTo = (): number => {
    const last = segments[segments.length - 1];
    return last ? last.begin + last.span : 0;
  };
  const keepGap = (begin: number, back: Sample): void => {
    const end = walkedTo();
    if (segments.length > 0 && begin > end + gapSlack) keep({ front: segments[segments.length - 1].back, back, begin: end, span: begin - end }, 0);
  };
  const keepAll = (): void => {
    for (const [piece, share] of pieces.splice(0)) {
      const height = (1 - opacity) * share;
      opacity += height;
      keep(piece, height);
    }
  };
  return {
    add: (segment) => {
      keepGap(segment.begin, segment.front);
      gathering.add(segment); // Sees the segment, unless it is a projection.
      if (pieces.length === 0) pieces.push([segment, alpha]);
      keepAll();
    },
    ...(gathering.addPiece && { addPiece: (piece, path) => {
      keepGap(piece.from, piece.front);
      gathering.addPiece!(piece, path);
      keepAll();
    } }),
    chooseSubsteps: (front, back) => gathering.chooseSubsteps(front, back),
    finish: (path) => {
      const color = gathering.finish(path);
      if (path) tell({ seen, path, segments, rises, color });
      return color;
    },
  };
}

/** @returns how far along the path it is; null where there is none */
function findPlace(walked: Walked, { at, look }: { readonly at: PickAt; readonly look: PickedLook }, { behind }: Interval): Found | null {
  const { path, color } = walked;
  // What stands at the end of the ray, if anything does, hides all that is behind it.
  const end = behind ? { height: (1 - color[3]) * behind[3], at: path.total } : null;
  if (look.projection) return end && end.height > color[3] ? end : findExtreme(walked, look, Infinity);
  if (at === 'max') return (look.isClear ? findHighest(walked) : findExtreme(walked, look, hiddenFrom(walked))) ?? end;
  const jump = at === 'surface' ? { first: 0, last: walked.rises.length - 1, height: 2 * surfaceOpacity } : findJump(walked.rises);
  if (end && (at === 'surface' ? color[3] < surfaceOpacity : end.height > (jump?.height ?? 0))) return end;
  return jump && reach(walked, jump.first, jump.height / 2);
}

/** From where on nothing shows any more. */
function hiddenFrom({ rises, path }: Walked): number {
  let opacity = 0;
  for (const { begin, span, height } of rises) {
    opacity += height;
    if (1 - opacity < invisible) return begin + span;
  }
  return path.total;
}

function findExtreme({ segments, path, seen }: Walked, { transferFunction, functions = [], projection, intensityThreshold }: PickedLook, last: number): Found | null {
  const all = [transferFunction, ...functions];
  const shows = (sample: Sample): boolean => projection !== null || evaluate(all[groupOf(sample)], sample.value)[3] > 0;
  const counts = (sample: Sample, at: number): boolean => sample.valid && at <= last && shows(sample) && !isHidden(sample);
  const search = seekExtreme(seen.step, projection === 'min' ? -1 : 1, { counts, threshold: projection && projection !== 'average' ? intensityThreshold : undefined });
  if (path.kinksAlong) for (const piece of path.pieces) walkKinks(path, piece, (cubic) => search.addPiece(cubic, path));
  else segments.forEach(search.add);
  return search.find(path);
}

/** Of the surfaces that are not hidden, the one of the largest value. */
function findHighest(walked: Walked): Found | null {
  const last = hiddenFrom(walked);
  let highest: Found | null = null;
  walked.rises.forEach(({ begin, span, height }, i) => {
    const { value } = walked.segments[i].front;
    if (span === 0 && height > 0 && begin <= last && value > (highest?.surface ?? -Infinity)) highest = { at: begin, surface: value };
  });
  return highest;
}

/** Where the segments from the first on have made the ray more opaque by a height. */
function reach({ segments, rises, path, seen }: Walked, first: number, height: number): Found | null {
  let [before, sum] = [0, 0];
  for (let i = 0; i < first; i++) before += rises[i].height;
  for (let i = first; i < rises.length; i++) {
    const rise = rises[i].height;
    if (rise > 0 && sum + rise >= height && rises[i].span === 0) return { at: rises[i].begin, surface: segments[i].front.value };
    if (rise > 0 && sum + rise >= height) return reachWithin({ path, seen, opacity: before + sum }, segments[i], (height - sum) / rise);
    sum += rise;
  }
  return null;
}

/**
 * Where on a segment a share of what it adds is added.
 * @param opacity - gathered before it
 */
function reachWithin({ path, seen, opacity }: { readonly path: Path; readonly seen: Seen; readonly opacity: number }, { begin, span }: Segment, share: number): Found {
  let [from, length, wanted, gathered] = [begin, span, share, opacity];
  for (let round = 0; round < rounds; round++) {
    const heights: number[] = [];
    let visible = 1 - gathered;
    for (let i = 0; i < parts; i++) {
      const at = from + (i * length) / parts;
      const [front, back] = [path.sampleAt(at), path.sampleAt(at + length / parts)];
      const height = visible * seen.seeSegment({ front, back, begin: at, span: length / parts })[3];
      heights.push(height);
      visible -= height;
    }
    let rest = wanted * heights.reduce((sum, height) => sum + height, 0);
    if (!(rest > 0)) break;
    let part = 0;
    while (part < parts - 1 && rest > heights[part]) rest -= heights[part++];
    for (let i = 0; i < part; i++) gathered += heights[i];
    [from, length, wanted] = [from + (part * length) / parts, length / parts, Math.min(1, rest / heights[part])];
  }
  // Beside a place without data it is at the end that has some.
  const places = [from + wanted * length, from, from + length];
  return { at: places.find((at) => path.sampleAt(at).valid) ?? places[0] };
}
