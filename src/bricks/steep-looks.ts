// What values look like where that depends on how steeply they change, and in which direction: X3D's styles, `gradient-opacity`, patches of values and gradients.
import type { Styled } from '../optics/transfer/volume-styles.ts';
import { scale } from '../volume/matrix.ts';
import type { Vector3 } from '../volume/matrix.ts';
import { sumCount } from './span-sums.ts';
import type { SpanSums } from './span-sums.ts';

/** A change is given along each axis of the grid: by how much stored values change with a voxel of the finest level. */
export interface SteepLooks {
  /** Edges of a voxel of the finest level, as shares of the unit cube. */
  readonly voxel: Vector3;
  /** Length of a step in reference lengths, times the opacity factor: styles act on the opacity of a reference length. */
  readonly ratio: number;
  /** What values look like that change so; undefined: the same for all changes. */
  readonly sumsOf?: (change: Vector3) => SpanSums;
  /** What becomes of colours and opacities; undefined: they stay. @param ray, place - unit cube */
  readonly styleOf?: (ray: { readonly direction: readonly number[] }, place: Vector3, change: Vector3) => Styled;
}

/** A change that may be added to one that is shown, or a sum of both. */
export interface AddedChange {
  readonly change: Vector3;
  readonly weight: number;
}

/** Of changes of any direction with a mean square of 1: the share that is far larger than most, and how large that is; and the rest, near and far. */
const [largeShare, large, near, far] = [0.08, 1.8, 0.6, 1.14];

const corners = [-1, 1].flatMap((x) => [-1, 1].flatMap((y) => [-1, 1].map((z): Vector3 => [x, y, z])));
const axes = [-1, 1].flatMap((x): Vector3[] => [
  [x, 0, 0],
  [0, x, 0],
  [0, 0, x],
]);

/** Changes in all directions, whose squares have a mean of 1: corners of a cube, a far one opposite each near one; and a few that are much larger along its axes. */
export const anyChange: readonly AddedChange[] = [
  ...corners.map(([x, y, z]) => ({
    change: scale([x, y, z], (x * y * z > 0 ? near : far) / Math.sqrt(3)),
    weight: (1 - largeShare) / corners.length,
  })),
  ...axes.map((axis) => ({ change: scale(axis, large), weight: largeShare / axes.length })),
];

/** Means of a step, see `sumCount`, of any opacity above 0; and that opacity in a reference length. */
export interface StepMeans {
  readonly means: Float64Array;
  readonly ofReference: number;
}

/** @param ratio - see `SteepLooks` */
export const stepMeans = (means: Float64Array, ratio: number): StepMeans => ({
  means,
  ofReference: -Math.expm1(Math.log1p(-Math.min(means[3], 1 - 1e-16)) / ratio),
});

/** Adds `weight` times what a style makes of a step. */
export function addStyled(
  { means, ofReference }: StepMeans,
  style: Styled | null,
  { ratio, weight }: { readonly ratio: number; readonly weight: number },
  into: Float64Array,
): void {
  if (!style) {
    for (let c = 0; c < sumCount; c++) into[c] += weight * means[c];
    return;
  }
  const opacity = means[3];
  const styled = -Math.expm1(ratio * Math.log1p(-Math.min(0.9999, ofReference * style.opacity)));
  const factor = styled / opacity;
  for (let c = 0; c < 3; c++) {
    // A channel is at most as bright as white.
    const bright = (style.gain[c] * means[c]) / opacity + style.more[c];
    const clip = bright > 1 ? 1 / bright : 1;
    const [gain, more] = [clip * style.gain[c], clip * style.more[c]];
    into[c] += weight * factor * (gain * means[c] + more * opacity);
    into[4 + c] +=
      weight * factor ** 2 * (gain ** 2 * means[4 + c] + 2 * gain * more * means[8 + c] + more ** 2 * means[7]);
    into[8 + c] += weight * factor ** 2 * (gain * means[8 + c] + more * means[7]);
  }
  into[3] += weight * styled;
  into[7] += weight * factor ** 2 * means[7];
}
