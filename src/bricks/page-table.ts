// Where the GPU's table of pages has what: for each cell (brick of the finest level), which brick is shown there.
import type { Vector3 } from '../volume/matrix.ts';
import { groupsOf } from './cell-numbers.ts';

/** Bytes of a cell in the GPU's table of pages: a texel of four floats. Twin: shaders/chunks/field/bricks-3d.glsl */
export const bytesOfCell = 16;

/** What the table needs to know of a `BrickLayout`. */
interface TableLayout {
  readonly cells: Vector3;
  readonly groupSide: number;
  readonly levels: readonly { readonly factors: Vector3 }[];
}

/** The GPU's table of pages, a 3D texture: a texel for each group of cells, then, along z, layers of blocks with a texel for each cell of a group. */
export interface TableShape {
  readonly side: number;
  readonly groups: Vector3;
  /** Blocks of a layer along x and y. */
  readonly columns: number;
  readonly rows: number;
  readonly width: number;
  readonly height: number;
}

/** Blocks of a layer along x and y, where there are not more groups. */
const leastColumns = 4;

export function shapeTable({ cells, groupSide: side }: Pick<TableLayout, 'cells' | 'groupSide'>): TableShape {
  const groups = groupsOf(cells, side);
  if (side === 1) return { side, groups, columns: 0, rows: 0, width: groups[0], height: groups[1] };
  const [width, height] = groups.map((n) => Math.max(leastColumns * side, n));
  return { side, groups, columns: Math.floor(width / side), rows: Math.floor(height / side), width, height };
}

/** Layers for so many blocks. There are at most as many as groups. */
export function layersOfTable({ side, groups: [gx, gy, gz], columns, rows }: TableShape, blocks: number): number {
  return side === 1 ? 0 : Math.ceil(Math.min(blocks, gx * gy * gz) / (columns * rows));
}

/** @param layers - of blocks */
export const tableDepth = ({ groups, side }: TableShape, layers: number): number => groups[2] + side * layers;

export const tableBytes = (shape: TableShape, layers: number): number =>
  bytesOfCell * shape.width * shape.height * tableDepth(shape, layers);

/** The first texel of a block. */
export function placeOfBlock({ side, groups, columns, rows }: TableShape, block: number): Vector3 {
  return [
    side * (block % columns),
    side * (Math.floor(block / columns) % rows),
    groups[2] + side * Math.floor(block / (columns * rows)),
  ];
}

/** Layers of blocks that so many bricks can need at most: one block for each group of which a brick covers a part. */
export function mostLayersOfTable({ levels, cells, groupSide }: TableLayout, bricks: number): number {
  const most = levels.map(({ factors }) =>
    factors.reduce((product, n) => product * (groupSide % n === 0 || n % groupSide === 0 ? 1 : 2), 1),
  );
  return layersOfTable(shapeTable({ cells, groupSide }), bricks * Math.max(...most));
}
