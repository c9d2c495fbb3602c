import { invalidAttribute } from '../../core/errors.ts';
import { isNumber } from '../model/parse-attributes.ts';

/** How long a step stays open, ms. */
export const usualDwell = 10_000;

/**
 * Read how long a step stays open.
 * @param text - seconds, 1 to 3600: text of the attribute; null where it is absent
 * @param name - of the attribute, for the message
 * @returns ms; null where it is absent
 * @throws {VolumeViewError} `attribute/invalid`
 */
export function readDwell(text: string | null, name: string): number | null {
  if (text === null) return null;
  const seconds = isNumber(text.trim()) ? Number(text) : NaN;
  if (seconds >= 1 && seconds <= 3600) return seconds * 1000;
  throw invalidAttribute(name, text, 'seconds, 1 to 3600');
}

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
