import { VolumeViewError } from '../../core/errors.ts';
import { maxWord, parseOpacity, parseValue, splitOutsideBrackets } from './parse-transfer-function.ts';
import type { GradientStop } from './volume-styles.ts';

/** Far more stops than a person writes. */
const maxStops = 64;

/** Longest text: the largest number of stops, each with words of the largest length. */
const maxLength = 2 * maxStops * maxWord;

/**
 * Reads factors of the opacity by gradient: `gradient factor, ...`, for instance `0 0, 10% 1`.
 *
 * A gradient is a number in data units per world unit, or a percentage of the window along a reference length. Gradients must not fall. A
 * factor is 0 to 1, or a percentage.
 * @param steepest - the gradient of 100 %, in data units per world unit
 * @returns an empty list if the text is blank
 * @throws {VolumeViewError} `attribute/invalid`: the message names the stop
 */
export function parseGradientOpacity(text: string, steepest: number): readonly GradientStop[] {
  if (text.trim() === '') return [];
  if (text.length > maxLength)
    throw invalid(
      `got ${text.length.toLocaleString('en')} characters; expected at most ${maxLength.toLocaleString('en')}`,
    );
  const parts = splitOutsideBrackets(text, ',');
  if (parts.length > maxStops) throw invalid(`got ${parts.length} stops; expected at most ${maxStops}`);
  const stops = parts.map((part, i) => parseStop(part, i + 1, steepest));
  for (let i = 1; i < stops.length; i++) {
    if (stops[i][0] < stops[i - 1][0])
      throw invalid(`stop ${i + 1} got a gradient below that of the stop before it; expected gradients that rise`);
  }
  return stops;
}

function parseStop(part: string, number: number, steepest: number): GradientStop {
  const words = splitOutsideBrackets(part.trim(), ' ').filter((word) => word !== '');
  const where = `stop ${number}, "${part.trim().slice(0, 60)}",`;
  if (words.length !== 2) {
    throw invalid(
      `${where} got ${words.length === 0 ? 'nothing' : `${words.length} part${words.length > 1 ? 's' : ''}`}; expected a gradient and a factor, like "10% 1"`,
    );
  }
  const tooLong = words.find((word) => word.length > maxWord);
  if (tooLong)
    throw invalid(
      `${where} got "${tooLong.slice(0, 60)}…" of ${tooLong.length.toLocaleString('en')} characters; expected at most ${maxWord}`,
    );
  const steepness = parseValue(words[0], [0, steepest]);
  const factor = parseOpacity(words[1]);
  if (steepness === null || steepness < 0) {
    throw invalid(
      `${where} got the gradient "${words[0]}"; expected a number from 0 on, in data units per world unit, or a percentage of the window along a reference length`,
    );
  }
  if (factor === null) throw invalid(`${where} got the factor "${words[1]}"; expected 0 to 1, or 0% to 100%`);
  return [steepness, factor];
}

function invalid(what: string): VolumeViewError {
  return new VolumeViewError('attribute/invalid', `gradient-opacity: ${what}.`);
}
