import type { RankedBrick } from '../../bricks/choose-bricks.ts';
import type { Brick } from '../../bricks/pyramid.ts';
import { untilEnough } from '../../bricks/rank-bricks.ts';
import type { BrickGains } from '../../bricks/rank-bricks.ts';
import { keyOfBrick } from '../../bricks/resident-bricks.ts';
import type { ResidentBricks } from '../../bricks/resident-bricks.ts';
import type { ResidentDetail } from '../../bricks/resident-detail.ts';
import type { Waiting } from '../../core/waiting.ts';
import type { ErrorPart } from '../../quality/error-estimate.ts';
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
const [mostExchanges, leastGain] = [2, 0.03];

/** Bricks that are so many levels finer than what counts may stay: a view that turns may need them again. */
const levelsToSpare = 1;

/** Estimates of the same bricks, by other rays each, of which the mean counts: a single ray may hold most of an error. At least two, unless the first is below this share of what is allowed. */
const [mostLooks, clearly] = [3, 0.5];

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
  /** What is left, by all estimates of these bricks. */
  readonly error: ErrorPart;
  /** Whether the same bricks have to be looked at by other rays before the picture is final. */
  readonly again: boolean;
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
  /** The squares of the last estimates of the same bricks; in a full room, of those that take each other's place. */
  #looks: { readonly of: string; squares: readonly number[] } = { of: '', squares: [] };
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

  choose(
    { error: { rms: last, p99, max }, gains, probes, finest, energy }: BrickEstimate,
    wish: PictureWish,
  ): ChosenBricks {
    const { key, maxError, slots, isAsking } = wish;
    if (key !== this.#exchanged.key || slots !== this.#exchanged.slots)
      this.#exchanged = { key, slots, times: 0, error: Infinity };
    const isFull = this.bricks.count >= slots;
    const looks = this.#look(`${key} ${isFull ? `in ${slots}` : this.bricks.changes}`, last);
    const rms = Math.sqrt(looks.reduce((sum, square) => sum + square, 0) / looks.length);
    const isBetter = last < (1 - leastGain) * this.#exchanged.error;
    if (isBetter) this.#exchanged.error = last;
    const limit = shareOfBricks * maxError;
    const isEnough = rms <= limit || (isFull && this.#exchanged.times >= mostExchanges);
    const count = Math.min(mostTurn, Math.max(leastTurn, Math.ceil(shareOfTurn * this.bricks.count)));
    const needed = (1 - ((shareOfGoal * maxError) / last) ** 2) * energy;
    const doubts = this.#doubt(gains, isEnough && !isAsking ? key : '');
    // Who has what the writer says need not look.
    const unknown = isAsking ? [] : [...probes, ...doubts].filter((brick) => !this.#isUnreadable(brick));
    // More will be known then.
    if (unknown.length > 0) this.#looks = { of: '', squares: [] };
    return {
      error: { rms, p99, max },
      again: isEnough && looks.length < 2 && rms > clearly * limit && unknown.length === 0 && !isAsking,
      probes: unknown,
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

  /** @returns the squares of the last estimates of the same bricks */
  #look(of: string, rms: number): readonly number[] {
    const before = this.#looks.of === of ? this.#looks.squares : [];
    this.#looks = { of, squares: [...before, rms ** 2].slice(-mostLooks) };
    return this.#looks.squares;
  }

  /** What was chosen has come, and took the place of others. */
  hasExchanged(): void {
    this.#exchanged.times++;
  }

  /** The room is full, and nothing that is missing brings enough to take a place. */
  endExchanges(): void {
    this.#exchanged.times = mostExchanges;
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
