import { chooseCellSize } from './cell-size.ts';
import { offLine } from './grid.ts';
import type { Vector3 } from './matrix.ts';
import { alongX, alongY, alongZ, high as highOf, low as lowOf, measureRow, perCell, seam } from './measure-row.ts';
import type { Measures, Row } from './measure-row.ts';
import { allocateLike } from './samples.ts';
import type { Samples } from './samples.ts';

/**
 * The range of stored values in each block of voxels, in the samples' own type: as floats, the ranges of a radar's box
 * would take more than half as much memory as its samples. In a cell without data `low` lies above `high`.
 */
export interface Macrocells {
  /** Cells along i, j and k. */
  readonly dimensions: Vector3;
  /** Voxels along each edge of a cell: less than one where finer voxels lie over the volume. */
  readonly size: number;
  /** Smallest stored value of each cell, i fastest. */
  readonly low: Samples;
  /** Largest stored value of each cell. */
  readonly high: Samples;
  /**
   * How far each cell's samples are from lying in straight lines with their neighbours: their largest second difference
   * along any axis, or more; stored units. See `buildMacrocells`.
   */
  readonly roughness: Float32Array<ArrayBuffer>;
  /** The power of two by which voxels shown in a cell are longer than the shortest that are shown anywhere, or less; absent: all have one length. */
  readonly longer?: Uint8Array;
}

/** A cell that is this rough, as a share of its range, gets a roughness that makes its whole range count. */
const enough = 0.6;

/**
 * Cells without any value yet.
 * @param voxels - along i, j and k
 * @param size - voxels along each edge of a cell
 */
export function emptyMacrocells(samples: Samples, voxels: Vector3, size: number): Macrocells {
  const dimensions = voxels.map((n) => Math.ceil(n / size)) as unknown as Vector3;
  const cells = dimensions[0] * dimensions[1] * dimensions[2];
  const [min, max] =
    samples instanceof Float32Array ? [-Infinity, Infinity] : [0, 2 ** (8 * samples.BYTES_PER_ELEMENT) - 1];
  return {
    dimensions,
    size,
    low: allocateLike(samples, cells).fill(max),
    high: allocateLike(samples, cells).fill(min),
    roughness: new Float32Array(cells),
  };
}

/**
 * The range of every value that interpolation can give at a point of a cell: of its own voxels, and of the voxels next
 * to it. Also, how far its values are from lying in straight lines: the largest second difference along any axis, |v(i
 * - 1) - 2 v(i) + v(i + 1)|, stored units; beyond the grid the last sample is repeated. A difference counts if it bends
 * values of the cell: at the cell's own planes of voxels along that axis, and across it up to one voxel outside, so
 * that a voxel at a corner counts for all cells that meet there. Samples without data (NaN) are left out.
 * @param size - voxels along each edge of a cell
 */
export function buildMacrocells(samples: Samples, dimensions: Vector3, size = chooseCellSize(dimensions)): Macrocells {
  const [nx, ny, nz] = dimensions;
  const cells = emptyMacrocells(samples, dimensions, size);
  const [cx, cy] = cells.dimensions;
  const found: Measures =
    samples instanceof Float32Array ? new Float64Array(perCell * cx) : new Int32Array(perCell * cx);
  const row: Row = { at: 0, end: 0, down: 0, up: 0, back: 0, forth: 0, ofY: 0, ofZ: 0 };
  const [alongK, alongJ] = [splitAxis(nz, size), splitAxis(ny, size)];
  for (const { from: k0, to: k1, cell: z, last: lastZ } of alongK) {
    for (const { from: j0, to: j1, cell: y, last: lastY } of alongJ) {
      const places: Place[] = [];
      for (let c = z; c <= lastZ; c++)
        for (let b = y; b <= lastY; b++) places.push({ at: cx * (b + cy * c), ofY: b - y, ofZ: c - z });
      beginWith(found, cells, places);
      for (let k = k0; k < k1; k++) {
        row.back = k > 0 ? -nx * ny : 0;
        row.forth = k < nz - 1 ? nx * ny : 0;
        row.ofZ = alongZ + Math.floor(k / size) - z;
        for (let j = j0; j < j1; j++) {
          row.down = j > 0 ? -nx : 0;
          row.up = j < ny - 1 ? nx : 0;
          row.ofY = alongY + Math.floor(j / size) - y;
          row.at = nx * (j + ny * k);
          row.end = row.at + nx;
          measureRow(samples, row, size, found);
        }
      }
      for (const place of places) addRow(cells, place, found);
    }
  }
  countAllOfRough(cells);
  return cells;
}

/** Voxels along an axis that count for the same cells: each voxel for its own cell, and those at a border for both. */
interface Part {
  readonly from: number;
  readonly to: number;
  readonly cell: number;
  /** `cell`, or the one after it. */
  readonly last: number;
}

function splitAxis(voxels: number, size: number): Part[] {
  const cells = Math.ceil(voxels / size);
  const parts: Part[] = [];
  for (let cell = 0; cell < cells; cell++) {
    const begin = cell * size;
    const part = {
      from: cell > 0 ? begin + 1 : 0,
      to: cell < cells - 1 ? begin + size - 1 : voxels,
      cell,
      last: cell,
    };
    if (part.to > part.from) parts.push(part);
    // The part at the border comes after the parts in both cells: it then seldom changes their maximum, which
    // processors predict well.
    if (cell > 0) parts.push({ from: begin - 1, to: begin + 1, cell: cell - 1, last: cell });
  }
  return parts;
}

/** A row of cells for which rows of voxels count. */
interface Place {
  /** The first of the cells. */
  readonly at: number;
  /** Which of the measures along y and z belong to its own voxels: 0, or 1 for the second. */
  readonly ofY: number;
  readonly ofZ: number;
}

/** The initial measures: what all of these cells have already. */
function beginWith(found: Measures, { low, high, roughness }: Macrocells, places: readonly Place[]): void {
  let before = 0;
  for (let i = 0, x = 0; i < found.length; i += perCell, x++) {
    let cell = places[0].at + x;
    let min = low[cell];
    let max = high[cell];
    let rough = roughness[cell];
    for (let n = 1; n < places.length; n++) {
      cell = places[n].at + x;
      if (low[cell] > min) min = low[cell];
      if (high[cell] < max) max = high[cell];
      if (roughness[cell] < rough) rough = roughness[cell];
    }
    found[i + lowOf] = min;
    found[i + highOf] = max;
    found[i + alongX] = rough;
    // What lies between this cell and the one before counts for both.
    const both = rough < before ? rough : before;
    for (let side = i + alongY; side < i + alongY + 4; side++) {
      found[side] = rough;
      if (x > 0) found[side + seam - perCell] = both;
      found[side + seam] = 0;
    }
    before = rough;
  }
}

function addRow({ low, high, roughness }: Macrocells, { at, ofY, ofZ }: Place, found: Measures): void {
  for (let i = 0, cell = at; i < found.length; i += perCell, cell++) {
    if (found[i + lowOf] < low[cell]) low[cell] = found[i + lowOf];
    if (found[i + highOf] > high[cell]) high[cell] = found[i + highOf];
    const [y, z] = [i + alongY + ofY, i + alongZ + ofZ];
    let rough = Math.max(found[i + alongX], found[y], found[z], found[y + seam], found[z + seam]);
    if (i > 0) rough = Math.max(rough, found[y + seam - perCell], found[z + seam - perCell]);
    if (rough > roughness[cell]) roughness[cell] = rough;
  }
}

function countAllOfRough({ low, high, roughness }: Macrocells): void {
  for (let cell = 0; cell < roughness.length; cell++) {
    const all = (high[cell] - low[cell]) / offLine;
    if (all > 0 && roughness[cell] >= Math.fround(enough * all)) roughness[cell] = all;
  }
}
