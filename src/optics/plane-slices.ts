import { dot } from '../volume/matrix.ts';
import type { Vector3 } from '../volume/matrix.ts';
import { isCutOut } from './clip-intervals.ts';
import type { FieldStage, IntervalStage } from './ray-stages.ts';
import { evaluate } from './transfer-function.ts';
import type { Color, TransferFunction } from './transfer-function.ts';

/** A plane through a volume on which its values are painted. */
export interface PlaneSlice {
  readonly kind: 'plane';
  /** The places p of the grid's unit cube with normal . p = offset. */
  readonly normal: Vector3;
  readonly offset: number;
  /** Data values of black and white; null for the colours of the transfer function. */
  readonly window: readonly [number, number] | null;
}

/** Where the transfer function's opacity is below this, a slice in its colours is not there. */
export const minSliceOpacity = 1e-5;

/** Colour of a value where opacity is taken as 1; null where there is no data, or nothing is to be seen of it. */
export function straightColor(transferFunction: TransferFunction, value: number): Color | null {
  if (Number.isNaN(value)) return null;
  const [red, green, blue, opacity] = evaluate(transferFunction, value);
  return opacity < minSliceOpacity ? null : [red / opacity, green / opacity, blue / opacity];
}

/**
 * The nearest plane on which there are data ends a ray, and stands behind what is before it.
 * @param field - what is there
 * @param colors - of the transfer function, brightened
 * Twin: shaders/chunks/plane-slices.glsl
 */
export function planeInterval(planes: readonly PlaneSlice[], field: FieldStage, colors: TransferFunction): IntervalStage {
  return (ray, interval) => {
    let nearest = interval;
    for (const { normal, offset, window } of planes) {
      const t = (offset - dot(normal, ray.point)) / dot(normal, ray.direction);
      if (!(t >= nearest.entry && t < nearest.exit) || isCutOut(interval.gap, t)) continue;
      const [x, y, z] = ray.point.map((at, axis) => at + t * ray.direction[axis]);
      const { value, valid } = field.sampleAt([x, y, z]);
      const color = valid ? (window ? grayOf(value, window) : straightColor(colors, value)) : null;
      if (color) nearest = { ...interval, exit: t, behind: [...color, 1] };
    }
    return nearest;
  };
}

function grayOf(value: number, [black, white]: readonly [number, number]): Color {
  const gray = white > black ? Math.min(1, Math.max(0, (value - black) / (white - black))) : Number(value > white);
  return [gray, gray, gray];
}
