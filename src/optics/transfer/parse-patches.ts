import { VolumeViewError } from '../../core/errors.ts';
import { parseCssColor } from './css-color.ts';
import { maxWord, parseOpacity, parseValue, splitOutsideBrackets } from './parse-transfer-function.ts';
import { maxPatches } from './patches.ts';
import type { Patch, PatchAppearance } from './patches.ts';

/** Longest text: the largest number of patches, each with words of the largest length. */
const maxLength = 8 * maxPatches * maxWord;

/** What 100 % is: for values the window, and for gradients the one that covers the window within a reference length. */
export interface PatchUnits {
  readonly window: readonly [number, number];
  readonly steepest: number;
}

/**
 * Reads a transfer function of value and gradient: `box low high low high colour opacity`, values before gradients, and
 * `gaussian value gradient width width colour opacity`, separated by commas.
 *
 * Values are data units or percentages of the window. Gradients are data units per world unit, or percentages of the window along a
 * reference length.
 * @returns an empty list if the text is blank
 * @throws {VolumeViewError} `transfer-function/syntax`: the message names the patch
 */
export function parsePatches(text: string, units: PatchUnits): readonly Patch[] {
  if (text.trim() === '') return [];
  if (text.length > maxLength)
    throw syntax(
      `got ${text.length.toLocaleString('en')} characters; expected at most ${maxLength.toLocaleString('en')}`,
    );
  const parts = splitOutsideBrackets(text, ',');
  if (parts.length > maxPatches)
    throw syntax(`got ${parts.length} boxes and Gaussians; expected at most ${maxPatches}`);
  return parts.map((part, i) => parsePatch(part, i + 1, units));
}

function parsePatch(part: string, number: number, units: PatchUnits): Patch {
  const words = splitOutsideBrackets(part.trim(), ' ').filter((word) => word !== '');
  const where = `part ${number}, "${part.trim().slice(0, 60)}",`;
  const tooLong = words.find((word) => word.length > maxWord);
  if (tooLong)
    throw syntax(
      `${where} got "${tooLong.slice(0, 60)}…" of ${tooLong.length.toLocaleString('en')} characters; expected at most ${maxWord}`,
    );
  const kind = words[0]?.toLowerCase();
  if (kind !== 'box' && kind !== 'gaussian') {
    throw syntax(
      `${where} got ${words.length === 0 ? 'nothing' : `"${words[0]}"`}; expected a box, like "box 40 120 5 30 orange 60%", or a Gaussian, like "gaussian 200 20 15 8 white 80%"`,
    );
  }
  if (words.length < 7)
    throw syntax(
      `${where} got ${words.length - 1} part${words.length === 2 ? '' : 's'} after "${kind}"; expected ${expected[kind]}, a colour and an opacity`,
    );
  const numbers = words.slice(1, 5);
  const appearance = parseLook(words.slice(5), where);
  return kind === 'box'
    ? parseBox(numbers, appearance, { where, units })
    : parseGaussian(numbers, appearance, { where, units });
}

const expected = {
  box: 'the lowest and the highest value, the lowest and the highest gradient',
  gaussian: 'a value, a gradient, the width in values and the width in gradients',
} as const;

/** The patch that is being read, for messages, and its units. */
interface Place {
  readonly where: string;
  readonly units: PatchUnits;
}

function parseBox(
  words: readonly string[],
  appearance: PatchAppearance,
  { where, units: { window, steepest } }: Place,
): Patch {
  const [low, high] = words.slice(0, 2).map((word) => readNumber(word, 'value', where, window));
  const [min, max] = words.slice(2).map((word) => readNumber(word, 'gradient', where, [0, steepest]));
  if (!(low < high)) throw syntax(`${where} got values from ${words[0]} to ${words[1]}; expected the lower one first`);
  if (!(min < max))
    throw syntax(`${where} got gradients from ${words[2]} to ${words[3]}; expected the lower one first`);
  if (min < 0) throw syntax(`${where} got the gradient ${words[2]}; expected 0 or more`);
  return { kind: 'box', values: [low, high], gradients: [min, max], ...appearance };
}

function parseGaussian(
  words: readonly string[],
  appearance: PatchAppearance,
  { where, units: { window, steepest } }: Place,
): Patch {
  const value = readNumber(words[0], 'value', where, window);
  const gradient = readNumber(words[1], 'gradient', where, [0, steepest]);
  const widths = [
    readNumber(words[2], 'width', where, [0, window[1] - window[0]]),
    readNumber(words[3], 'width', where, [0, steepest]),
  ] as const;
  if (gradient < 0) throw syntax(`${where} got the gradient ${words[1]}; expected 0 or more`);
  const narrow = widths.findIndex((width) => !(width > 0));
  if (narrow >= 0) throw syntax(`${where} got the width ${words[2 + narrow]}; expected more than 0`);
  return { kind: 'gaussian', value, gradient, widths, ...appearance };
}

function readNumber(word: string, name: string, where: string, percents: readonly [number, number]): number {
  const number = parseValue(word, percents);
  if (number === null) throw syntax(`${where} got the ${name} "${word}"; expected a number or a percentage`);
  return number;
}

function parseLook(words: readonly string[], where: string): PatchAppearance {
  const opacity = parseOpacity(words[words.length - 1]);
  const colorText = words.slice(0, -1).join(' ');
  const parsed = colorText.length > maxWord ? null : parseCssColor(colorText);
  if (opacity === null)
    throw syntax(`${where} got the opacity "${words[words.length - 1]}"; expected 0 to 1, or 0% to 100%`);
  if (!parsed)
    throw syntax(
      `${where} got the colour "${colorText.slice(0, 60)}"; expected a CSS colour, like orange, #f80 or rgb(255 136 0)`,
    );
  return { color: parsed.color, opacity: opacity * parsed.alpha };
}

function syntax(what: string): VolumeViewError {
  return new VolumeViewError('transfer-function/syntax', `transfer-function-2d: ${what}.`);
}
