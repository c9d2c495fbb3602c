// The attributes of a <volume-tour>, read from texts.
import { invalidAttribute } from '../../core/errors.ts';
import { isNumber } from '../model/parse-attributes.ts';

/** How long a move from step to step takes, ms. */
export const usualDuration = 600;

/** @returns milliseconds @throws {VolumeViewError} `attribute/invalid` */
export function readDuration(text: string | null): number {
  if (text === null) return usualDuration;
  if (isNumber(text) && Number(text) >= 0) return Number(text);
  throw invalidAttribute('duration of <volume-tour>', text, 'milliseconds, 0 or more');
}

/** Whether a tour follows the page as a person scrolls. @throws {VolumeViewError} `attribute/invalid` */
export function readBy(text: string | null): boolean {
  const word = text?.trim().toLowerCase() ?? '';
  if (word === '' || word === 'scroll') return word === 'scroll';
  throw invalidAttribute('by of <volume-tour>', word, 'scroll');
}

/**
 * The number of the open step, from 1; 0 for none.
 * @param count - of all steps
 * @throws {VolumeViewError} `attribute/invalid`; the open step then stays
 */
export function readStepNumber(text: string | null, count: number): number {
  if (count === 0) return 0;
  const step = text === null ? 1 : isNumber(text) ? Number(text) : NaN;
  if (Number.isInteger(step) && step >= 0 && step <= count) return step;
  throw invalidAttribute('step of <volume-tour>', text!, `the number of a step, 1 to ${count}, or 0 for none`);
}

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
