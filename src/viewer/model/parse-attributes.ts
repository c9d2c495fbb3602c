import { invalidAttribute as invalid } from '../../core/errors.ts';
import type { ScanTarget } from '../../formats/base/choose-scan.ts';
import { largestValue } from '../../optics/transfer/transfer-function.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import { longest } from '../../volume/grid-limits.ts';

export { invalid };

/** A length on an orbit: world units, or a part of the distance at which the volume just fits. */
export type Radius = { readonly world: number } | { readonly fraction: number };

/** The values of `camera-orbit`; undefined where it has `auto`. */
export interface OrbitAttribute {
  readonly theta?: number;
  readonly phi?: number;
  readonly radius?: Radius;
}

/** Each character can match in only one way: other forms of this expression take a time that grows with the square of the text length. */
const number = String.raw`[+-]?(?:\d+(?:\.\d*)?|\.\d+)(?:e[+-]?\d+)?`;
const isDecimal = new RegExp(`^${number}$`, 'i');

/** Maximum length of a list of numbers, in characters. */
const maxLength = 2 ** 16;

/** Whether a word is a number as an author may write it, and a finite one. */
export const isNumber = (word: string): boolean => isDecimal.test(word) && Number.isFinite(Number(word));

/** Examples of lists of numbers as an author may write them, by how many numbers they have. */
const numberExamples: Record<number, string> = { 1: '1.5', 2: '0 100', 3: '1 1 1.5', 6: '-50 -50 0 50 50 10' };

/** Exactly `count` numbers, separated by blanks or commas. */
export function parseNumbers(name: string, text: string, count: number): number[] {
  const words = split(name, text);
  if (words.length !== count || !words.every(isNumber)) {
    throw invalid(name, text, `${count} numbers, like "${numberExamples[count]}"`);
  }
  return words.map(Number);
}

/** One of a few words. */
export function parseWord<const Word extends string>(name: string, text: string, words: readonly Word[]): Word {
  const word = words.find((one) => one === text.trim().toLowerCase());
  if (word === undefined) throw invalid(name, text, words.join(' or '));
  return word;
}

/** Values of black and white; or the name, or the number, of a window of the file, as it is written. */
export type WindowSetting = readonly [low: number, high: number] | string;

/** `low high`, the lower value first, or else which window of the file. */
export function parseWindow(text: string): WindowSetting {
  if (/^\s*([a-z]|\d+\s*$)/i.test(text)) return text;
  const [low, high] = parseNumbers('value-window', text, 2);
  if (!(low < high && Math.max(-low, high) < largestValue))
    throw invalid('value-window', text, 'the lower value first, both nearer to 0 than 1e300, like "-150 250"');
  return [low, high];
}

/** `auto` or a number of steps. */
export function parseSteps(text: string, max: number): number | 'auto' {
  if (text.trim().toLowerCase() === 'auto' || text.trim() === '') return 'auto';
  const steps = isNumber(text.trim()) ? Math.round(Number(text)) : NaN;
  if (!(steps >= 1 && steps <= max)) throw invalid('steps', text, `auto, or a number from 1 to ${max}`);
  return steps;
}

/** A number that is not negative. */
export function parseFactor(name: string, text: string): number {
  const value = isNumber(text.trim()) ? Number(text) : NaN;
  if (!(value >= 0 && value < 1e30)) throw invalid(name, text, 'a number from 0');
  return value;
}

/** A number above zero. */
export function parseLength(name: string, text: string): number {
  const value = parseFactor(name, text);
  if (!(value > 1e-30)) throw invalid(name, text, 'a number above zero');
  return value;
}

/** `theta phi radius`, each possibly `auto`. @param name - of the attribute; the parts of a limit may be `Infinity` too */
export function parseOrbit(text: string, name = 'camera-orbit'): OrbitAttribute {
  const words = split(name, text);
  if (words.length !== 3) throw invalid(name, text, 'three parts, like "30deg 70deg 110%"');
  const isLimit = name !== 'camera-orbit';
  // For an angle, `Infinity` means the same as `auto`: no limit.
  const [theta, phi, radius] = words.map((word, i) =>
    /^auto$/i.test(word) || (isLimit && i < 2 && /^[+-]?infinity$/i.test(word)) ? undefined : word,
  );
  return {
    theta: theta === undefined ? undefined : angleOr(name, text, theta),
    phi: phi === undefined ? undefined : angleOr(name, text, phi),
    radius:
      radius === undefined
        ? undefined
        : isLimit && /^\+?infinity$/i.test(radius)
          ? { world: longest }
          : parseRadius(name, text, radius),
  };
}

/** The smallest and the largest orbit; an absent text sets no limit. */
export function parseLimits(
  smallest: string | null,
  greatest: string | null,
): { min: OrbitAttribute; max: OrbitAttribute } {
  const [min, max] = [
    [smallest, 'min-camera-orbit'],
    [greatest, 'max-camera-orbit'],
  ].map(([text, name]) => (text?.trim() ? parseOrbit(text, name!) : {}));
  const isBelow = (a: number | undefined, b: number | undefined): boolean =>
    a !== undefined && b !== undefined && a < b;
  const [low, high] = [min, max].map(({ radius }) => ({ world: undefined, fraction: undefined, ...radius }));
  if (
    isBelow(max.theta, min.theta) ||
    isBelow(max.phi, min.phi) ||
    isBelow(high.world, low.world) ||
    isBelow(high.fraction, low.fraction)
  ) {
    throw invalid('max-camera-orbit', greatest!, `no part below that of min-camera-orbit, "${smallest!.slice(0, 60)}"`);
  }
  return { min, max };
}

/** A vertical angle of view, radians; undefined for `auto`. */
export function parseFieldOfView(text: string): number | undefined {
  if (text.trim().toLowerCase() === 'auto' || text.trim() === '') return undefined;
  const angle = angleOr('field-of-view', text, text.trim());
  if (!(angle > 0 && angle < Math.PI)) throw invalid('field-of-view', text, 'an angle between 0deg and 180deg');
  return angle;
}

/** World coordinates; undefined for `auto`, the volume's centre. */
export function parseTarget(text: string): Vector3 | undefined {
  if (text.trim() === '' || split('camera-target', text).every((word) => word.toLowerCase() === 'auto'))
    return undefined;
  const target = parseNumbers('camera-target', text, 3) as unknown as Vector3;
  if (Math.max(...target.map(Math.abs)) > longest) throw invalid('camera-target', text, 'a place nearer than 1e12');
  return target;
}

/** Two opposite corners of a box, in world units. */
export function parseRegion(text: string): number[] | null {
  return text.trim() === '' ? null : parseNumbers('region', text, 6);
}

/** Kilometres from ring to ring, `auto` for round distances, or no rings. */
export type RingSetting = number | 'auto' | 'none';

/** Kilometres from ring to ring, `none`, or an empty text for round distances. */
export function parseRings(text: string): RingSetting {
  const word = text.trim().toLowerCase();
  return word === '' ? 'auto' : word === 'none' ? word : parseLength('rings', text);
}

/** The number of a scan, an ISO 8601 time with its zone, or a number with its unit, '12.5 s'. */
export function parseTime(text: string): ScanTarget {
  const word = text.trim();
  if (/^\d{1,9}$/.test(word)) return { index: Number(word) };
  if (/^[\d.]+ ?[a-z]+$/i.test(word)) return { time: word };
  const time = /^\d{4}-\d\d-\d\dT\d\d:\d\d(:\d\d(\.\d+)?)?(Z|[+-]\d\d:\d\d)$/i.test(word) ? Date.parse(word) : NaN;
  if (Number.isNaN(time))
    throw invalid('time', text, 'a scan\'s number from 0, or a time in UTC, like "2018-12-20T06:06:28Z"');
  return { time };
}

function angleOr(name: string, text: string, word: string): number {
  const match = new RegExp(`^(${number})(deg|rad)?$`, 'i').exec(word);
  if (!match || !isNumber(match[1])) throw invalid(name, text, 'angles in deg or rad, like "30deg"');
  return match[2]?.toLowerCase() === 'rad' ? Number(match[1]) : (Number(match[1]) * Math.PI) / 180;
}

function parseRadius(name: string, text: string, word: string): Radius {
  const match = new RegExp(`^(${number})(%)?$`, 'i').exec(word);
  const value = Number(match?.[1]);
  if (!(value > 1 / longest && value < longest))
    throw invalid(name, text, 'a radius in world units or per cent, like "110%"');
  return match![2] ? { fraction: value / 100 } : { world: value };
}

/** The words of a text, separated by blanks or commas. */
export function split(name: string, text: string): string[] {
  if (text.length > maxLength) throw invalid(name, text, `at most ${maxLength} characters`);
  return text
    .trim()
    .split(/[\s,]+/)
    .filter((word) => word !== '');
}
