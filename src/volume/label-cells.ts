import { chooseCellSize } from './cell-size.ts';
import type { LabelMap } from './labels.ts';

/** The labels that may occur at any point of each cell. */
export interface LabelCells {
  /** Voxels along each edge of a cell. */
  readonly size: number;
  /** Where the numbers of each cell begin, i fastest; the last entry is the end of the last cell. */
  readonly starts: Uint32Array;
  /** Each number once per cell. */
  readonly numbers: Uint16Array;
}

/**
 * Lists the labels of each cell's own voxels, and of those next to it, which vote too.
 * @param edge - voxels along the edge of a cell; those of a macrocell if absent
 * @yields the number of voxels that were examined, after each row of cells
 */
export function* listLabels(
  { numbers, dimensions, ids }: LabelMap,
  edge = chooseCellSize(dimensions),
): Generator<number, LabelCells, void> {
  const [nx, ny] = dimensions;
  const [cx, cy, cz] = dimensions.map((n) => Math.ceil(n / edge));
  const starts = new Uint32Array(cx * cy * cz + 1);
  const seenIn = new Int32Array(ids.length).fill(-1);
  let found = new Uint16Array(2 * starts.length);
  let count = 0;
  for (let z = 0, cell = 0; z < cz; z++) {
    for (let y = 0; y < cy; y++) {
      for (let x = 0; x < cx; x++, cell++) {
        starts[cell] = count;
        const [iEnd, jEnd, kEnd] = [x, y, z].map((at, axis) => Math.min(dimensions[axis], (at + 1) * edge + 1));
        for (let k = beginOf(z, edge); k < kEnd; k++) {
          for (let j = beginOf(y, edge); j < jEnd; j++) {
            const row = nx * (j + ny * k);
            for (let i = beginOf(x, edge), last = -1; i < iEnd; i++) {
              const number = numbers[row + i];
              if (number === last) continue;
              last = number;
              if (seenIn[number] === cell) continue;
              seenIn[number] = cell;
              if (count === found.length) found = grow(found);
              found[count++] = number;
            }
          }
        }
      }
      yield cx * edge ** 3;
    }
  }
  starts[starts.length - 1] = count;
  return { size: edge, starts, numbers: found.slice(0, count) };
}

function beginOf(cell: number, edge: number): number {
  return Math.max(0, cell * edge - 1);
}

function grow(numbers: Uint16Array): Uint16Array<ArrayBuffer> {
  const larger = new Uint16Array(2 * numbers.length);
  larger.set(numbers);
  return larger;
}

/** The label of each cell that has only one; -1 if it has several. */
export function findUniform({ starts, numbers }: LabelCells): Float32Array<ArrayBuffer> {
  return Float32Array.from({ length: starts.length - 1 }, (_, cell) =>
    starts[cell + 1] - starts[cell] === 1 ? numbers[starts[cell]] : -1,
  );
}
