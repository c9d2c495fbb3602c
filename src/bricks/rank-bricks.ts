import { crossVolume, rayThrough } from '../optics/rays/rays.ts';
import type { RaySetup } from '../optics/rays/rays.ts';
import { brickAround, brickOfCell, cellOfPlace, numberOfBrick, placeOfCell } from './brick-layout.ts';
import type { BrickLayout } from './brick-layout.ts';
import type { RankedBrick } from './choose-bricks.ts';
import type { DetailListener } from './detail-scene.ts';
import type { Brick } from './pyramid.ts';
import type { ResidentBrick, ResidentBricks } from './resident-bricks.ts';
import type { Vector3 } from '../volume/matrix.ts';

/** What the bricks of a pyramid bring to a picture, and what those that are there are worth: sums over the cells that rays have met. */
export class BrickGains implements DetailListener {
  /** By level: energy by the number of the brick. */
  readonly #gains: readonly Map<number, number>[];
  readonly #worth: Float64Array;

  constructor(readonly bricks: ResidentBricks) {
    this.#gains = bricks.layout.levels.map(() => new Map<number, number>());
    this.#worth = new Float64Array(bricks.slots);
  }

  gain(cell: number, level: number, energy: number): void {
    if (!(energy > 0)) return;
    const number = numberOfBrick(this.bricks.layout, level, this.#brickOf(cell, level));
    const gains = this.#gains[level];
    gains.set(number, (gains.get(number) ?? 0) + energy);
  }

  loss(cell: number, energy: number): void {
    const slot = this.bricks.slotOf(cell);
    if (slot >= 0) this.#worth[slot] += energy;
  }

  /** What the picture would lose without a brick that is there. */
  worth({ slot }: ResidentBrick): number {
    return this.#worth[slot] ?? 0;
  }

  /**
   * The bricks that bring most, in their order. Of those that cover the same cells only one is chosen, as the second one would bring less than is known.
   * @param bytes - of each
   */
  rank(count: number, bytes: number, isLeftOut: (brick: Brick) => boolean): RankedBrick[] {
    const { layout } = this.bricks;
    const all = this.#gains.flatMap((gains, level) => [...gains].map(([number, gain]) => ({ level, number, gain })));
    all.sort((a, b) => b.gain - a.gain);
    /** Bricks that are chosen, and those that have such a brick inside. */
    const [taken, outer] = [new Set<string>(), new Set<string>()];
    const chosen: RankedBrick[] = [];
    for (const { level, number, gain } of all) {
      if (chosen.length >= count) break;
      const brick = { level, at: placeOf(layout, level, number) };
      if (isLeftOut(brick) || outer.has(`${level}/${number}`)) continue;
      const around = bricksAround(layout, brick);
      if (around.some((key) => taken.has(key))) continue;
      taken.add(around[0]);
      for (const key of around) outer.add(key);
      chosen.push({ brick, gain, bytes });
    }
    return chosen;
  }

  /** Of the bricks that have no finer ones inside which bring something, those that bring most. @param isLeftOut - of these nothing is in doubt */
  rankFinest(count: number, isLeftOut: (brick: Brick) => boolean): Brick[] {
    const { layout } = this.bricks;
    const found: { readonly brick: Brick; readonly gain: number }[] = [];
    const outer = new Set<string>();
    this.#gains.forEach((gains, level) => {
      for (const [number, gain] of gains) {
        const brick = { level, at: placeOf(layout, level, number) };
        if (!outer.has(`${level}/${number}`) && !isLeftOut(brick)) found.push({ brick, gain });
        for (const key of bricksAround(layout, brick)) outer.add(key);
      }
    });
    found.sort((a, b) => b.gain - a.gain);
    return found.slice(0, count).map(({ brick }) => brick);
  }

  #brickOf(cell: number, level: number): Vector3 {
    const { layout } = this.bricks;
    return brickOfCell(layout.levels[level], placeOfCell(layout, cell));
  }
}

/** The first of ranked bricks that bring so much together; all where they do not. @param least - at least so many */
export function untilEnough(
  ranked: readonly RankedBrick[],
  { needed, least }: { readonly needed: number; readonly least: number },
): readonly RankedBrick[] {
  let sum = 0;
  const end = ranked.findIndex(({ gain }, n) => (sum += gain) >= needed && n + 1 >= least);
  return end < 0 ? ranked : ranked.slice(0, end + 1);
}

/** Rays across and down of which some say where bricks are looked at, whatever is expected of them; and how many of those that meet the volume do. */
const [probesAcross, mostProbes] = [12, 9];

/** Shares of a ray from one probe to the next: they fill it evenly. */
const golden = 0.6180339887;

/**
 * The next bricks to look at before anything is said of what coarse bricks hide, as single bright voxels may leave no trace in a coarse level: at
 * places in the picture, from the coarsest level of bricks to the finest, one after the other.
 * @param isKnown - bricks that were looked at
 * @param finestAt - the finest level that counts, by a ray's parameter
 */
export function probeBricks(
  layout: BrickLayout,
  rays: RaySetup,
  isKnown: (brick: Brick) => boolean,
  finestAt: (t: number) => number = () => 0,
): Brick[] {
  const places: { readonly place: Vector3; readonly finest: number }[] = [];
  for (let n = 0; n < probesAcross ** 2; n++) {
    const [column, row] = [n % probesAcross, Math.floor(n / probesAcross)];
    const ray = rayThrough(rays, (2 * column + 1) / probesAcross - 1, 1 - (2 * row + 1) / probesAcross);
    const [enter, exit] = crossVolume(rays, ray);
    const entry = Math.max(enter, rays.eyeT);
    if (!(exit > entry)) continue;
    const t = entry + ((0.5 + n * golden) % 1) * (exit - entry);
    const place = ray.point.map((x, axis) => x + t * ray.direction[axis]) as unknown as Vector3;
    places.push({ place, finest: finestAt(t) });
  }
  const found = new Map<string, Brick>();
  const apart = Math.max(1, places.length / mostProbes);
  for (let n = apart / 2; n < places.length; n += apart) {
    const { place, finest } = places[Math.floor(n)];
    const cell = cellOfPlace(layout, place);
    for (let level = layout.levels.length - 1; level >= finest; level--) {
      const brick = { level, at: brickOfCell(layout.levels[level], cell) };
      if (isKnown(brick)) continue;
      found.set(`${level}/${numberOfBrick(layout, level, brick.at)}`, brick);
      break;
    }
  }
  return [...found.values()];
}

/** A brick, and the coarser ones that cover it. */
function bricksAround(layout: BrickLayout, brick: Brick): string[] {
  return layout.levels.slice(brick.level).map((_, n) => {
    const { level, at } = brickAround(layout, brick, brick.level + n);
    return `${level}/${numberOfBrick(layout, level, at)}`;
  });
}

function placeOf({ levels }: BrickLayout, level: number, number: number): Vector3 {
  const [nx, ny] = levels[level].bricks;
  return [number % nx, Math.floor(number / nx) % ny, Math.floor(number / (nx * ny))];
}
