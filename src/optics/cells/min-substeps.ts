import { cellSize } from '../../volume/cell-size.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import type { SeenVolume } from './cell-detail.ts';
import { powerOfSteps } from '../transfer/power-of-steps.ts';
import { maxSubsteps } from '../transfer/substep-limits.ts';

/**
 * The smallest number of substeps for steps that begin at a place, by the code of its macrocell. Twin: shaders/chunks/walk/empty-space.glsl
 * @param codes - from `findDetail`
 */
export function minSubsteps(
  volume: SeenVolume['volume'],
  codes: Uint8Array,
  voxelsPerStep: number,
): (place: Vector3) => number {
  const {
    grid,
    macrocells: { dimensions: cells, size = cellSize },
  } = volume;
  const power = powerOfSteps(voxelsPerStep);
  return (place) => {
    const [i, j, k] = place.map((x, axis) =>
      Math.min(cells[axis] - 1, Math.max(0, Math.floor((x * grid.dimensions[axis]) / size))),
    );
    return 2 ** Math.min(Math.log2(maxSubsteps), Math.max(0, codes[i + cells[0] * (j + cells[1] * k)] + power));
  };
}
