import type { FinerVoxels } from '../../volume/finer-voxels.ts';
import { subtract } from '../../volume/matrix.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import type { Samples } from '../../volume/volume.ts';
import { interpolate } from './interpolate.ts';
import type { FieldStage, Sample } from './ray-stages.ts';
import { voteOfCorners } from './vote.ts';
import { meetVoxelPlanes } from './voxel-planes.ts';

/** How stored values become data values. */
interface Scaling {
  readonly slope: number;
  readonly intercept: number;
}

/** The field of samples on a cartesian grid. @param isDiscrete - as in a volume. Twin: shaders/chunks/field/sample-volume.glsl */
export function cartesianField({
  samples,
  dimensions,
  isDiscrete,
  finer,
  ...scaling
}: Scaling & {
  readonly samples: Samples;
  readonly dimensions: Vector3;
  readonly isDiscrete?: boolean;
  readonly finer?: FinerVoxels;
}): FieldStage {
  const kinksAlong = (from: Vector3, to: Vector3): readonly number[] => {
    if (finer) return finer.kinksAlong(from, to);
    const begin = inVoxels(dimensions, from);
    return meetVoxelPlanes(begin, subtract(inVoxels(dimensions, to), begin), dimensions);
  };
  if (isDiscrete)
    return { ...storedField((place) => voteOfCorners(samples, dimensions, place), scaling, 0), kinksAlong };
  return {
    ...storedField((place) => (finer ? finer.storedAt(place) : interpolate(samples, dimensions, place)), scaling),
    sampleNextTo: finer && ((place, axis, by) => toSample(finer.storedNextTo(place, axis, by), scaling)),
    kinksBetween: (from, to) => kinksBetween(finer?.grid.dimensions ?? dimensions, from, to),
    kinksAlong,
    jumpBetween:
      finer &&
      ((from, to) => {
        const [one, other] = [from, to].map((place) => finer.voxelAt(place)[0] * finer.grid.dimensions[0]);
        return one === other ? 0 : Math.max(one, other);
      }),
  };
}

/** A place of the unit cube in voxels: whole numbers are at their centres. */
function inVoxels(dimensions: Vector3, place: Vector3): Vector3 {
  return place.map((x, axis) => x * dimensions[axis] - 0.5) as unknown as Vector3;
}

/** The longest way along each axis, in voxels: one, plus its rounding. */
const maxVoxels = 1.01;

/**
 * Where a way of at most one voxel along each axis passes planes of voxels' centres, as shares of the way. Tri-linear values kink there and
 * nowhere else. Planes at the ends do not count. Longer ways return none. Twin: shaders/chunks/gather/surface-crossings.glsl
 */
export function kinksBetween(dimensions: Vector3, from: Vector3, to: Vector3): number[] {
  const ways = dimensions.map((n, axis) => (to[axis] - from[axis]) * n);
  if (ways.some((way) => Math.abs(way) > maxVoxels)) return [];
  return ways.flatMap((way, axis) => {
    const begin = from[axis] * dimensions[axis] - 0.5;
    const plane = way > 0 ? Math.floor(begin) + 1 : Math.ceil(begin) - 1;
    const share = (plane - begin) / way;
    return share > 1e-3 && share < 0.999 ? [share] : [];
  });
}

/**
 * @param storedAt - stored value at a place of the unit cube; NaN if there is no data
 * @param foldFrom - stored values that differ by more than this are on two sides of a fold
 */
export function storedField(storedAt: (place: Vector3) => number, scaling: Scaling, foldFrom = Infinity): FieldStage {
  return {
    sampleAt: (place) => toSample(storedAt(place), scaling),
    isFolded: (from, to) => Math.abs(to - from) > foldFrom * Math.abs(scaling.slope),
  };
}

function toSample(stored: number, { slope, intercept }: Scaling): Sample {
  const value = slope * stored + intercept;
  return { value, valid: !Number.isNaN(value) };
}
