import type { Vector3 } from '../volume/matrix.ts';
import type { Samples } from '../volume/volume.ts';
import { interpolate } from './interpolate.ts';
import type { FieldStage } from './ray-stages.ts';
import { voteOfCorners } from './vote.ts';

/** How stored values become data values. */
interface Scaling {
  readonly slope: number;
  readonly intercept: number;
}

/** Samples on a cartesian grid. @param isDiscrete - as a volume's. Twin: shaders/chunks/sample-volume.glsl */
export function cartesianField(
  { samples, dimensions, isDiscrete, ...scaling }: Scaling & { readonly samples: Samples; readonly dimensions: Vector3; readonly isDiscrete?: boolean },
): FieldStage {
  if (isDiscrete) return storedField((place) => voteOfCorners(samples, dimensions, place), scaling, 0);
  return { ...storedField((place) => interpolate(samples, dimensions, place), scaling), kinksBetween: (from, to) => kinksBetween(dimensions, from, to) };
}

/**
 * Where a way passes planes of voxels' centres, the nearest along each axis, as shares of it: there tri-linear values kink, and nowhere else.
 * Planes at its ends are left out. Twin: shaders/chunks/surfaces.glsl
 */
export function kinksBetween(dimensions: Vector3, from: Vector3, to: Vector3): number[] {
  return dimensions.flatMap((n, axis) => {
    const [begin, end] = [from[axis] * n - 0.5, to[axis] * n - 0.5];
    const plane = end > begin ? Math.floor(begin) + 1 : Math.ceil(begin) - 1;
    const share = (plane - begin) / (end - begin);
    return share > 1e-3 && share < 0.999 ? [share] : [];
  });
}

/**
 * @param storedAt - stored value at a place of the unit cube, NaN where there is no data
 * @param foldFrom - stored values more than this apart are on two sides of a fold
 */
export function storedField(storedAt: (place: Vector3) => number, { slope, intercept }: Scaling, foldFrom = Infinity): FieldStage {
  return {
    sampleAt: (place) => {
      const value = slope * storedAt(place) + intercept;
      return { value, valid: !Number.isNaN(value) };
    },
    isFolded: (from, to) => Math.abs(to - from) > foldFrom * Math.abs(slope),
  };
}
