import type { FinerVoxels } from '../../volume/finer-voxels.ts';
import { finestSpacing } from '../../volume/grid.ts';
import type { GridFrame } from '../../volume/grid.ts';
import { identity, invertAffine, length, transformDirection } from '../../volume/matrix.ts';
import type { Matrix4, Vector3 } from '../../volume/matrix.ts';
import type { FieldStage, Sample } from './ray-stages.ts';

/** How a field changes around a place. */
export interface Gradient {
  /** Data units from voxel to voxel, along each of the grid's axes. */
  readonly perVoxel: Vector3;
  /** The direction in the world in which values grow fastest; of any length. */
  readonly world: Vector3;
}

/** @param place - in the unit cube @param known - the sample at that place */
export type GradientStage = (place: Vector3, known: Sample) => Gradient;

/**
 * Central differences over one voxel on each side. If one side has no data, or a value folds, only the other side counts. A place without
 * data has no direction.
 * @param tapAt - the sample one voxel along an axis from the place, on one side
 */
export function differ(
  known: Sample,
  tapAt: (axis: number, side: -1 | 1) => Sample,
  isFolded: FieldStage['isFolded'],
): Vector3 {
  if (!known.valid) return [0, 0, 0];
  const counts = (tap: Sample): boolean => tap.valid && !isFolded(known.value, tap.value);
  const change = (axis: number): number => {
    const [before, after] = [tapAt(axis, -1), tapAt(axis, 1)];
    const [hasBefore, hasAfter] = [counts(before), counts(after)];
    const sum = (hasAfter ? after.value - known.value : 0) - (hasBefore ? before.value - known.value : 0);
    return hasBefore && hasAfter ? sum / 2 : sum;
  };
  return [change(0), change(1), change(2)];
}

/**
 * The gradient of a field on a cartesian grid. Inside the grid it equals interpolated central differences.
 * @param finer - where there are finer voxels, taps are as far away as these are long, and changes are those from one of the finest to the next
 * Twin: shaders/chunks/field/gradient-cartesian.glsl
 */
export function cartesianGradient(field: FieldStage, coarse: GridFrame, finer?: FinerVoxels): GradientStage {
  const grid = finer?.finest ?? coarse;
  const toWorld = normalsToWorld(grid);
  const whole = grid.dimensions.map((n) => 1 / n);
  return (place, known) => {
    const tapAt = (axis: number, side: number): Sample => {
      if (field.sampleNextTo) return field.sampleNextTo(place, axis, side);
      const tap: [number, number, number] = [...place];
      tap[axis] += side * whole[axis];
      return field.sampleAt(tap);
    };
    const perTap = differ(known, tapAt, field.isFolded);
    const voxel = finer?.voxelAt(place);
    const perVoxel = voxel ? (perTap.map((x, axis) => x * (whole[axis] / voxel[axis])) as unknown as Vector3) : perTap;
    return { perVoxel, world: transformDirection(toWorld, perVoxel) };
  };
}

/**
 * Row-major: maps changes per voxel to directions in the world. It is the inverse transpose of the grid's matrix, in units
 * of its finest voxel.
 */
export function normalsToWorld(grid: GridFrame): Matrix4 {
  const finest = finestSpacing(grid);
  return transposeLinear(invertAffine(grid.indexToWorld) ?? identity).map((x) => x * finest);
}

/** The transpose of the linear part of a matrix, without the translation. */
export function transposeLinear(m: Matrix4): Matrix4 {
  return [m[0], m[4], m[8], 0, m[1], m[5], m[9], 0, m[2], m[6], m[10], 0, 0, 0, 0, 1];
}

/** A change from voxel to voxel of this share of the transfer function's span gets half of a surface's light. */
export const flatShare = 0.02;

/** The smallest width of a transfer function, as a share of the data's range: for functions of one value, or of a few close values. */
const minWidth = 0.05;

/**
 * If the change from voxel to voxel (data units) is below this, a field counts as flat: it has no direction and is not lit.
 * @param domain - data values that the transfer function spans
 * @param range - of the data
 */
export function flatChange([low, high]: readonly [number, number], range: readonly [number, number]): number {
  return flatShare * Math.max(high - low, minWidth * (range[1] - range[0]), Number.MIN_VALUE);
}

/** How much a place is lit: g^2 / (g^2 + g0^2). @param flat - g0 */
export function weighChange(perVoxel: Vector3, flat: number): number {
  const g = length(perVoxel) / flat;
  return 1 - 1 / (1 + g * g);
}
