import { VolumeViewError } from '../../core/errors.ts';
import { parseCssColor } from '../transfer/css-color.ts';
import { maxWord, parseOpacity, parseValue, splitOutsideBrackets } from '../transfer/parse-transfer-function.ts';
import type { IsoSurface, Shading, SurfaceStyle } from '../rays/ray-style.ts';
import { maxSurfaces } from '../transfer/surface-limits.ts';

/** Longest text: the largest number of surfaces, each with words of the largest length. */
const maxLength = 4 * maxSurfaces * maxWord;

/**
 * Reads the surfaces of a volume: `value colour opacity, ...`, for instance `40 #f80 60%, 300 white`. The grammar is that of a transfer
 * function's stops. The opacity may be left out; then it is 1.
 * @param window - the data values of 0 % and 100 %
 * @returns ascending; an empty list if the text is blank
 * @throws {VolumeViewError} `attribute/invalid`: the message names the surface
 */
export function parseSurfaces(text: string, window: readonly [number, number]): IsoSurface[] {
  if (text.trim() === '') return [];
  if (text.length > maxLength)
    throw invalid(
      `got ${text.length.toLocaleString('en')} characters; expected at most ${maxLength.toLocaleString('en')}`,
    );
  const parts = splitOutsideBrackets(text, ',');
  if (parts.length > maxSurfaces) throw invalid(`got ${parts.length} surfaces; expected at most ${maxSurfaces}`);
  const surfaces = parts.map((part, i) => parseSurface(part, i + 1, window));
  surfaces.sort((a, b) => a.value - b.value);
  return surfaces;
}

/** Other attributes that surfaces depend on; null if the author does not set them. */
interface Said {
  /** Without one, only the surfaces are drawn, without emission and absorption. */
  readonly transferFunction: string | null;
  readonly shading: Shading | null;
}

/**
 * How rays are drawn with surfaces. They are lit unless the author sets `unlit`.
 * @throws {VolumeViewError} as `parseSurfaces`
 */
export function readSurfaces(
  text: string,
  window: readonly [number, number],
  { transferFunction, shading }: Said,
): SurfaceStyle | null {
  const surfaces = parseSurfaces(text, window);
  return surfaces.length > 0
    ? { surfaces, ...(transferFunction === null && { clear: true }), ...(shading === 'unlit' && { plain: true }) }
    : null;
}

function parseSurface(part: string, number: number, window: readonly [number, number]): IsoSurface {
  const words = splitOutsideBrackets(part.trim(), ' ').filter((word) => word !== '');
  const where = `surface ${number}, "${part.trim().slice(0, 60)}",`;
  if (words.length < 2 || words.length > 3) {
    throw invalid(
      `${where} got ${words.length === 0 ? 'nothing' : `${words.length} part${words.length > 1 ? 's' : ''}`}; expected a value, a colour and perhaps an opacity, like "300 white 60%"`,
    );
  }
  const tooLong = words.find((word) => word.length > maxWord);
  if (tooLong)
    throw invalid(
      `${where} got "${tooLong.slice(0, 60)}…" of ${tooLong.length.toLocaleString('en')} characters; expected at most ${maxWord}`,
    );
  const [valueWord, colorWord, opacityWord = '1'] = words;
  const value = parseValue(valueWord, window);
  const opacity = parseOpacity(opacityWord);
  const parsed = parseCssColor(colorWord);
  if (value === null)
    throw invalid(
      `${where} got the value "${valueWord}"; expected a number in data units or a percentage of the window`,
    );
  if (!parsed)
    throw invalid(`${where} got the colour "${colorWord}"; expected a CSS colour, like orange, #f80 or rgb(255 136 0)`);
  if (opacity === null) throw invalid(`${where} got the opacity "${opacityWord}"; expected 0 to 1, or 0% to 100%`);
  return { value, color: parsed.color, opacity: opacity * parsed.alpha };
}

function invalid(what: string): VolumeViewError {
  return new VolumeViewError('attribute/invalid', `surface-values: ${what}.`);
}
