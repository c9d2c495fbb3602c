import { cellSize } from './cell-size.ts';
import type { Vector3 } from './matrix.ts';
import { measureRoughness } from './roughness.ts';
import { allocateLike } from './samples.ts';
import type { Samples } from './samples.ts';

/**
 * The range of stored values in each block of voxels, in the samples' own type: as floats, those of a radar's box
 * would take more than half as much memory as its samples. In a cell without data `low` lies above `high`.
 */
export interface Macrocells {
  /** Cells along i, j and k. */
  readonly dimensions: Vector3;
  /** Smallest stored value of each cell, i fastest. */
  readonly low: Samples;
  /** Largest stored value of each cell. */
  readonly high: Samples;
  /**
   * How far each cell's samples are from lying in straight lines with those next to them: their largest second difference
   * along any axis, or more; stored units. See volume/roughness.ts
   */
  readonly roughness: Float32Array<ArrayBuffer>;
}

/** Cells without any value yet. */
export function emptyMacrocells(samples: Samples, dimensions: Vector3): Macrocells {
  const cells = dimensions[0] * dimensions[1] * dimensions[2];
  const [least, most] = samples instanceof Float32Array ? [-Infinity, Infinity] : [0, 2 ** (8 * samples.BYTES_PER_ELEMENT) - 1];
  return { dimensions, low: allocateLike(samples, cells).fill(most), high: allocateLike(samples, cells).fill(least), roughness: new Float32Array(cells) };
}

/**
 * The range of every value that interpolation can give at a point of a cell: of its own voxels, and of the voxels
 * next to it.
 */
export function buildMacrocells(samples: Samples, dimensions: Vector3): Macrocells {
  const cells = dimensions.map((n) => Math.ceil(n / cellSize)) as unknown as Vector3;
  const { low, high, roughness } = emptyMacrocells(samples, cells);
  // Along each axis a voxel belongs to its own cell and, next to a face, to the neighbour across it.
  const rows = dimensions.map((n, axis) => Array.from({ length: n }, (_, i) => cellsAround(i, cells[axis])));
  const row = { low: new Float32Array(cells[0]), high: new Float32Array(cells[0]) };
  for (let k = 0; k < dimensions[2]; k++) {
    for (let j = 0; j < dimensions[1]; j++) {
      const start = (k * dimensions[1] + j) * dimensions[0];
      measureRow(samples.subarray(start, start + dimensions[0]), row);
      for (let z = rows[2][k][0]; z <= rows[2][k][1]; z++) {
        for (let y = rows[1][j][0]; y <= rows[1][j][1]; y++) {
          const cell = cells[0] * (y + cells[1] * z);
          for (let x = 0; x < cells[0]; x++) {
            if (row.low[x] < low[cell + x]) low[cell + x] = row.low[x];
            if (row.high[x] > high[cell + x]) high[cell + x] = row.high[x];
          }
        }
      }
    }
  }
  measureRoughness({ samples, dimensions }, { dimensions: cells, low, high, cellSize }, roughness);
  return { dimensions: cells, low, high, roughness };
}

/** The range of each cell's share of one row of voxels, including the next voxel on both sides. */
function measureRow(values: Samples, row: { low: Float32Array; high: Float32Array }): void {
  for (let cell = 0; cell < row.low.length; cell++) {
    const end = Math.min(values.length, (cell + 1) * cellSize + 1);
    let low = Infinity;
    let high = -Infinity;
    for (let i = Math.max(0, cell * cellSize - 1); i < end; i++) {
      const value = values[i];
      if (value < low && value > -Infinity) low = value;
      if (value > high && value < Infinity) high = value;
    }
    row.low[cell] = low;
    row.high[cell] = high;
  }
}

/** First and last cell along an axis to which a voxel belongs. */
function cellsAround(index: number, cells: number): [number, number] {
  const own = Math.floor(index / cellSize);
  const place = index % cellSize;
  return [place === 0 ? Math.max(0, own - 1) : own, place === cellSize - 1 ? Math.min(cells - 1, own + 1) : own];
}
