// What a <volume-question> asks, and whether a response is right: plain values, without a page.
import { invalidAttribute, VolumeViewError } from '../../core/errors.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import { isNumber, parseWord } from '../model/parse-attributes.ts';
import { readNotePlace } from '../notes/note-place.ts';
import type { NotePlace } from '../notes/note-place.ts';

/** What a reader does: choose from a list, click a place, name a marked place, read a value. */
export type QuestionType = 'choice' | 'find' | 'label' | 'value';

const types: readonly QuestionType[] = ['choice', 'find', 'label', 'value'];

/** An answer that a reader may choose. */
export interface Choice {
  readonly text: string;
  readonly isCorrect: boolean;
}

/** The attributes of a question, read. */
export interface Question {
  readonly type: QuestionType;
  readonly choices: readonly Choice[];
  /** The place to find, or the marked place; null for none. */
  readonly place: NotePlace | null;
  /** `find`: ids of labels, any of which is right; empty for none. */
  readonly labels: readonly string[];
  /** `find`: in world units. */
  readonly radius: number;
  /** `label`: names that are right. `value`: the right value. */
  readonly answers: readonly string[];
  /** `value`: a response may differ from the right value by so much. */
  readonly tolerance: number;
  /** How often a reader may answer; Infinity for any number. */
  readonly tries: number;
}

/** What a reader answers. */
export type Response =
  | { readonly chosen: readonly number[] }
  | { readonly text: string }
  /** A place as `position` has it, and the label there. */
  | { readonly position: Vector3; readonly label?: string };

const owner = ' of <volume-question>';

/** The longest text of a response. */
export const maxText = 500;

/**
 * @param text - returns the text of an attribute, null where it is absent
 * @param choices - the items of the list between the tags
 * @throws {VolumeViewError} `attribute/invalid`
 */
export function readQuestion(text: (name: string) => string | null, choices: readonly Choice[]): Question {
  const given = (name: string): string | null => text(name)?.trim() || null;
  const type = parseWord(`type${owner}`, given('type') ?? 'choice', types);
  if (type === 'choice') checkChoices(choices);
  if (text('remember') !== null && !given('id'))
    throw new VolumeViewError(
      'attribute/invalid',
      '<volume-question> got remember without an id; expected an id, under which the page keeps the answer.',
    );
  const labels = type === 'find' ? readLabels(given('of')) : [];
  const place = type === 'choice' ? null : readPlace(text, type, labels);
  return {
    type,
    choices: type === 'choice' ? choices : [],
    place,
    labels,
    radius: type === 'find' && labels.length === 0 ? readLength('radius', given('radius'), 0) : 0,
    answers: readAnswers(type, given('answer')),
    tolerance: type === 'value' && given('tolerance') ? readLength('tolerance', given('tolerance'), -1) : 0,
    tries: readTries(given('tries')),
  };
}

function checkChoices(choices: readonly Choice[]): void {
  if (choices.length > 1 && choices.some(({ isCorrect }) => isCorrect)) return;
  const got = choices.length > 1 ? 'no answer that is correct' : `a list of ${choices.length} answers`;
  throw new VolumeViewError(
    'attribute/invalid',
    `<volume-question> got ${got}; expected a list between its tags, <ul><li correct>This one</li><li>Not this one</li></ul>.`,
  );
}

function readLabels(text: string | null): string[] {
  const words = text?.split(/[\s,]+/) ?? [];
  if (!words.every((word) => /^[+-]?\d{1,15}$/.test(word)))
    throw invalidAttribute(`of${owner}`, text!, 'numbers of labels, like "23" or "10 49"');
  return words.map((word) => String(Number(word)));
}

/** The place of the attributes of a note; `find` has to have one. */
function readPlace(
  text: (name: string) => string | null,
  type: QuestionType,
  labels: readonly string[],
): NotePlace | null {
  const names = ['position', 'of', 'latitude', 'longitude'];
  if (type !== 'find' && names.every((name) => !text(name)?.trim())) return null;
  try {
    return readNotePlace((name) => (name === 'of' && labels.length > 0 ? labels[0] : text(name)));
  } catch (error) {
    const { message } = error as VolumeViewError;
    throw new VolumeViewError('attribute/invalid', message.replaceAll('<volume-note>', '<volume-question>'));
  }
}

/** @param above - the number is larger than this, or 0 and more where it is negative */
function readLength(name: string, text: string | null, above: number): number {
  const value = text && isNumber(text) ? Number(text) : NaN;
  if (!(value > above && value >= 0))
    throw invalidAttribute(name + owner, text ?? '', `a number ${above < 0 ? 'from 0' : 'above 0, in world units'}`);
  return value;
}

function readAnswers(type: QuestionType, text: string | null): string[] {
  if (type !== 'label' && type !== 'value') return [];
  const answers =
    type === 'label'
      ? (text ?? '')
          .split(',')
          .map((one) => one.trim())
          .filter((one) => foldText(one) !== '')
      : [text ?? ''];
  if (type === 'value' ? isNumber(answers[0]) : answers.length > 0) return answers;
  throw invalidAttribute(
    `answer${owner}`,
    text ?? '',
    type === 'value' ? 'the right value, like "45"' : 'the right names, separated by commas',
  );
}

function readTries(text: string | null): number {
  if (text === null) return Infinity;
  const tries = isNumber(text) ? Number(text) : NaN;
  if (!(Number.isInteger(tries) && tries >= 1)) throw invalidAttribute(`tries${owner}`, text, 'a whole number from 1');
  return tries;
}

/** Whether a response is right. @param place - of the question, as `position` has it; null where it is not known */
export function isRight(question: Question, response: Response, place: Vector3 | null): boolean {
  const { type, choices, labels, radius, answers, tolerance } = question;
  if ('chosen' in response) return choices.every(({ isCorrect }, i) => isCorrect === response.chosen.includes(i));
  if ('position' in response) {
    if (labels.length > 0) return response.label !== undefined && labels.includes(response.label);
    return place !== null && Math.hypot(...place.map((x, i) => x - response.position[i])) <= radius;
  }
  if (type === 'label') return answers.some((one) => foldText(one) === foldText(response.text));
  // A tolerance of 0.1 includes 0.3 of 0.2: what rounding adds does not count.
  const slack = 1e-9 * Math.max(Math.abs(Number(answers[0])), tolerance);
  return readNumbers(response.text).some((value) => Math.abs(value - Number(answers[0])) <= tolerance + slack);
}

/** Whether several answers of a list are right: then a reader chooses all of them. */
export function takesSeveral({ choices }: Question): boolean {
  return choices.filter(({ isCorrect }) => isCorrect).length > 1;
}

/** A text without differences of case, accents, blanks and hyphens. Marks that make another letter, as in Japanese, stay. */
export function foldText(text: string): string {
  return text
    .slice(0, maxText)
    .normalize('NFKD')
    .replace(/[\u0300-\u036f\u064b-\u065f]/g, '')
    .toLowerCase()
    .replace(/[\s\-‐-―_.]+/g, ' ')
    .trim()
    .normalize('NFC');
}

/**
 * What a number means as people write it: also with a decimal comma, other digits, and a unit after it. Empty for no number. "1,000" and "1.000" have two
 * meanings, as one language divides thousands by what another one writes before the decimals.
 */
export function readNumbers(text: string): number[] {
  const plain = text
    .slice(0, maxText)
    .replace(/[٠-٩]/g, (digit) => String(digit.charCodeAt(0) - 0x660))
    .replace(/[۰-۹]/g, (digit) => String(digit.charCodeAt(0) - 0x6f0))
    .normalize('NFKC')
    .replace(/[−–]/g, '-')
    .trim();
  const grouped = /^[+-]?[1-9]\d{0,2}(?:([,.٬'’\s])\d{3}(?:\1\d{3})*)(?!\d)/.exec(plain);
  const whole = grouped && plain.slice(0, grouped[0].length).replace(/[^\d+-]/g, '') + plain.slice(grouped[0].length);
  return [plain, whole].flatMap((one) => readPlain(one?.replace(/[,٫]/g, '.') ?? ''));
}

function readPlain(text: string): number[] {
  const [, number, rest] = /^([+-]?(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?)(.*)$/i.exec(text) ?? [];
  if (number === undefined || /(^|\s)[+-]?[.\d]/.test(rest)) return [];
  return Number.isFinite(Number(number)) ? [Number(number)] : [];
}
