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

/** Which place on a ray to pick: see `pickRay`. */
export type PickAt = 'jump' | 'surface' | 'max' | 'half';

export const pickPlaces: readonly PickAt[] = ['jump', 'surface', 'max', 'half'];

/** How values along a ray are shown. */
export interface PickedAppearance {
  /** Already brightened. */
  readonly transferFunction: TransferFunction;
  /** Already brightened: the functions of groups of labels, from 1. */
  readonly functions?: readonly TransferFunction[];
  readonly projection: ProjectionKind | null;
  /** See `RayStyle.intensityThreshold`. */
  readonly intensityThreshold?: number;
  /** Whether only surfaces are visible. */
  readonly isClear?: boolean;
}

/** A place on a ray. */
export interface RayPick {
  /** In the unit cube. */
  readonly place: Vector3;
  /** What the whole ray shows. */
  readonly color: Premultiplied;
  /** The value of the iso-surface at this place, if it is on one. */
  readonly surface?: number;
}

/** A place along a ray. */
interface Found {
  readonly at: number;
  /** See `RayPick`. */
  readonly surface?: number;
}

/** Below this opacity (half a level of an 8-bit picture) nothing is visible. */
const invisible = 1 / 510;

/** Where a ray has this opacity, a person sees a surface. */
const surfaceOpacity = 0.5;

/** In bounding diameters; larger than the rounding error of a length. */
const gapSlack = 1e-9;

/** To find a place, a segment is divided into this many parts, this many times. */
const [parts, rounds] = [16, 2];

/**
 * Finds the place that a person means when they point at the ray's pixel. The ray runs through the same stages as in the picture.
 *
 * - `jump`: the gathered opacity has its largest jump; the place is where half of this jump is reached.
 * - `surface`: the place where the gathered opacity passes one half; no place if it never does.
 * - `max`: the place of the largest value that is visible and is not hidden by matter in front of it.
 * - `half`: the place where half of the ray's final opacity is reached.
 *
 * With a projection, it is the place of the value that the ray shows. For an average, it is the place of the largest value.
 * @returns null if nothing is visible
 */
export function pickRay(
  stages: RayStages,
  ray: Ray,
  { at, look: appearance }: { readonly at: PickAt; readonly look: PickedAppearance },
): RayPick | null {
  let crossed: Interval | null = null;
  let found: Found | null = null;
  const color = castRay(
    {
      ...stages,
      intervals: [...stages.intervals, (_, interval) => (crossed = interval)],
      gather: (seen) =>
        record(seen, stages.gather, (walked) => (found = findPlace(walked, { at, look: appearance }, crossed!))),
    },
    ray,
  );
  const { entry, exit, behind } = crossed!;
  if (!(color[3] >= invisible) || (found === null && !behind)) return null;
  // An object exactly where a ray begins (for example a slice on a cut face) has no path in front of it.
  const { at: along, surface } = (found as Found | null) ?? { at: null };
  const t = along === null ? exit : entry + along / ray.lengthPerT;
  return { place: add(ray.point, scale(ray.direction, t)), color, ...(surface !== undefined && { surface }) };
}

/** A ray after it was cast. */
interface Walked {
  readonly seen: Seen;
  readonly path: Path;
  readonly segments: readonly Segment[];
  readonly rises: readonly Rise[];
  /** The colour of the volume alone. */
  readonly color: Premultiplied;
}

/** Gathers as the picture does, and records what each piece added. */
function record(seen: Seen, gather: GatherStage, report: (walked: Walked) => void): Gathering {
  const segments: Segment[] = [];
  const rises: Rise[] = [];
  let [opacity, alpha] = [0, 0];
  const seeSegment = (segment: Segment): Premultiplied => {
    const color = seen.seeSegment(segment);
    alpha = color[3];
    return color;
  };
  const pieces: (readonly [piece: Segment, opacity: number])[] = [];
  const gathering = gather({ ...seen, seeSegment, report: (piece, opacity) => pieces.push([piece, opacity]) });
  const keep = (segment: Segment, height: number): void => {
    segments.push(segment);
    rises.push({ begin: segment.begin, span: segment.span, height });
  };
  /** Where the pieces so far end. If the next piece begins later, a part was cut out, and the pieces on its two sides are separate things. */
  const walkedTo = (): number => {
    const last = segments[segments.length - 1];
    return last ? last.begin + last.span : 0;
  };
  const keepGap = (begin: number, back: Sample): void => {
    const end = walkedTo();
    if (segments.length > 0 && begin > end + gapSlack)
      keep({ front: segments[segments.length - 1].back, back, begin: end, span: begin - end }, 0);
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
    ...(gathering.addPiece && {
      addPiece: (piece, path) => {
        keepGap(piece.from, piece.front);
        gathering.addPiece!(piece, path);
        keepAll();
      },
    }),
    chooseSubsteps: (front, back) => gathering.chooseSubsteps(front, back),
    finish: (path) => {
      const color = gathering.finish(path);
      if (path) report({ seen, path, segments, rises, color });
      return color;
    },
  };
}

/** @returns the distance along the path; null if there is no such place */
function findPlace(
  walked: Walked,
  { at, look: appearance }: { readonly at: PickAt; readonly look: PickedAppearance },
  { behind }: Interval,
): Found | null {
  const { path, color } = walked;
  // An object at the end of the ray, if there is one, hides everything behind it.
  const end = behind ? { height: (1 - color[3]) * behind[3], at: path.total } : null;
  if (appearance.projection) return end && end.height > color[3] ? end : findExtreme(walked, appearance, Infinity);
  if (at === 'max')
    return (appearance.isClear ? findHighest(walked) : findExtreme(walked, appearance, hiddenFrom(walked))) ?? end;
  if (at !== 'jump') {
    const wanted = at === 'surface' ? surfaceOpacity : (color[3] + (end?.height ?? 0)) / 2;
    return end && color[3] < wanted ? end : reach(walked, 0, wanted);
  }
  const jump = findJump(walked.rises);
  if (end && end.height > (jump?.height ?? 0)) return end;
  return jump && reach(walked, jump.first, jump.height / 2);
}

/** From this place on, nothing is visible any longer. */
function hiddenFrom({ rises, path }: Walked): number {
  let opacity = 0;
  for (const { begin, span, height } of rises) {
    opacity += height;
    if (1 - opacity < invisible) return begin + span;
  }
  return path.total;
}

function findExtreme(
  { segments, path, seen }: Walked,
  { transferFunction, functions = [], projection, intensityThreshold }: PickedAppearance,
  last: number,
): Found | null {
  const all = [transferFunction, ...functions];
  const shows = (sample: Sample): boolean => projection !== null || evaluate(all[groupOf(sample)], sample.value)[3] > 0;
  const counts = (sample: Sample, at: number): boolean =>
    sample.valid && at <= last && shows(sample) && !isHidden(sample);
  const search = seekExtreme(seen.step, projection === 'min' ? -1 : 1, {
    counts,
    threshold: projection && projection !== 'average' ? intensityThreshold : undefined,
  });
  if (path.kinksAlong) for (const piece of path.pieces) walkKinks(path, piece, (cubic) => search.addPiece(cubic, path));
  else segments.forEach(search.add);
  return search.find(path);
}

/** Of the surfaces that are not hidden, the one with the largest value. */
function findHighest(walked: Walked): Found | null {
  const last = hiddenFrom(walked);
  let highest: Found | null = null;
  walked.rises.forEach(({ begin, span, height }, i) => {
    const { value } = walked.segments[i].front;
    if (span === 0 && height > 0 && begin <= last && value > (highest?.surface ?? -Infinity))
      highest = { at: begin, surface: value };
  });
  return highest;
}

/** The place where the segments, from the first on, have added a given opacity. */
function reach({ segments, rises, path, seen }: Walked, first: number, height: number): Found | null {
  let [before, sum] = [0, 0];
  for (let i = 0; i < first; i++) before += rises[i].height;
  for (let i = first; i < rises.length; i++) {
    const rise = rises[i].height;
    if (rise > 0 && sum + rise >= height && rises[i].span === 0)
      return { at: rises[i].begin, surface: segments[i].front.value };
    if (rise > 0 && sum + rise >= height)
      return reachWithin({ path, seen, opacity: before + sum }, segments[i], (height - sum) / rise);
    sum += rise;
  }
  return null;
}

/**
 * The place on a segment where a given share of its opacity has been added.
 * @param opacity - gathered before this segment
 */
function reachWithin(
  { path, seen, opacity }: { readonly path: Path; readonly seen: Seen; readonly opacity: number },
  { begin, span }: Segment,
  share: number,
): Found {
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
  // Next to a place without data, take the end that has data.
  const places = [from + wanted * length, from, from + length];
  return { at: places.find((at) => path.sampleAt(at).valid) ?? places[0] };
}
