import { maxSubsteps } from './substep-limits.ts';

/**
 * What brings a cell's code to the power of 2 into which its steps are cut: samples are no farther apart than it needs, and on a lattice
 * that halves from power to power.
 * @param voxelsPerStep - voxels of the finest axis that a step is long; 0 where cells have no say
 * @returns less than any code where they have none
 */
export function powerOfSteps(voxelsPerStep: number): number {
  return voxelsPerStep > 0 ? Math.ceil(Math.log2(voxelsPerStep) - 0.01) : -maxSubsteps;
}
