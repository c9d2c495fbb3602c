import { cellsOf } from './pyramid.ts';
import type { Brick, Pyramid } from './pyramid.ts';

/** A brick with what it brings. */
export interface RankedBrick {
  readonly brick: Brick;
  /** In the unit of the gains. */
  readonly gain: number;
  readonly bytes: number;
}

/**
 * The bricks that bring most a byte, in their order. Bricks that cover the same cells are not chosen together, as the second one would bring less than
 * is known.
 * @param candidates - not resident ones, with the cells that they cover
 * @param gains - by cell * number of levels + level, as `estimateDetail` gives them
 * @param levelOf - the level that each cell has, or will have by what is on its way
 * @param count - at most so many
 */
export function chooseBricks(
  { levels }: Pyramid,
  candidates: readonly BrickCells[],
  { gains, levelOf, count }: { readonly gains: Float64Array; readonly levelOf: Uint8Array; readonly count: number },
): RankedBrick[] {
  const at = (cell: number, level: number): number => cell * levels.length + level;
  const ranked: (RankedBrick & { readonly cells: readonly number[] })[] = [];
  for (const { brick, bytes, cells } of candidates) {
    let gain = 0;
    for (const cell of cells)
      if (levelOf[cell] > brick.level)
        gain += Math.max(0, gains[at(cell, brick.level)] - gains[at(cell, levelOf[cell])]);
    if (gain > 0) ranked.push({ brick, gain, bytes, cells });
  }
  ranked.sort((a, b) => b.gain / b.bytes - a.gain / a.bytes);
  const taken = new Set<number>();
  const chosen: RankedBrick[] = [];
  for (const { cells, ...one } of ranked) {
    if (chosen.length >= count) break;
    if (cells.some((cell) => taken.has(cell))) continue;
    for (const cell of cells) taken.add(cell);
    chosen.push(one);
  }
  return chosen;
}

/** A brick that may be loaded. */
export interface BrickCells {
  readonly brick: Brick;
  readonly bytes: number;
  readonly cells: readonly number[];
}

/** A brick with the cells that it covers. @param bytes - that loading it takes */
export function describeBrick(pyramid: Pyramid, brick: Brick, bytes: number): BrickCells {
  return { brick, bytes, cells: cellsOf(pyramid, brick) };
}
