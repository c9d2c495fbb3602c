import { usualDwell } from './tour-attributes.ts';

/** Plays a tour: opens the next step after a time, unless something holds it. It uses the words of media elements. */
export class TourPlayer {
  #isOn = false;
  #dwell = usualDwell;
  readonly #holds = new Set<string>();
  #timer: ReturnType<typeof setTimeout> | undefined;

  /** @param advance - opens the next step */
  constructor(readonly advance: () => void) {}

  /** Whether nobody wants it to play. It may play, and wait. */
  get paused(): boolean {
    return !this.#isOn;
  }

  play(): void {
    this.#isOn = true;
    this.restart();
  }

  pause(): void {
    this.#isOn = false;
    this.restart();
  }

  /** It waits while something holds it. After that the step stays open for its whole time. @param reason - any word */
  hold(reason: string, isHeld: boolean): void {
    if (isHeld === this.#holds.has(reason)) return;
    if (isHeld) this.#holds.add(reason);
    else this.#holds.delete(reason);
    this.restart();
  }

  /** Another step is open. @param dwell - how long it stays open, ms */
  stay(dwell: number): void {
    this.#dwell = dwell;
    this.restart();
  }

  /** The time of the step begins now: somebody has just used the view. */
  restart(): void {
    clearTimeout(this.#timer);
    if (this.#isOn && this.#holds.size === 0) this.#timer = setTimeout(this.advance, this.#dwell);
  }
}
