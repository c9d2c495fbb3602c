import type { SeenVolume } from './cell-detail.ts';
import { maxSubsteps } from '../transfer/substep-limits.ts';

/** How steps are cut into substeps. */
export interface Substeps {
  /** Of a step, where much may be seen at its ends. */
  readonly most: number;
  /** Voxels of the finest axis that a step is long, so that cells are sampled as finely as they need; 0 where they have no say. */
  readonly voxelsPerStep: number;
  /** What may be lost of a thing, 0..1, see `findDetail` of optics/cells/cell-detail.ts. */
  readonly mayLose: number;
  /** That function, which comes with what chooses steps: pictures before need none. */
  readonly findDetail?: (seen: SeenVolume, mayLose: number) => Uint8Array;
}

/** Whether steps are cut at all, as in pictures at rest. */
export function isCut({ most, voxelsPerStep }: Substeps): boolean {
  return most > 1 || voxelsPerStep > 0;
}

/** Not at all. */
export const wholeSteps: Substeps = { most: 1, voxelsPerStep: 0, mayLose: 0 };

/** By what is at the ends of steps alone. */
export const allSubsteps: Substeps = { most: maxSubsteps, voxelsPerStep: 0, mayLose: 0 };
