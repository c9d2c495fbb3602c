import type { Vector3 } from '../volume/matrix.ts';

/** The levels of a pyramid that are resident, cell by cell. A cell is a brick of the finest level. */
export interface DetailField {
  /** The number of levels, with the coarsest one, which is resident everywhere. */
  readonly levels: number;
  /** The stored value at a place of the unit cube, at the level that its cell has; NaN for no data. */
  valueAt(x: number, y: number, z: number): number;
  /** Edges of the voxels that are there, as shares of the unit cube; those of the finest level if undefined. */
  voxelAt?(x: number, y: number, z: number): Vector3;
  cellAt(x: number, y: number, z: number): number;
  /** The level of a cell. */
  levelOf(cell: number): number;
  /** The level that a cell would have without its present brick; the next coarser one if undefined. */
  levelWithout?(cell: number): number;
}

/** The level that a cell would have without its brick, where that is asked; else its level. */
export function levelWithoutBrick(field: DetailField, isAsked: boolean): (cell: number, level: number) => number {
  return (cell, level) => (isAsked ? (field.levelWithout?.(cell) ?? Math.min(field.levels - 1, level + 1)) : level);
}
