import { add, dot, scale } from '../../volume/matrix.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import { walkKinks } from '../rays/cast-ray.ts';
import { isCutOut } from '../rays/clip-intervals.ts';
import type { Plane } from './plane-outlines.ts';
import { mergeLine } from '../rays/projection.ts';
import type { ProjectionKind } from '../rays/ray-style.ts';
import type { FieldStage, IntervalStage, Path, Sample } from '../rays/ray-stages.ts';
import { intersectUnitCube } from '../rays/rays.ts';
import { slackAt } from '../rays/slack.ts';
import { evaluate } from '../transfer/transfer-function.ts';
import type { Color, TransferFunction } from '../transfer/transfer-function.ts';

/** The thickness of a plane. All values along a line through it are combined into one. Places without data are left out. */
export interface PlaneSlab {
  /** From one side of the slab to the other, in the unit cube. The plane is in the middle. */
  readonly way: Vector3;
  readonly kind: ProjectionKind;
}

/** A plane through a volume on which its values are painted. */
export interface PlaneSlice extends Plane {
  readonly kind: 'plane';
  /** null if it shows only the values on the plane itself. */
  readonly slab: PlaneSlab | null;
  /** The data values of black and white; null to use the colours of the transfer function. */
  readonly window: readonly [number, number] | null;
}

/** Where the transfer function's opacity is below this, a slice in its colours is not drawn. */
export const minSliceOpacity = 1e-5;

/** The colour of a value if opacity counts as 1; null if there is no data or nothing is visible. */
export function straightColor(transferFunction: TransferFunction, value: number): Color | null {
  if (Number.isNaN(value)) return null;
  const [red, green, blue, opacity] = evaluate(transferFunction, value);
  return opacity < minSliceOpacity ? null : [red / opacity, green / opacity, blue / opacity];
}

/**
 * The nearest plane that has data ends a ray, and its colour stands behind everything in front of it. A plane on a cut face, or on a face
 * of the volume, is visible from both sides.
 * @param field - the values of the volume
 * @param colors - of the transfer function, brightened
 * Twin: shaders/chunks/attachments/plane-slices.glsl
 */
export function planeInterval(
  planes: readonly PlaneSlice[],
  field: FieldStage,
  colors: TransferFunction,
): IntervalStage {
  return (ray, interval) => {
    const { entry, exit, gap } = interval;
    let [found, nearest] = [interval, Infinity];
    for (const { normal, offset, window, slab } of planes) {
      const slope = dot(normal, ray.direction);
      const t = (offset - dot(normal, ray.point)) / slope;
      const slack = slackAt(slope);
      if (!(t >= entry - slack && t <= exit + slack && t < nearest) || isCutOut(gap, t, slack)) continue;
      const place = add(ray.point, scale(ray.direction, Math.max(entry, Math.min(exit, t))));
      const { value, valid } = slab ? sampleSlab(field, place, slab) : field.sampleAt(place);
      const color = valid ? (window ? grayOf(value, window) : straightColor(colors, value)) : null;
      if (!color) continue;
      nearest = t;
      found = {
        ...interval,
        exit: t < entry + slack ? Math.min(entry, exit) : Math.min(exit, t),
        behind: [...color, 1],
      };
    }
    return found;
  };
}

/** The value of a slab at a place: exact between planes of voxels' centres. Twin: shaders/chunks/attachments/plane-slices.glsl */
export function sampleSlab(field: FieldStage, place: Vector3, { way, kind }: PlaneSlab): Sample {
  const from = add(place, scale(way, -0.5));
  const [entry, exit] = intersectUnitCube(from, way).map((share) => Math.min(1, Math.max(0, share)));
  const placeAt = (share: number): Vector3 => add(from, scale(way, share));
  const path: Path = {
    total: exit,
    pieces: [[entry, exit]],
    sampleAt: (share) => field.sampleAt(placeAt(share)),
    kinksAlong: (begin, end) =>
      (field.kinksAlong?.(placeAt(begin), placeAt(end)) ?? []).map((share) => begin + share * (end - begin)),
  };
  if (!(exit > entry)) return { value: NaN, valid: false };
  const merged = mergeLine(kind);
  walkKinks(path, [entry, exit], (piece) => merged.addPiece(piece, path));
  return merged.find(path);
}

function grayOf(value: number, [black, white]: readonly [number, number]): Color {
  const gray = white > black ? Math.min(1, Math.max(0, (value - black) / (white - black))) : Number(value > white);
  return [gray, gray, gray];
}
