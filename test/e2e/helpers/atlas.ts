// An atlas of the field: the same place in larger voxels, of which each has a label.
import type { Volume } from '../../../src/volume/volume.ts';
import { syntheticVolume } from '../../helpers/synthetic.ts';
import { field } from './volumes.ts';

/** Half of the field's voxels along each axis, in the same place: what lies to its right is 3, to its left 7. */
export const atlas: Volume = (() => {
  const [nx, ny, nz] = [12, 10, 8];
  const made = syntheticVolume({ dimensions: [nx, ny, nz], spacing: [2, 3, 4] });
  const { indexToWorld } = field.grid;
  const half = indexToWorld.map((entry, i) =>
    i < 12 && i % 4 < 3
      ? 2 * entry
      : i < 12
        ? entry + 0.5 * (indexToWorld[i - 1] + indexToWorld[i - 2] + indexToWorld[i - 3])
        : entry,
  );
  const isRight = (i: number): boolean => half[0] * (i + 0.5) > half[0] * (nx / 2);
  return {
    ...made,
    grid: { ...made.grid, indexToWorld: half },
    samples: Uint8Array.from({ length: nx * ny * nz }, (_, at) => (isRight(at % nx) ? 3 : 7)),
    slope: 1,
    intercept: 0,
  };
})();
