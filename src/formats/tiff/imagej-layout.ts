// Stacks of ImageJ and Fiji. Source: ImageJ 1.54, ij/io/FileInfo and TiffEncoder: lines of "name=value" in ImageDescription
import { scaleImageJ } from './imagej-values.ts';
import { guessedDistance, nameRest } from './layout.ts';
import type { TiffLayout } from './layout.ts';
import { readSpacing, unitsPer } from './page-spacing.ts';
import type { Directory, TiffFile } from './tiff-file.ts';

export const isImageJ = (description: string): boolean => description.startsWith('ImageJ=');

/**
 * Channels come first, then slices, then times.
 * @param first - the first page
 * @returns null where the pages are not as many as the description says
 */
export function layOutImageJ(
  file: TiffFile,
  first: Directory,
  description: string,
): (TiffLayout & { readonly pages: number }) | null {
  const values = new Map(
    description
      .split('\n', 100)
      .map((line) => line.split('='))
      .map(([name, ...rest]) => [name.trim(), readText(rest.join('=').trim())]),
  );
  const count = (name: string): number => {
    const value = Number(values.get(name) ?? 1);
    return Number.isSafeInteger(value) && value >= 1 ? value : 1;
  };
  const [pages, channels, times] = [count('images'), count('channels'), count('frames')];
  const slices = values.has('slices') || channels * times > 1 ? count('slices') : pages;
  if (slices * channels * times !== pages) return null;
  // ImageJ does not write a distance of 1. Source: ImageJ 1.54, FileSaver, getDescriptionString
  const distance = Number(values.get('spacing') ?? (slices > 1 ? 1 : NaN));
  const unit = values.get('unit') ?? '';
  const zUnit = values.get('zunit');
  const isGuessed = slices > 1 && Number.isNaN(unitsPer(zUnit, unit));
  const number = (name: string): number => Number(values.get(name) ?? NaN);
  const [low, high] = [number('min'), number('max')];
  const { scale, left } = scaleImageJ(file, first, values);
  const { slope, intercept, shift } = scale ?? { slope: 1, intercept: 0, shift: 0 };
  // The window is one of numbers as ImageJ has them in memory.
  const window = [low, high].map((value) => slope * (value - shift) + intercept);
  return {
    format: 'ImageJ TIFF',
    pages,
    slices,
    times,
    pageOf: (slice, time) => (time * slices + slice) * channels,
    spacing: readSpacing(file, first, { unit, yUnit: values.get('yunit'), zUnit, distance }),
    timeStep:
      number('finterval') > 0 && /^(sec|s|seconds)?$/.test(values.get('tunit') ?? '') ? number('finterval') : null,
    left: [nameRest('channel', channels), isGuessed ? guessedDistance : null, left].filter((one) => one !== null),
    ...(scale && { scale }),
    ...(channels === 1 && high > low && Number.isFinite(window[1] - window[0])
      ? { window: [Math.min(...window), Math.max(...window)] as const }
      : {}),
  };
}

/** Signs beyond ASCII are written as Java's properties have them. */
const readText = (text: string): string =>
  text.replace(/\\u([\da-f]{4})/gi, (_, code: string) => String.fromCharCode(Number.parseInt(code, 16)));
