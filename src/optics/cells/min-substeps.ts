import type { Vector3 } from '../../volume/matrix.ts';
import type { SeenVolume } from './cell-detail.ts';
import { powerOfSteps } from '../transfer/power-of-steps.ts';
import { maxSubsteps } from '../transfer/substep-limits.ts';

/**
 * The smallest number of substeps for steps that begin at a place, by the code of its macrocell. Below 1, so many steps are taken as one as the number goes into 1:
 * no more than lie in the macrocell. Twin: shaders/chunks/walk/empty-space.glsl, and `spacingOf` of shaders/chunks/field/bricks-3d.glsl
 * @param codes - from `findDetail`
 */
export function minSubsteps(
  volume: SeenVolume['volume'],
  codes: Uint8Array,
  voxelsPerStep: number,
): (place: Vector3, forward: Vector3) => number {
  const {
    grid,
    macrocells: { dimensions: cells, size },
  } = volume;
  const power = powerOfSteps(voxelsPerStep);
  const inCells = (x: number, axis: number): number => (x * grid.dimensions[axis]) / size;
  return (place, forward) => {
    const at = place.map(inCells);
    const cell = at.map((x, axis) => Math.min(cells[axis] - 1, Math.max(0, Math.floor(x))));
    // As `readCode` of cell-detail.ts says, which another part of the package holds.
    const code = codes[cell[0] + cells[0] * (cell[1] + cells[1] * cell[2])];
    const longer = 2 ** (code >> 2);
    const own = Math.min(maxSubsteps, Math.max(1, 2 ** ((code & 3) + power)));
    if (longer <= own || voxelsPerStep === 0) return Math.max(1, own / longer);
    const toWall = forward.map((way, axis) => {
      const step = inCells(way, axis);
      return step === 0 ? Infinity : (cell[axis] + Number(step > 0) - at[axis]) / step;
    });
    return 1 / Math.max(1, Math.min(longer / own, Math.floor(Math.min(...toWall) - 0.01)));
  };
}
