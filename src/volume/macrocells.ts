import type { Vector3 } from './matrix.ts';
import type { Samples } from './volume.ts';

/** Voxels along each edge of a macrocell. */
export const cellSize = 8;

/** The range of stored values in each block of voxels. */
export interface Macrocells {
  /** Cells along i, j and k. */
  readonly dimensions: Vector3;
  /** Smallest stored value of each cell, i fastest; Infinity where a cell holds no data. */
  readonly low: Float32Array<ArrayBuffer>;
  /** Largest stored value of each cell; -Infinity where it holds no data. */
  readonly high: Float32Array<ArrayBuffer>;
}

/**
 * The range of every value that interpolation can give at a point of a cell: of its own voxels, and of the first ones
 * around it.
 */
export function buildMacrocells(samples: Samples, dimensions: Vector3): Macrocells {
  const cells = dimensions.map((n) => Math.ceil(n / cellSize)) as unknown as Vector3;
  const low = new Float32Array(cells[0] * cells[1] * cells[2]).fill(Infinity);
  const high = new Float32Array(low.length).fill(-Infinity);
  // Along each axis a voxel belongs to its own cell and, next to a face, to the neighbour across it.
  const reach = dimensions.map((n, axis) => Array.from({ length: n }, (_, i) => cellsAround(i, cells[axis])));
  let at = 0;
  for (let k = 0; k < dimensions[2]; k++) {
    for (let j = 0; j < dimensions[1]; j++) {
      for (let i = 0; i < dimensions[0]; i++, at++) {
        const value = samples[at];
        if (!Number.isFinite(value)) continue;
        for (let z = reach[2][k][0]; z <= reach[2][k][1]; z++) {
          for (let y = reach[1][j][0]; y <= reach[1][j][1]; y++) {
            for (let x = reach[0][i][0]; x <= reach[0][i][1]; x++) {
              const cell = x + cells[0] * (y + cells[1] * z);
              if (value < low[cell]) low[cell] = value;
              if (value > high[cell]) high[cell] = value;
            }
          }
        }
      }
    }
  }
  return { dimensions: cells, low, high };
}

/** First and last cell along an axis to which a voxel belongs. */
function cellsAround(index: number, cells: number): [number, number] {
  const own = Math.floor(index / cellSize);
  const place = index % cellSize;
  return [place === 0 ? Math.max(0, own - 1) : own, place === cellSize - 1 ? Math.min(cells - 1, own + 1) : own];
}
