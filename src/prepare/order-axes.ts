import { cartesianGrid } from '../volume/grid.ts';
import type { GridFrame } from '../volume/grid.ts';
import type { Matrix4, Vector3 } from '../volume/matrix.ts';
import { allocateLike } from '../volume/samples.ts';
import type { Samples } from '../volume/samples.ts';

/** Samples on a grid, i fastest. */
export interface PlacedSamples {
  readonly grid: GridFrame;
  readonly samples: Samples;
}

/**
 * The same samples in an order in which i runs most along x of the world, j along y and k along z, forwards or backwards. As it is where no such order is.
 */
export function orderAxes({ grid, samples }: PlacedSamples): PlacedSamples {
  const { dimensions, indexToWorld: m } = grid;
  const axes = [0, 1, 2];
  /** By axis of the world, the axis of the grid that runs most along it. */
  const from = axes.map((row) => axes.reduce((a, b) => (Math.abs(m[4 * row + b]) > Math.abs(m[4 * row + a]) ? b : a)));
  if (new Set(from).size < 3 || from.every((axis, row) => axis === row)) return { grid, samples };
  const ordered = from.map((axis) => dimensions[axis]) as unknown as Vector3;
  const strides = [1, dimensions[0], dimensions[0] * dimensions[1]];
  const [a, b, c] = from.map((axis) => strides[axis]);
  const moved = allocateLike(samples, samples.length);
  for (let k = 0, at = 0; k < ordered[2]; k++)
    for (let j = 0; j < ordered[1]; j++)
      for (let i = 0; i < ordered[0]; i++) moved[at++] = samples[a * i + b * j + c * k];
  const world: Matrix4 = axes
    .flatMap((row) => [...from.map((axis) => m[4 * row + axis]), m[4 * row + 3]])
    .concat(0, 0, 0, 1);
  return { grid: cartesianGrid(ordered, world), samples: moved };
}
