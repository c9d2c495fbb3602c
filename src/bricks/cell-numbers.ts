import type { Vector3 } from '../volume/matrix.ts';

/** What a box of cells that all have one number get: one number, or null where it is not the same for all of them. The last cell is inside of the box. */
export type NextNumber = (before: number, first: Vector3, last: Vector3) => number | null;

/**
 * A number from 0 on for each cell of a grid, in groups of cells: a group has one number for all of its cells, or a block with a number for each.
 * So what is the same over large parts takes little memory, however many cells there are.
 */
export class CellNumbers {
  /** Groups along each axis. */
  readonly groups: Vector3;
  /** By group, i fastest: the number of all of its cells; or -1 - its block. */
  readonly directory: Int32Array;
  /** How many blocks there are room for; some may be free. */
  blockCount = 0;
  /** Counts changes; and the last change of each layer of groups along k, and of each block. */
  changes = 0;
  readonly changesOfLayers: Uint32Array;
  readonly changesOfBlocks: number[] = [];
  /** By block: its group, or -1 while it is free. */
  readonly groupsOfBlocks: number[] = [];
  /** By block, then by cell, i fastest. */
  #blocks = new Int32Array(0);
  readonly #free: number[] = [];

  /**
   * @param cells - along each axis
   * @param side - cells along each axis of a group
   */
  constructor(
    readonly cells: Vector3,
    readonly side: number,
  ) {
    const [gx, gy, gz] = (this.groups = groupsOf(cells, side));
    this.directory = new Int32Array(gx * gy * gz);
    this.changesOfLayers = new Uint32Array(gz);
  }

  at(i: number, j: number, k: number): number {
    const { side, directory, groups } = this;
    if (side === 1) return directory[i + groups[0] * (j + groups[1] * k)];
    const [x, y, z] = [Math.floor(i / side), Math.floor(j / side), Math.floor(k / side)];
    const entry = directory[x + groups[0] * (y + groups[1] * z)];
    if (entry >= 0) return entry;
    return this.#blocks[side ** 3 * (-1 - entry) + (i - side * x) + side * (j - side * y + side * (k - side * z))];
  }

  /** A block's numbers, i fastest. */
  block(block: number): Int32Array {
    const size = this.side ** 3;
    return this.#blocks.subarray(size * block, size * (block + 1));
  }

  /** Calls for the numbers of a box of cells, once or more often each. @param last - is inside */
  visit(first: Vector3, last: Vector3, visit: (number: number) => void): void {
    this.#visitGroups(first, last, (group, low, high) => {
      const entry = this.directory[group];
      if (entry >= 0) return visit(entry);
      const block = this.block(-1 - entry);
      this.#visitBlock(low, high, (cell) => visit(block[cell]));
    });
  }

  /** Gives a box of cells other numbers. Where it reaches the grid's end, it has the cells of the last groups that lie beyond, too. @param high - is outside */
  change(low: Vector3, high: Vector3, next: NextNumber): void {
    const { cells, side, groups } = this;
    this.changes++;
    const last = high.map((n, axis) => (n >= cells[axis] ? side * groups[axis] : n) - 1) as unknown as Vector3;
    const inside = (cell: Vector3): Vector3 =>
      cell.map((n, axis) => Math.min(cells[axis] - 1, n)) as unknown as Vector3;
    this.#visitGroups(low, last, (group, from, to, origin) => {
      const entry = this.directory[group];
      const isWhole = from.every((n, axis) => n === 0 && to[axis] === side - 1);
      const cellAt = (place: Vector3): Vector3 =>
        inside(place.map((n, axis) => n + origin[axis]) as unknown as Vector3);
      if (entry >= 0) {
        const number = next(entry, cellAt(from), cellAt(to));
        if (number === entry) return;
        if (isWhole && number !== null) return this.#setEntry(group, number);
      }
      const number = entry < 0 ? -1 - entry : this.#takeBlock(group, entry);
      const block = this.block(number);
      this.changesOfBlocks[number] = this.changes;
      this.#visitBlock(from, to, (cell, place) => {
        const at = cellAt(place);
        block[cell] = next(block[cell], at, at)!;
      });
      if (block.every((one) => one === block[0])) this.#giveBlock(group, number, block[0]);
    });
  }

  /** Counts a box of cells as changed, for who reads more than their numbers. @param high - is outside */
  touch(low: Vector3, high: Vector3): void {
    this.changes++;
    const { cells, groups } = this;
    const last = high.map((n, axis) => Math.min(n, cells[axis]) - 1) as unknown as Vector3;
    this.#visitGroups(low, last, (group) => {
      const entry = this.directory[group];
      if (entry < 0) this.changesOfBlocks[-1 - entry] = this.changes;
      else this.changesOfLayers[Math.floor(group / (groups[0] * groups[1]))] = this.changes;
    });
  }

  #setEntry(group: number, entry: number): void {
    this.directory[group] = entry;
    this.changesOfLayers[Math.floor(group / (this.groups[0] * this.groups[1]))] = this.changes;
  }

  /** A block for a group whose cells all have a number. */
  #takeBlock(group: number, number: number): number {
    const size = this.side ** 3;
    const block = this.#free.pop() ?? this.blockCount++;
    if (this.#blocks.length < size * this.blockCount) {
      const larger = new Int32Array(Math.max(2 * this.#blocks.length, size * this.blockCount));
      larger.set(this.#blocks);
      this.#blocks = larger;
    }
    this.block(block).fill(number);
    this.groupsOfBlocks[block] = group;
    this.#setEntry(group, -1 - block);
    return block;
  }

  #giveBlock(group: number, block: number, number: number): void {
    this.#free.push(block);
    this.groupsOfBlocks[block] = -1;
    this.#setEntry(group, number);
  }

  /** The groups that a box touches: what of it lies in each of them, and the group's first cell. */
  #visitGroups(
    first: Vector3,
    last: Vector3,
    visit: (group: number, from: Vector3, to: Vector3, origin: Vector3) => void,
  ): void {
    const { side, groups } = this;
    const [from, to] = [first, last].map((ends) => ends.map((n) => Math.floor(n / side)));
    for (let z = from[2]; z <= to[2]; z++)
      for (let y = from[1]; y <= to[1]; y++)
        for (let x = from[0]; x <= to[0]; x++) {
          const origin: Vector3 = [side * x, side * y, side * z];
          visit(
            x + groups[0] * (y + groups[1] * z),
            first.map((n, axis) => Math.max(0, n - origin[axis])) as unknown as Vector3,
            last.map((n, axis) => Math.min(side - 1, n - origin[axis])) as unknown as Vector3,
            origin,
          );
        }
  }

  /** The cells of a box in a block. */
  #visitBlock(from: Vector3, to: Vector3, visit: (cell: number, place: Vector3) => void): void {
    const { side } = this;
    for (let k = from[2]; k <= to[2]; k++)
      for (let j = from[1]; j <= to[1]; j++)
        for (let i = from[0]; i <= to[0]; i++) visit(i + side * (j + side * k), [i, j, k]);
  }
}

/** Groups along each axis. */
export const groupsOf = (cells: Vector3, side: number): Vector3 =>
  cells.map((n) => Math.ceil(n / side)) as unknown as Vector3;

/** Cells along each axis of a group that there may be. */
const sides = [1, 4, 8, 16];

/** So many blocks are expected at most: bricks that are there. */
const usualBlocks = 512;

/** The side of groups for which cells take least memory. */
export function chooseGroupSide(cells: Vector3): number {
  const numbersOf = (side: number): number =>
    groupsOf(cells, side).reduce((all, n) => all * n, 1) + (side === 1 ? 0 : usualBlocks * side ** 3);
  return sides.reduce((best, side) => (numbersOf(side) < numbersOf(best) ? side : best), 1);
}
