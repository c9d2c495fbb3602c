import { cartesianGrid, unitToWorld } from '../../volume/grid.ts';
import { multiply, scaleAndTranslate } from '../../volume/matrix.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import type { Volume } from '../../volume/volume.ts';

/** An image of slices has no place of its own: X3D's textures fill the volume's box, each on its own grid. */
export function stretchOver(volume: Volume, over: Volume): Volume {
  const { dimensions } = volume.grid;
  const [scale, offset] = [1, 0.5].map((share) => dimensions.map((n) => share / n) as unknown as Vector3);
  return {
    ...volume,
    grid: cartesianGrid(dimensions, multiply(unitToWorld(over.grid), scaleAndTranslate(scale, offset))),
  };
}
