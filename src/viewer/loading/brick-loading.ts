import type { BrickSamples } from '../../bricks/brick-data.ts';
import type { SharedRoom } from './brick-room.ts';
import type { RankedBrick } from '../../bricks/choose-bricks.ts';
import type { Brick } from '../../bricks/pyramid.ts';
import { bricksAtOnce } from '../../formats/base/brick-limits.ts';
import { keyOfBrick } from '../../bricks/resident-bricks.ts';
import type { ResidentBrick, ResidentBricks } from '../../bricks/resident-bricks.ts';

/**
 * A brick makes room for another only if that one brings at least so many times as much a byte: else two bricks would take each other's
 * place again and again.
 */
const worthExchange = 1.5;

/** What loading bricks needs. */
export interface BrickLoadingParts {
  readonly bricks: ResidentBricks;
  read(brick: Brick, signal: AbortSignal): Promise<BrickSamples>;
  readonly room: SharedRoom;
  /** The GPU's bytes of a brick, with its halo. */
  readonly bytesOfBrick: number;
  /** Bricks have come or gone: the picture is another one. */
  changed(): void;
  /** There may be more bricks than before. */
  grew(): void;
  /** A brick could not be read. It is not asked for again. */
  failed(error: unknown): void;
}

/** What the present view wants. */
export interface WantedBricks {
  /** Bricks that are not there, by falling gain a byte. */
  readonly missing: readonly RankedBrick[];
  /** What the picture would lose a byte without a brick that is there, in the unit of the gains a byte. */
  worth(brick: ResidentBrick): number;
}

const nothing: WantedBricks = { missing: [], worth: () => 0 };

/**
 * The life of the bricks of one view: it reads what the view wants most, within its share of the page's room, gives up what the view no longer
 * wants, and lets go of what is worth least when something better comes. While a view stays, what it shows only becomes finer.
 */
export class BrickLoading {
  readonly #flying = new Map<string, AbortController>();
  readonly #refused = new Set<string>();
  #wanted = nothing;
  /** What each missing brick of the present view brings a byte: so much it is worth when it is there. Else it might have to go for itself. */
  #brings = new Map<string, number>();
  #isClosed = false;
  #share = Infinity;
  readonly #fit = (): void => this.#followShare();

  constructor(readonly parts: BrickLoadingParts) {
    parts.room.enter(this.#fit);
  }

  /** Bytes of the bricks that are there, and of those that are on their way. */
  get bytes(): number {
    return (this.parts.bricks.count + this.#flying.size) * this.parts.bytesOfBrick;
  }

  /** Requests that are on their way. */
  get requests(): number {
    return this.#flying.size;
  }

  /** Whether nothing that the view wants is on its way, or could come. */
  get isSettled(): boolean {
    return this.#flying.size === 0;
  }

  /** Whether a brick could not be read. */
  isRefused(brick: Brick): boolean {
    return this.#refused.has(keyOfBrick(brick));
  }

  /** The view wants other bricks: requests for bricks that it no longer wants are given up. */
  want(wanted: WantedBricks): void {
    if (this.#isClosed) return;
    this.#wanted = wanted;
    this.#brings = new Map(wanted.missing.map(({ brick, gain, bytes }) => [keyOfBrick(brick), gain / bytes]));
    for (const [key, controller] of this.#flying) {
      if (this.#brings.has(key)) continue;
      this.#flying.delete(key);
      controller.abort();
    }
    this.#send();
  }

  /** The picture shows these no longer. */
  drop(tooFine: readonly Brick[]): void {
    for (const brick of tooFine) this.parts.bricks.remove(brick);
    if (tooFine.length > 0) this.parts.changed();
  }

  /** Ends all requests. The bricks that are there stay, and no longer count. */
  close(): void {
    if (this.#isClosed) return;
    this.want(nothing);
    this.#isClosed = true;
    this.parts.room.leave(this.#fit);
  }

  #send(): void {
    for (const ranked of this.#wanted.missing) {
      if (this.#flying.size >= bricksAtOnce) return;
      const key = keyOfBrick(ranked.brick);
      if (this.#flying.has(key) || this.#refused.has(key) || this.parts.bricks.get(ranked.brick)) continue;
      if (!this.#makeRoom(ranked)) return;
      void this.#read(key, ranked.brick);
    }
  }

  async #read(key: string, brick: Brick): Promise<void> {
    const { bricks, read, changed, failed } = this.parts;
    const controller = new AbortController();
    this.#flying.set(key, controller);
    try {
      const samples = await read(brick, controller.signal);
      // What was given up may still come: its place was given to others.
      if (controller.signal.aborted) return;
      this.#flying.delete(key);
      bricks.add(brick, samples);
      changed();
    } catch (error) {
      if (controller.signal.aborted) return;
      this.#flying.delete(key);
      this.#refused.add(key);
      failed(error);
    }
    this.#send();
  }

  /** @returns whether one more brick has room */
  #makeRoom({ gain, bytes }: RankedBrick): boolean {
    const { bricks, room, bytesOfBrick, changed } = this.parts;
    if (this.bytes + bytesOfBrick <= room.share) return true;
    if (bytesOfBrick > room.share) return false;
    const { least, worth } = this.#leastWorth();
    if (!least || worth * worthExchange > gain / bytes) return false;
    bricks.remove(least);
    changed();
    return this.bytes + bytesOfBrick <= room.share;
  }

  #leastWorth(): { readonly least: ResidentBrick | null; readonly worth: number } {
    let [least, worth]: [ResidentBrick | null, number] = [null, Infinity];
    for (const brick of this.parts.bricks.bricks) {
      const its = this.#brings.get(keyOfBrick(brick)) ?? this.#wanted.worth(brick);
      if (its < worth) [least, worth] = [brick, its];
    }
    return { least, worth };
  }

  /** The share has become smaller, or larger. */
  #followShare(): void {
    const { bricks, room, changed, grew } = this.parts;
    if (room.share > this.#share) grew();
    this.#share = room.share;
    const before = bricks.count;
    while (this.bytes > room.share && bricks.count > 0) bricks.remove(this.#leastWorth().least!);
    for (const [key, controller] of this.#flying) {
      if (this.bytes <= room.share) break;
      this.#flying.delete(key);
      controller.abort();
    }
    if (bricks.count !== before) changed();
    this.#send();
  }
}
