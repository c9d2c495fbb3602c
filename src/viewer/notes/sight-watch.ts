// Looks how well the places of notes are seen: some of them with each picture while the camera moves, all of them when it rests.
import type { Viewer } from '../view/viewer.ts';
import type { NoteMark } from './note-mark.ts';
import { seePlaces, sightOf } from './see-places.ts';
import { SightTurns } from './sight-turns.ts';

/** The camera rests when it has not moved for this time, ms; where pictures take long, for the time of two pictures. */
const restMs = 120;

/** Pictures that come at longer intervals are not of one movement, ms. */
const maxInterval = 500;

/** What has the marks. */
export interface SightHost {
  marks(): readonly NoteMark[];
  viewer(): Viewer | null;
  /** While the camera moves, texts have to come or go. */
  changed(): void;
  /** The camera rests, and all marks were looked at as far as that is possible. */
  rested(): void;
}

/** Gives marks their sights. */
export class SightWatch {
  #timer = 0;
  /** When the last picture came. */
  #placedAt = 0;
  /** Identifies the last work at rest; earlier work is given up. */
  #work: object | null = null;
  readonly #turns = new SightTurns<NoteMark>();
  #isGlancing = false;
  #isOver = false;

  constructor(readonly host: SightHost) {}

  /** There is another picture. @param moves - whether marks are elsewhere in it */
  follow(moves: boolean): void {
    this.stop();
    if (moves) void this.#glance();
    this.#timer = window.setTimeout(() => void this.#rest(), this.#timeToRest());
  }

  /** Give up the work that begins when the camera rests. */
  stop(): void {
    clearTimeout(this.#timer);
    this.#work = null;
  }

  dispose(): void {
    this.stop();
    this.#isOver = true;
  }

  /** How long to wait for another picture, ms: work that begins too early would make a movement slow. */
  #timeToRest(): number {
    const before = this.#placedAt;
    this.#placedAt = performance.now();
    const interval = this.#placedAt - before;
    return interval > maxInterval ? restMs : Math.max(restMs, 2 * interval);
  }

  /** Look at the next places. A view that turns for long never rests. */
  async #glance(): Promise<void> {
    const marks = this.#turns.next(this.host.marks().filter(({ owner }) => owner.at));
    if (this.#isGlancing) return;
    this.#isGlancing = true;
    // Work that begins when the camera rests knows more.
    const isWanted = (): boolean => this.#work === null && !this.#isOver;
    try {
      if (await this.#see(marks, isWanted, true)) this.host.changed();
    } catch {
      // A part of the package could not be loaded: the rest says it.
    } finally {
      this.#isGlancing = false;
    }
  }

  async #rest(): Promise<void> {
    const work = (this.#work = {});
    const isWanted = (): boolean => this.#work === work;
    const viewer = this.host.viewer();
    // The first picture has places when it begins, and may take long.
    if (viewer && !viewer.drawn) await viewer.loop.settled(() => viewer.drawn !== null);
    try {
      await this.#see(
        this.host.marks().filter(({ owner }) => owner.at),
        isWanted,
        false,
      );
    } catch (error) {
      console.warn(error); // A part of the package could not be loaded: the notes stay as they are.
    }
    if (isWanted()) this.host.rested();
  }

  /** @returns whether some texts have to come or go */
  async #see(marks: readonly NoteMark[], isWanted: () => boolean, isMoving: boolean): Promise<boolean> {
    const viewer = this.host.viewer();
    if (!viewer || marks.length === 0) return false;
    const places = marks.map(({ owner }) => owner.at!);
    const seen = await seePlaces(viewer, places, isWanted, isMoving);
    if (!seen || !isWanted()) return false;
    this.#turns.seen(marks);
    let isOther = false;
    marks.forEach((mark, i) => {
      if (!this.host.marks().includes(mark)) return; // It has gone meanwhile.
      const wasAway = mark.isAway;
      mark.setSight(seen[i], sightOf(seen[i]));
      isOther ||= mark.isAway !== wasAway;
    });
    return isOther;
  }
}
