import type { Vector3 } from '../volume/matrix.ts';
import { brickSide } from './brick-data.ts';
import { brickAround, cellOfPlace, cellsOfBrick, numberOfBrick } from './brick-layout.ts';
import type { BrickLayout } from './brick-layout.ts';
import { CellNumbers } from './cell-numbers.ts';
import type { Brick } from './pyramid.ts';

/** How far a brick is from what was there before it, in stored values. */
export interface MeasuredBrickDetail {
  readonly brick: Brick;
  /** Octaves between both levels; an octave is what a level shows beyond the next coarser one. */
  readonly octaves: number;
  /** Root of the mean square of each octave, as if all had the same detail; and the largest difference of all. */
  readonly rms: number;
  readonly max: number;
  /** By part, i fastest: how many times the brick's own each of both is there. */
  readonly parts: Float32Array;
}

/** Parts of a brick along each axis. How much is hidden is known for each of them: the rim of a thing is rougher than the rest of its brick. */
export const partsAlong = 4;
const partCount = partsAlong ** 3;

/** The part of a brick at a place in it. @param place - in the brick, 0..1 along each axis */
export function partAt(place: readonly number[]): number {
  const [i, j, k] = place.map((x) => Math.min(partsAlong - 1, Math.max(0, Math.floor(x * partsAlong))));
  return i + partsAlong * (j + partsAlong * k);
}

/**
 * What levels hide where bricks were looked at, also when these have gone: each place knows the finest one of them, and for the coarser octaves those around it.
 * Octaves that nobody has measured follow from the nearest one by what is usual in the pyramid. Blocks are parts of bricks,
 * numbered from 0 on.
 */
export class MeasuredDetail {
  readonly #bricks: MeasuredBrickDetail[] = [];
  /** By level: the number of each measured brick, by its number in the level. */
  readonly #byLevel: readonly Map<number, number>[];
  /** By cell: 1 + the number of the finest measured brick, 0 for none. */
  readonly #finest: CellNumbers;
  /** So many bricks are in `#finest`. */
  #placed = 0;
  readonly #levels: number;
  /** By brick, then by level: the octaves that are finer than this level. */
  #rms = new Float64Array(0);
  #max = new Float64Array(0);

  constructor(readonly layout: BrickLayout) {
    this.#levels = layout.levels.length + 1;
    this.#byLevel = layout.levels.map(() => new Map<number, number>());
    this.#finest = new CellNumbers(layout.cells, layout.groupSide);
  }

  has(brick: Brick): boolean {
    return this.of(brick) !== undefined;
  }

  of({ level, at }: Brick): MeasuredBrickDetail | undefined {
    return this.#bricks[this.#byLevel[level].get(numberOfBrick(this.layout, level, at)) ?? -1];
  }

  /** Counts from the next `update` on. */
  add(measured: MeasuredBrickDetail): void {
    const { level, at } = measured.brick;
    this.#byLevel[level].set(numberOfBrick(this.layout, level, at), this.#bricks.length);
    this.#bricks.push(measured);
  }

  /**
   * @param growth - by octave: how many times the detail of the next coarser one it usually has
   * @param peaks - by octave: its largest difference, in root mean squares
   */
  update(growth: Float64Array, peaks: Float64Array): void {
    this.#place();
    const levels = this.#levels;
    this.#rms = new Float64Array(this.#bricks.length * levels);
    this.#max = new Float64Array(this.#bricks.length * levels);
    const [rms, peak] = [new Float64Array(levels), new Float64Array(levels)];
    this.#bricks.forEach((measured, number) => {
      const { level } = measured.brick;
      let [last, end] = [measured, level + measured.octaves];
      for (let octave = level; octave < levels - 1; octave++) {
        const around = octave < end ? undefined : this.of(brickAround(this.layout, measured.brick, octave));
        if (around) [last, end] = [around, octave + around.octaves];
        rms[octave] = octave < end ? last.rms : rms[octave - 1] / growth[octave - 1];
        peak[octave] = last.rms > 0 ? last.max / last.rms : 0;
      }
      for (let octave = level - 1; octave >= 0; octave--) {
        rms[octave] = rms[octave + 1] * growth[octave];
        peak[octave] = Math.max(peak[octave + 1], peaks[octave]);
      }
      let [squares, highest] = [0, 0];
      for (let octave = 0; octave < levels - 1; octave++) {
        squares += rms[octave] ** 2;
        if (rms[octave] > 0) highest = Math.max(highest, peak[octave]);
        this.#rms[number * levels + octave + 1] = Math.sqrt(squares);
        this.#max[number * levels + octave + 1] = highest * Math.sqrt(squares);
      }
    });
  }

  /** The part of the finest brick that was measured at a place of the unit cube; -1 for none. */
  blockAt(place: Vector3): number {
    const number = this.#finest.at(...cellOfPlace(this.layout, place)) - 1;
    if (number < 0) return -1;
    const { level, at } = this.#bricks[number].brick;
    const { scale, shift } = this.layout.levels[level];
    const inBrick = place.map((x, axis) => (x * scale[axis] + shift[axis]) / brickSide - at[axis]);
    return number * partCount + partAt(inBrick);
  }

  /** What a level hides of the finest one in a block. */
  rms(block: number, level: number): number {
    return this.#partOf(block) * this.#rms[Math.floor(block / partCount) * this.#levels + level];
  }

  max(block: number, level: number): number {
    return this.#partOf(block) * this.#max[Math.floor(block / partCount) * this.#levels + level];
  }

  #partOf(block: number): number {
    return this.#bricks[Math.floor(block / partCount)].parts[block % partCount];
  }

  #place(): void {
    for (; this.#placed < this.#bricks.length; this.#placed++) {
      const { level, at } = this.#bricks[this.#placed].brick;
      const [low, high] = cellsOfBrick(this.layout, level, at);
      const isCoarser = (number: number): boolean => number === 0 || this.#bricks[number - 1].brick.level > level;
      this.#finest.change(low, high, (before) => (isCoarser(before) ? this.#placed + 1 : before));
    }
  }
}
