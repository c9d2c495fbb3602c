import { cellSize } from './cell-size.ts';
import type { LabelMap } from './labels.ts';

/** Which labels any place of each macrocell may have. */
export interface LabelCells {
  /** Where the numbers of each cell begin, i fastest, and where the last one's end. */
  readonly starts: Uint32Array;
  /** Each number once a cell. */
  readonly numbers: Uint16Array;
}

/**
 * List the labels of each macrocell's own voxels, and of those next to it, which vote too.
 * @yields the voxels that were looked at, after each row of cells
 */
export function* listLabels({ numbers, dimensions, ids }: LabelMap): Generator<number, LabelCells, void> {
  const [nx, ny, nz] = dimensions;
  const [cx, cy, cz] = dimensions.map((n) => Math.ceil(n / cellSize));
  const starts = new Uint32Array(cx * cy * cz + 1);
  const seenIn = new Int32Array(ids.length).fill(-1);
  let found = new Uint16Array(2 * starts.length);
  let count = 0;
  for (let z = 0, cell = 0; z < cz; z++) {
    for (let y = 0; y < cy; y++) {
      for (let x = 0; x < cx; x++, cell++) {
        starts[cell] = count;
        const [iEnd, jEnd, kEnd] = [endOf(x, nx), endOf(y, ny), endOf(z, nz)];
        for (let k = beginOf(z); k < kEnd; k++) {
          for (let j = beginOf(y); j < jEnd; j++) {
            const row = nx * (j + ny * k);
            for (let i = beginOf(x), last = -1; i < iEnd; i++) {
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
      yield cx * cellSize ** 3;
    }
  }
  starts[starts.length - 1] = count;
  return { starts, numbers: found.slice(0, count) };
}

function beginOf(cell: number): number {
  return Math.max(0, cell * cellSize - 1);
}

function endOf(cell: number, voxels: number): number {
  return Math.min(voxels, (cell + 1) * cellSize + 1);
}

function grow(numbers: Uint16Array): Uint16Array<ArrayBuffer> {
  const larger = new Uint16Array(2 * numbers.length);
  larger.set(numbers);
  return larger;
}
