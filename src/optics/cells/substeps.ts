import type { SeenVolume } from './cell-detail.ts';
import { maxSubsteps } from '../transfer/substep-limits.ts';

/** How steps are cut into substeps. */
export interface Substeps {
  /** The largest number of substeps of a step where much may be visible at its ends. */
  readonly max: number;
  /** The length of a step in voxels of the finest axis, so that each cell is sampled as finely as it needs; 0 if cells do not matter. */
  readonly voxelsPerStep: number;
  /** How much of a thing may be lost, 0..1, see `findDetail` of optics/cells/cell-detail.ts. */
  readonly mayLose: number;
  /** Steps may be longer than a voxel where little can be lost: the code for a ray's program that takes such steps. Absent: no step is. */
  readonly long?: StepCode;
  /** `findDetail`. It is loaded with the code that chooses steps; earlier pictures do not need it. */
  readonly findDetail?: (seen: SeenVolume, mayLose: number) => Uint8Array;
}

/** A part of a ray's program that says how long steps are. */
export interface StepCode {
  readonly name: string;
  readonly defines: Readonly<Record<string, string | number>>;
  /** GLSL. */
  readonly count: string;
}

/** Whether steps are cut at all. Pictures at rest cut them. */
export function isCut({ max, voxelsPerStep }: Substeps): boolean {
  return max > 1 || voxelsPerStep > 0;
}

/** Steps are not cut. */
export const wholeSteps: Substeps = { max: 1, voxelsPerStep: 0, mayLose: 0 };

/** Only the samples at the ends of a step decide how it is cut. */
export const allSubsteps: Substeps = { max: maxSubsteps, voxelsPerStep: 0, mayLose: 0 };
