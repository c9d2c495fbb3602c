import { VolumeViewError } from '../../core/errors.ts';
import { parseCssColor } from './css-color.ts';
import { largestValue } from './transfer-function.ts';
import type { Stop, TransferFunction } from './transfer-function.ts';

/** Maximum number of stops: far more than a person or an editor writes. There is a limit because strangers may write attributes. */
const maxStops = 1024;

/** Longest text: the largest number of stops, each with a colour in the longest notation. */
const maxLength = 2 ** 17;

/** The largest length of a colour or a number. */
export const maxWord = 200;

/**
 * Reads the stops of a transfer function: `value colour opacity, ...`, for instance
 * `-600 #000 0, 150 rgb(200 90 60) 2%, 400 white 0.6`.
 *
 * A value is a number in data units, or a percentage of the window; a colour is any CSS colour (its own alpha
 * multiplies the opacity); an opacity is 0 to 1, or a percentage, per reference length. Values must not fall; two
 * stops with the same value make a jump.
 * @param window - the data values of 0 % and 100 %
 * @throws {VolumeViewError} `transfer-function/syntax`: the message names the stop
 */
export function parseTransferFunction(text: string, window: readonly [number, number]): TransferFunction {
  if (text.length > maxLength)
    throw syntax(
      `got ${text.length.toLocaleString('en')} characters; expected at most ${maxLength.toLocaleString('en')}`,
    );
  const parts = splitOutsideBrackets(text, ',');
  if (parts.length > maxStops) throw syntax(`got ${parts.length} stops; expected at most ${maxStops}`);
  const stops = parts.map((part, i) => parseStop(part, i + 1, window));
  for (let i = 1; i < stops.length; i++) {
    if (stops[i].value < stops[i - 1].value) {
      throw syntax(
        `stop ${i + 1} got the value ${stops[i].value}, which is below ${stops[i - 1].value} before it; expected values that rise`,
      );
    }
  }
  return stops;
}

function parseStop(part: string, number: number, window: readonly [number, number]): Stop {
  const words = splitOutsideBrackets(part.trim(), ' ').filter((word) => word !== '');
  const where = `stop ${number}, "${part.trim().slice(0, 60)}",`;
  if (words.length < 3) {
    throw syntax(
      `${where} got ${words.length === 0 ? 'nothing' : `${words.length} part${words.length > 1 ? 's' : ''}`}; expected a value, a colour and an opacity, like "150 orange 2%"`,
    );
  }
  const value = parseValue(words[0], window);
  const opacity = parseOpacity(words[words.length - 1]);
  const colorText = words.slice(1, -1).join(' ');
  const tooLong = words.find((word) => word.length > maxWord) ?? (colorText.length > maxWord ? colorText : undefined);
  if (tooLong)
    throw syntax(
      `${where} got "${tooLong.slice(0, 60)}…" of ${tooLong.length.toLocaleString('en')} characters; expected at most ${maxWord}`,
    );
  const parsed = parseCssColor(colorText);
  if (value === null)
    throw syntax(`${where} got the value "${words[0]}"; expected a number in data units or a percentage of the window`);
  if (opacity === null)
    throw syntax(`${where} got the opacity "${words[words.length - 1]}"; expected 0 to 1, or 0% to 100%`);
  if (!parsed)
    throw syntax(`${where} got the colour "${colorText}"; expected a CSS colour, like orange, #f80 or rgb(255 136 0)`);
  return { value, color: parsed.color, opacity: opacity * parsed.alpha };
}

/**
 * A plain decimal number, possibly with an exponent. Number() also accepts hex, blanks and Infinity; this does not. Each character can
 * match in only one way, or long texts would take very long.
 */
const decimal = /^[+-]?(\d+(\.\d*)?|\.\d+)(e[+-]?\d+)?$/i;

/** @returns null if the word is no number, in data units or percent of a window */
export function parseValue(word: string, [low, high]: readonly [number, number]): number | null {
  const percent = word.endsWith('%');
  const digits = percent ? word.slice(0, -1) : word;
  if (!decimal.test(digits)) return null;
  const number = Number(digits);
  if (!Number.isFinite(number)) return null;
  const value = percent ? low + ((high - low) * number) / 100 : number;
  return Math.abs(value) < largestValue ? value : null;
}

/** @returns null if the word is not 0 to 1, or 0% to 100% */
export function parseOpacity(word: string): number | null {
  const percent = word.endsWith('%');
  const digits = percent ? word.slice(0, -1) : word;
  if (!decimal.test(digits)) return null;
  const opacity = Number(digits) / (percent ? 100 : 1);
  return opacity >= 0 && opacity <= 1 ? opacity : null;
}

/** Splits at a separator outside of round brackets; a blank stands for any white space. */
export function splitOutsideBrackets(text: string, separator: ',' | ' '): string[] {
  const parts: string[] = [];
  let depth = 0;
  let part = '';
  for (const character of text) {
    if (character === '(') depth++;
    if (character === ')') depth--;
    const separates = separator === ',' ? character === ',' : /\s/.test(character);
    if (separates && depth <= 0) {
      parts.push(part);
      part = '';
    } else {
      part += character;
    }
  }
  return [...parts, part];
}

function syntax(what: string): VolumeViewError {
  return new VolumeViewError('transfer-function/syntax', `transfer-function: ${what}.`);
}
