import type { Cutout, HalfSpace } from '../../src/optics/rays/clip-intervals.ts';
import { planeInCube } from '../../src/viewer/cuts/plane-in-cube.ts';
import { unitToWorld } from '../../src/volume/grid.ts';
import type { GridFrame } from '../../src/volume/grid.ts';
import { invertAffine, multiply, scaleAndTranslate } from '../../src/volume/matrix.ts';
import type { Vector3 } from '../../src/volume/matrix.ts';

/** Keep the half-space that the normal points to, from `at` on, in world units. */
export const keep = (grid: GridFrame, normal: Vector3, at: number): HalfSpace => ({
  kind: 'half-space',
  ...planeInCube(normal, at, grid),
});

/** Keep the inside of a box, in world coordinates. */
export const keepBox = (grid: GridFrame, low: Vector3, high: Vector3): HalfSpace[] =>
  [0, 1, 2].flatMap((axis) => {
    const normal = [0, 1, 2].map((one) => Number(one === axis)) as unknown as Vector3;
    return [keep(grid, normal, low[axis]), keep(grid, normal.map((x) => -x) as unknown as Vector3, -high[axis])];
  });

/** Cut out a box, in world coordinates. */
export const cutBox = (grid: GridFrame, low: Vector3, high: Vector3): Cutout => {
  const size = high.map((x, axis) => x - low[axis]) as unknown as Vector3;
  return { kind: 'cutout', unitToBox: multiply(invertAffine(scaleAndTranslate(size, low))!, unitToWorld(grid)) };
};
