import { offLine } from './cell-size.ts';
import type { Samples } from './samples.ts';
import type { Vector3 } from './matrix.ts';

/** A cell that is this rough, as a share of its range, needs no closer look: all of its range counts. */
const enough = 0.6;

/** Ranges of stored values in blocks of voxels. */
interface Ranges {
  readonly dimensions: Vector3;
  readonly low: Samples;
  readonly high: Samples;
  /** Voxels along the edge of a block. */
  readonly cellSize: number;
}

/**
 * How far the values in each macrocell are from lying in straight lines: the largest second difference along any axis,
 * |v(i - 1) - 2 v(i) + v(i + 1)|, stored units; beyond the grid the last sample goes on. It counts where it bends values of
 * the cell: at the cell's own planes of voxels along that axis, and across it up to one voxel outside, so that what stands at a
 * corner is seen by all cells that meet there. Places without data are left out. A cell of which most of the range could be off is
 * said to be as rough as makes all of it count.
 * @param roughness - filled, a number for each cell
 */
export function measureRoughness(
  { samples, dimensions }: { readonly samples: Samples; readonly dimensions: Vector3 }, { dimensions: cells, low, high, cellSize }: Ranges, roughness: Float32Array,
): void {
  const [nx, ny, nz] = dimensions;
  const [cx, cy, cz] = cells;
  const found = watchCells({ low, high }, cx, roughness);
  const row: RowRoughness = { wanted: new Uint8Array(cx), x: new Float64Array(cx), y: new Float64Array(cx), z: new Float64Array(cx), first: new Float64Array(2 * cx), last: new Float64Array(2 * cx) };
  for (let k = 0; k < nz; k++) {
    const [k0, k1] = cellsAround(k, cz, cellSize);
    for (let j = 0; j < ny; j++) {
      const [j0, j1] = cellsAround(j, cy, cellSize);
      row.wanted.fill(0);
      let isWanted = false;
      for (let z = k0; z <= k1; z++) for (let y = j0; y <= j1; y++) isWanted = found.mark(y + cy * z, row.wanted) || isWanted;
      if (!isWanted) continue;
      const at = nx * (j + ny * k);
      const steps: Steps = { down: j > 0 ? -nx : 0, up: j < ny - 1 ? nx : 0, back: k > 0 ? -nx * ny : 0, forth: k < nz - 1 ? nx * ny : 0 };
      measureRow(samples, { at, end: at + nx, cellSize, steps }, row);
      for (let z = k0; z <= k1; z++) {
        for (let y = j0; y <= j1; y++) found.add(y + cy * z, row, Math.floor(j / cellSize) === y, Math.floor(k / cellSize) === z);
      }
    }
  }
}

/** First and last cell along an axis of which values are bent at a plane of voxels, or beside it. */
function cellsAround(index: number, cells: number, cellSize: number): readonly [number, number] {
  const own = Math.floor(index / cellSize);
  const place = index % cellSize;
  return [place === 0 ? Math.max(0, own - 1) : own, place === cellSize - 1 ? Math.min(cells - 1, own + 1) : own];
}

/** Offsets of the samples next to one, 0 where there is none. */
interface Steps {
  readonly down: number;
  readonly up: number;
  readonly back: number;
  readonly forth: number;
}

/** A row's largest second differences in each cell, along x, y and z; and of y and z those of the cell's first and last voxel. */
interface RowRoughness {
  /** 1 for the cells of which x, y and z are wanted. */
  readonly wanted: Uint8Array;
  readonly x: Float64Array;
  readonly y: Float64Array;
  readonly z: Float64Array;
  readonly first: Float64Array;
  readonly last: Float64Array;
}

function measureRow(
  samples: Samples, { at: begin, end, cellSize, steps: { down, up, back, forth } }: { at: number; end: number; cellSize: number; steps: Steps }, row: RowRoughness,
): void {
  let at = begin;
  let value = samples[begin];
  let left = value;
  for (let cell = 0; at < end; cell++) {
    const to = Math.min(end, at + cellSize);
    row.first[2 * cell] = secondDifference(samples, at, down, up);
    row.first[2 * cell + 1] = secondDifference(samples, at, back, forth);
    if (!row.wanted[cell]) {
      at = to;
      left = samples[at - 1];
      value = samples[at];
      row.last[2 * cell] = secondDifference(samples, at - 1, down, up);
      row.last[2 * cell + 1] = secondDifference(samples, at - 1, back, forth);
      continue;
    }
    let y = 0;
    let z = 0;
    let mostX = 0;
    let mostY = 0;
    let mostZ = 0;
    for (; at < to; at++) {
      const right = at + 1 < end ? samples[at + 1] : value;
      const twice = value + value;
      const x = left + right - twice;
      y = samples[at + down] + samples[at + up] - twice;
      z = samples[at + back] + samples[at + forth] - twice;
      // NaN is not larger than anything.
      if (x > mostX) mostX = x;
      else if (-x > mostX) mostX = -x;
      if (y > mostY) mostY = y;
      else if (-y > mostY) mostY = -y;
      if (z > mostZ) mostZ = z;
      else if (-z > mostZ) mostZ = -z;
      left = value;
      value = right;
    }
    row.x[cell] = mostX;
    row.y[cell] = mostY;
    row.z[cell] = mostZ;
    row.last[2 * cell] = sizeOf(y);
    row.last[2 * cell + 1] = sizeOf(z);
  }
}

/** @param before, after - offsets of the samples next to it */
function secondDifference(samples: Samples, at: number, before: number, after: number): number {
  return sizeOf(samples[at + before] + samples[at + after] - 2 * samples[at]);
}

/** 0 where there is no difference. */
function sizeOf(difference: number): number {
  return Math.abs(difference) > 0 ? Math.abs(difference) : 0;
}

/** Cells and what is known of their roughness: rows of cells in which all are rough enough need no closer look. */
interface RoughCells {
  /** Mark the cells of a row that are still looked at. @returns whether there are any */
  mark(rowOfCells: number, wanted: Uint8Array): boolean;
  /** A row of voxels in or beside a row of cells. @param isOwnJ, isOwnK - whether it is in it along y and z */
  add(rowOfCells: number, row: RowRoughness, isOwnJ: boolean, isOwnK: boolean): void;
}

function watchCells({ low, high }: Pick<Ranges, 'low' | 'high'>, perRow: number, roughness: Float32Array): RoughCells {
  // Of each row of cells, those that are still looked at; and of each of these what is enough, 0 for the others.
  const left = new Int32Array(roughness.length / perRow);
  const enoughs = new Float32Array(roughness.length);
  for (let cell = 0; cell < roughness.length; cell++) {
    if (!(high[cell] > low[cell])) continue;
    enoughs[cell] = (enough * (high[cell] - low[cell])) / offLine;
    left[Math.floor(cell / perRow)]++;
  }
  return {
    mark(rowOfCells, wanted) {
      if (left[rowOfCells] === 0) return false;
      const begin = rowOfCells * perRow;
      for (let i = 0; i < perRow; i++) if (enoughs[begin + i] > 0) wanted[i] = 1;
      return true;
    },
    add(rowOfCells, { x, y, z, first, last }, isOwnJ, isOwnK) {
      if (left[rowOfCells] === 0) return;
      for (let i = 0, cell = rowOfCells * perRow; i < perRow; i++, cell++) {
        const most = enoughs[cell];
        if (most === 0) continue;
        let rough = Math.max(x[i], roughness[cell]);
        if (isOwnJ) rough = Math.max(rough, y[i], i > 0 ? last[2 * i - 2] : 0, i < perRow - 1 ? first[2 * i + 2] : 0);
        if (isOwnK) rough = Math.max(rough, z[i], i > 0 ? last[2 * i - 1] : 0, i < perRow - 1 ? first[2 * i + 3] : 0);
        roughness[cell] = rough;
        if (rough < most) continue;
        roughness[cell] = (high[cell] - low[cell]) / offLine;
        enoughs[cell] = 0;
        left[rowOfCells]--;
      }
    },
  };
}
