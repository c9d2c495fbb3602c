// Stacks of ImageJ and Fiji. Source: ImageJ 1.54, ij/io/FileInfo and TiffEncoder: lines of "name=value" in ImageDescription
import type { Vector3 } from '../../volume/matrix.ts';
import { millimetresOf } from '../base/length-units.ts';
import { nameRest } from './layout.ts';
import type { TiffLayout } from './layout.ts';
import { tags } from './tiff-file.ts';
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
      .map(([name, ...rest]) => [name.trim(), rest.join('=').trim()]),
  );
  const count = (name: string): number => {
    const value = Number(values.get(name) ?? 1);
    return Number.isSafeInteger(value) && value >= 1 ? value : 1;
  };
  const [pages, channels, times] = [count('images'), count('channels'), count('frames')];
  const slices = values.has('slices') || channels * times > 1 ? count('slices') : pages;
  if (slices * channels * times !== pages) return null;
  const number = (name: string): number => Number(values.get(name) ?? NaN);
  const [low, high] = [number('min'), number('max')];
  return {
    format: 'ImageJ TIFF',
    pages,
    slices,
    times,
    pageOf: (slice, time) => (time * slices + slice) * channels,
    spacing: readSpacing(file, first, values),
    timeStep:
      number('finterval') > 0 && /^(sec|s|seconds)?$/.test(values.get('tunit') ?? '') ? number('finterval') : null,
    left: [nameRest('channel', channels)].filter((one) => one !== null),
    ...(channels === 1 && high > low && Number.isFinite(high - low) ? { window: [low, high] as const } : {}),
  };
}

/** Pixels are as wide as the tags of resolution say, in the unit of the description; slices as far apart as it says. */
function readSpacing(file: TiffFile, first: Directory, values: ReadonlyMap<string, string>): Vector3 | null {
  const text = (values.get('unit') ?? '').replace(/\\u([\da-f]{4})/gi, (_, code: string) =>
    String.fromCharCode(Number.parseInt(code, 16)),
  );
  const unit = millimetresOf(text);
  const length = (tag: number): number => {
    const [pixels, per] = file.numbers(first, tag);
    return per / pixels;
  };
  const [x, y] = [length(tags.xResolution), length(tags.yResolution)];
  const z = Math.abs(Number(values.get('spacing') ?? NaN));
  if (unit === undefined || ![x, y].every(isLength)) return null;
  return [x * unit, y * unit, (isLength(z) ? z : x) * unit];
}

const isLength = (value: number): boolean => value > 0 && Number.isFinite(value);
