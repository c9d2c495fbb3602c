import { maxSubsteps } from './substep-limits.ts';

/**
 * Add this to a cell's code to get the power of 2 of its number of substeps. Then samples are no farther apart than the cell needs, and they
 * lie on a lattice whose spacing halves from power to power.
 * @param voxelsPerStep - length of a step in voxels of the finest axis; 0 if cells do not matter
 * @returns a number that makes every code negative if cells do not matter
 */
export function powerOfSteps(voxelsPerStep: number): number {
  return voxelsPerStep > 0 ? Math.ceil(Math.log2(voxelsPerStep) - 0.01) : -maxSubsteps;
}
