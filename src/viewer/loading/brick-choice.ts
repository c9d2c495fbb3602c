import type { RankedBrick } from '../../bricks/choose-bricks.ts';
import type { Brick } from '../../bricks/pyramid.ts';
import { untilEnough } from '../../bricks/rank-bricks.ts';
import type { BrickGains } from '../../bricks/rank-bricks.ts';
import { keyOfBrick } from '../../bricks/resident-bricks.ts';
import type { ResidentBricks } from '../../bricks/resident-bricks.ts';
import type { ResidentDetail } from '../../bricks/resident-detail.ts';
import type { Waiting } from '../../core/waiting.ts';
import type { Volume } from '../../volume/volume.ts';
import { estimateBricks } from './brick-estimate.ts';
import type { BrickEstimate } from './brick-estimate.ts';
import type { KeyedPicture } from './brick-picture.ts';
import { isSteep, loadSteepCode } from './brick-steep.ts';

/** Bricks that are asked for before the view is looked at again: at least so many, and this share of those that are there. */
const [leastTurn, shareOfTurn, mostTurn] = [48, 0.5, 1024];

/** The error of a picture that is left to bricks, as a share of all that it may have: steps may have 0.6, and both add up as squares. */
const shareOfBricks = 0.8;

/** Bricks are asked for until the error should be this share of what it may be: others are missing where these rays do not look. */
const shareOfGoal = 0.5;

/** Where the room is full, bricks that bring more take the place of others, until this has brought the error down by less than this share so many times. */
const [mostExchanges, leastGain] = [3, 0.03];

/** Bricks that are so many levels finer than what counts may stay: a view that turns may need them again. */
const levelsToSpare = 1;

/** Bricks that are looked at before the estimate is relied on. */
const mostDoubts = 6;

/** What a picture asks for. */
export interface PictureWish {
  /** Another one is another picture. */
  readonly key: string;
  readonly maxError: number;
  /** Bricks that there is room for. */
  readonly slots: number;
  /** Whether the writer of the pyramid may still say what it hides. */
  readonly isAsking: boolean;
  /** Bricks that could not be read. */
  isRefused(brick: Brick): boolean;
}

export interface ChosenBricks {
  /** Bricks to look at, after which the estimate is made again. */
  readonly probes: readonly Brick[];
  /** Bricks to ask for, by falling gain a byte; none where the picture has enough. */
  readonly missing: readonly RankedBrick[];
  /** Bricks that are there and much finer than anything in the picture: rays would take their steps everywhere. */
  readonly tooFine: readonly Brick[];
  /** Whether they only take the place of others, for little. */
  readonly isExchange: boolean;
}

/** Which bricks a view asks for next, and when it has enough. */
export class BrickChoice {
  /** How often bricks of a picture took the place of others for little, and the smallest error that there was in this room. */
  #exchanged = { key: '', slots: 0, times: 0, error: Infinity };
  /** The picture for which what was in doubt has been looked at. */
  #sureOf = '';
  /** How often a picture was looked at. */
  #turns = { key: '', turn: 0 };
  readonly #unreadable = new Set<string>();

  constructor(
    readonly bricks: ResidentBricks,
    readonly detail: ResidentDetail,
  ) {}

  /** What bricks would bring to a picture, with pauses; null where no ray can be cast. Where styles need it, code is loaded first. */
  async estimate(volume: Volume, picture: KeyedPicture): Promise<Waiting<BrickEstimate | null>> {
    const steepCode = isSteep(picture.optics) ? await loadSteepCode() : undefined;
    if (picture.key !== this.#turns.key) this.#turns = { key: picture.key, turn: 0 };
    const turn = this.#turns.turn++;
    return estimateBricks({ volume, bricks: this.bricks, detail: this.detail }, picture, { turn, steepCode });
  }

  choose({ error: { rms }, gains, probes, finest, energy }: BrickEstimate, wish: PictureWish): ChosenBricks {
    const { key, maxError, slots, isAsking } = wish;
    if (key !== this.#exchanged.key || slots !== this.#exchanged.slots)
      this.#exchanged = { key, slots, times: 0, error: Infinity };
    const isFull = this.bricks.count >= slots;
    const isBetter = rms < (1 - leastGain) * this.#exchanged.error;
    if (isBetter) this.#exchanged.error = rms;
    const isEnough = rms <= shareOfBricks * maxError || (isFull && this.#exchanged.times >= mostExchanges);
    const count = Math.min(mostTurn, Math.max(leastTurn, Math.ceil(shareOfTurn * this.bricks.count)));
    const needed = (1 - ((shareOfGoal * maxError) / rms) ** 2) * energy;
    const doubts = this.#doubt(gains, isEnough && !isAsking ? key : '');
    return {
      // Who has what the writer says need not look.
      probes: isAsking ? [] : [...probes, ...doubts].filter((brick) => !this.#isUnreadable(brick)),
      missing: isEnough
        ? []
        : untilEnough(
            gains.rank(count, this.bricks.bytesOfBrick, (brick) => wish.isRefused(brick)),
            { needed, least: leastTurn },
          ),
      tooFine: [...this.bricks.bricks].filter(({ level }) => level < finest - levelsToSpare),
      isExchange: isFull && !isBetter,
    };
  }

  /** What was chosen has come, and took the place of others. */
  hasExchanged(): void {
    this.#exchanged.times++;
  }

  /** A probe could not be read. */
  leaveOut(brick: Brick): void {
    this.#unreadable.add(keyOfBrick(brick));
  }

  /**
   * Before a picture is called final, bricks are looked at of which most is expected and nothing known.
   * @param key - of the picture; empty while more bricks come
   */
  #doubt(gains: BrickGains, key: string): Brick[] {
    const isSure = key === '' || key === this.#sureOf;
    this.#sureOf = key;
    if (isSure) return [];
    return gains.rankFinest(mostDoubts, (brick) => this.#isUnreadable(brick) || this.detail.isMeasured(brick));
  }

  #isUnreadable(brick: Brick): boolean {
    return this.#unreadable.has(keyOfBrick(brick));
  }
}
