import { slotSide } from '../../bricks/brick-data.ts';
import type { BrickSamples } from '../../bricks/brick-data.ts';
import { brickOfCell, cellOfPlace } from '../../bricks/brick-layout.ts';
import type { Brick } from '../../bricks/pyramid.ts';
import { keyOfBrick } from '../../bricks/resident-bricks.ts';
import type { ResidentBricks } from '../../bricks/resident-bricks.ts';
import { bricksAtOnce } from '../../formats/base/brick-limits.ts';
import { brickSampler } from '../../panes/brick-field.ts';
import { chooseLevelOfPlane } from '../../panes/plane-bricks.ts';
import type { FinerLevel, PlaneField, PlaneVoxels, ViewedPlane } from '../../volume/finer-voxels.ts';
import { transformDirection } from '../../volume/matrix.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import type { Samples } from '../../volume/samples.ts';
import type { Volume } from '../../volume/volume.ts';

/** Bytes of bricks that are kept for planes in the page's memory, and those that one plane may need. */
const [maxBytes, maxBytesOfPlane] = [2 ** 26, 2 ** 25];

/** A plane is painted again at most so often while its bricks come, ms. */
const pause = 150;

/** A pick waits for a brick at most so long, ms: then it has what has come. */
const patienceMs = 5000;

export interface BrickTilesParts {
  readonly volume: Volume;
  readonly levels: readonly FinerLevel[];
  /** Those that are there for the GPU are not read again. */
  readonly bricks: ResidentBricks;
  read(brick: Brick, signal: AbortSignal): Promise<BrickSamples>;
  /** A brick could not be read. It is not asked for again. */
  failed(error: unknown): void;
}

/** What somebody looks at. */
interface Look {
  readonly bricks: readonly Brick[];
  changed(): void;
  readonly settle: () => void;
  /** Whether more has come than was painted. */
  isBehind: boolean;
}

/** Bricks that planes and picks need: they are read where somebody looks, and the ones that were looked at last are kept. */
export class BrickTiles implements PlaneVoxels {
  readonly #looks = new Map<object, Look>();
  /** In the order of their last use. */
  readonly #kept = new Map<string, Samples>();
  readonly #flying = new Map<string, AbortController>();
  readonly #refused = new Set<string>();
  #timer = 0;
  #isResting = false;

  constructor(readonly parts: BrickTilesParts) {}

  get requests(): number {
    return this.#flying.size;
  }

  get #bytesOfBrick(): number {
    return slotSide ** 3 * this.parts.volume.samples.BYTES_PER_ELEMENT;
  }

  /** The voxels of a brick, if they are there for a plane or for the GPU. */
  samplesOf(brick: Brick): Samples | undefined {
    const { bricks } = this.parts;
    return this.#kept.get(keyOfBrick(brick)) ?? (bricks.isComplete(brick) ? bricks.get(brick)?.samples : undefined);
  }

  open(owner: object, plane: ViewedPlane, changed: () => void): PlaneField | null {
    const { volume, levels } = this.parts;
    const most = Math.floor(maxBytesOfPlane / this.#bytesOfBrick);
    const chosen = chooseLevelOfPlane(levels, volume.grid, plane, most);
    const done = this.#look(owner, chosen?.bricks ?? [], changed);
    if (!chosen) return null;
    const { level, worldToIndex } = chosen;
    const coarse = { ...volume, dimensions: volume.grid.dimensions, indexToWorld: volume.grid.indexToWorld };
    const samplesOf = (at: Vector3): Samples | undefined => this.samplesOf({ level, at });
    const across = transformDirection(worldToIndex, plane.way).reduce((sum, x) => sum + Math.abs(x), 0);
    return {
      worldToIndex,
      sampleAt: brickSampler({ ...levels[level], samplesOf }, coarse, plane.isNearest),
      planes: across > 0 ? 1 + Math.ceil(across) : 1,
      done,
    };
  }

  close(owner: object): void {
    this.#forget(owner);
    this.#send();
  }

  async readAt(place: Vector3): Promise<void> {
    const { layout } = this.parts.bricks;
    const brick = { level: 0, at: brickOfCell(layout.levels[0], cellOfPlace(layout, place)) };
    const owner = {};
    let timer = 0;
    const late = new Promise<void>((resolve) => (timer = setTimeout(resolve, patienceMs) as unknown as number));
    await Promise.race([this.#look(owner, [brick], () => {}), late]);
    clearTimeout(timer);
    this.close(owner);
  }

  /** Nothing comes for now, as the view does not show the volume, or can't read it: who waits, and who comes, has what has come. */
  rest(): void {
    this.#isResting = true;
    for (const { settle } of this.#looks.values()) settle();
  }

  /** The view shows the volume again. */
  wake(): void {
    this.#isResting = false;
  }

  /** @returns when all bricks are there that can be */
  #look(owner: object, bricks: readonly Brick[], changed: () => void): Promise<void> {
    this.#forget(owner);
    if (bricks.length === 0) {
      this.#send();
      return Promise.resolve();
    }
    const done = new Promise<void>((settle) => this.#looks.set(owner, { bricks, changed, settle, isBehind: false }));
    // What somebody looks at now is let go of last.
    for (const brick of bricks) this.#use(keyOfBrick(brick));
    this.#send();
    if (this.#isResting) this.#looks.get(owner)?.settle();
    return done;
  }

  #forget(owner: object): void {
    const look = this.#looks.get(owner);
    this.#looks.delete(owner);
    look?.settle();
  }

  #use(key: string): void {
    const samples = this.#kept.get(key);
    if (!samples) return;
    this.#kept.delete(key);
    this.#kept.set(key, samples);
  }

  #isMissing(brick: Brick): boolean {
    return !this.samplesOf(brick) && !this.#refused.has(keyOfBrick(brick));
  }

  /** Gives up what nobody looks at, asks for what is missing, one after the other for all who look, and says who has all. */
  #send(): void {
    const looks = [...this.#looks.values()];
    const missing = looks.map(({ bricks }) => bricks.filter((brick) => this.#isMissing(brick)));
    const wanted = new Set(missing.flat().map(keyOfBrick));
    for (const [key, controller] of this.#flying) {
      if (wanted.has(key)) continue;
      this.#flying.delete(key);
      controller.abort();
    }
    for (let n = 0; missing.some((bricks) => n < bricks.length) && this.#flying.size < bricksAtOnce; n++)
      for (const bricks of missing)
        if (n < bricks.length && this.#flying.size < bricksAtOnce && !this.#flying.has(keyOfBrick(bricks[n])))
          void this.#read(bricks[n]);
    looks.forEach((look, n) => {
      if (missing[n].length > 0) return;
      this.#paint(look);
      look.settle();
    });
  }

  #paint(look: Look): void {
    if (look.isBehind) look.changed();
    look.isBehind = false;
  }

  async #read(brick: Brick): Promise<void> {
    const key = keyOfBrick(brick);
    const controller = new AbortController();
    this.#flying.set(key, controller);
    try {
      const { samples } = await this.parts.read(brick, controller.signal);
      if (controller.signal.aborted) return;
      this.#keep(key, samples);
    } catch (error) {
      if (controller.signal.aborted) return;
      this.#refused.add(key);
      this.parts.failed(error);
    }
    this.#flying.delete(key);
    for (const look of this.#looks.values()) look.isBehind ||= look.bricks.some((one) => keyOfBrick(one) === key);
    this.#paintSoon();
    this.#send();
  }

  #keep(key: string, samples: Samples): void {
    this.#kept.set(key, samples);
    const wanted = new Set([...this.#looks.values()].flatMap(({ bricks }) => bricks.map(keyOfBrick)));
    for (const old of this.#kept.keys()) {
      if (this.#kept.size * this.#bytesOfBrick <= maxBytes) break;
      if (!wanted.has(old)) this.#kept.delete(old);
    }
  }

  #paintSoon(): void {
    if (this.#timer !== 0) return;
    this.#timer = setTimeout(() => {
      this.#timer = 0;
      for (const look of [...this.#looks.values()]) this.#paint(look);
    }, pause) as unknown as number;
  }
}
