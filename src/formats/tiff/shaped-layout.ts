// Stacks of tifffile, which napari and scikit-image use: the shape of an array, as JSON. Source: tifffile 2026.3.3, TiffWriter.write and TiffFile._series_shaped
import { parseJson } from '../base/parse-json.ts';
import { nameRest } from './layout.ts';
import type { TiffLayout } from './layout.ts';
import { readSpacing } from './page-spacing.ts';
import { tags } from './tiff-file.ts';
import type { Directory, TiffFile } from './tiff-file.ts';

/** A longer description is none of a shape. */
const maxDescription = 2 ** 16;

/** The axes before those of a page, where they have no names, by their number. */
const usualAxes: readonly string[] = ['', 'Z', 'TZ', 'TCZ'];

interface Shape {
  readonly sizes: readonly number[];
  /** A letter for each size; '' where there are none. */
  readonly axes: string;
  readonly unit: string;
  readonly distance: number;
  /** Whether only the first page has a directory. */
  readonly isTruncated: boolean;
}

export const isShaped = (description: string): boolean =>
  description.length <= maxDescription && /^\{\s*"shape"\s*:/.test(description);

/**
 * The last two axes are those of a page; T are scans, C channels and Z slices.
 * @param all - the pages of the file
 * @returns null where the shape is not that of the pages, or has axes that are not known: then pages are slices
 */
export function layOutShaped(
  file: TiffFile,
  all: readonly Directory[],
  description: string,
): (TiffLayout & { readonly pages: number }) | null {
  const shape = readShape(description);
  const axes = shape && nameAxes(file, all[0], shape);
  if (!axes) return null;
  const pages = axes.reduce((product, { size }) => product * size, 1);
  // A page follows the one before, without a directory.
  const isPlain = (file.number(all[0], tags.compression) ?? 1) === 1 && !all[0].has(tags.tileOffsets);
  if (pages < 2 || !(pages === all.length || (shape.isTruncated && all.length === 1 && isPlain))) return null;
  const sizeOf = (name: string): number => axes.find((axis) => axis.name === name)?.size ?? 1;
  const [slices, times] = [sizeOf('Z'), sizeOf('T')];
  return {
    format: 'TIFF',
    pages,
    slices,
    times,
    pageOf: (slice, time) =>
      axes.reduce((page, { name, size }) => page * size + (name === 'Z' ? slice : name === 'T' ? time : 0), 0),
    spacing: shape.unit || shape.distance ? readSpacing(file, all[0], shape) : null,
    timeStep: null,
    left: [nameRest('channel', sizeOf('C'))].filter((one) => one !== null),
  };
}

function readShape(description: string): Shape | null {
  let json: Readonly<Record<string, unknown>>;
  try {
    json = parseJson(description) as Readonly<Record<string, unknown>>;
  } catch {
    return null;
  }
  const { shape, axes, unit, spacing, truncated } = json;
  if (!Array.isArray(shape) || !shape.every((size) => Number.isSafeInteger(size) && size >= 1)) return null;
  return {
    sizes: shape as readonly number[],
    axes: typeof axes === 'string' && axes.length === shape.length ? axes.toUpperCase() : '',
    unit: typeof unit === 'string' ? unit : '',
    distance: typeof spacing === 'number' ? spacing : NaN,
    isTruncated: truncated === true,
  };
}

/** The axes before those of a page, the slowest first; null where the last ones are not those of the page, or one is not known. */
function nameAxes(
  file: TiffFile,
  first: Directory,
  { sizes, axes }: Shape,
): readonly { readonly name: string; readonly size: number }[] | null {
  const [rows, columns, samples] = [tags.rows, tags.columns, tags.samples].map((tag) => file.number(first, tag) ?? 1);
  const isPlanar = file.number(first, tags.planar) === 2;
  // The numbers of a pixel may be an axis of their own, before or after those of the page.
  const ends =
    samples === 1
      ? [
          [rows, columns],
          [rows, columns, 1],
        ]
      : [isPlanar ? [samples, rows, columns] : [rows, columns, samples]];
  const end = ends.find((one) => one.every((size, i) => sizes.at(i - one.length) === size));
  if (!end) return null;
  const count = sizes.length - end.length;
  const names = axes === '' ? (usualAxes[count] ?? '') : axes;
  const list = Array.from({ length: count }, (_, i) => ({ name: names[i], size: sizes[i] })).filter(
    ({ size }) => size > 1,
  );
  const isKnown = list.every(
    ({ name }, i) => 'TCZ'.includes(name ?? '?') && list.findIndex((one) => one.name === name) === i,
  );
  return isKnown ? list : null;
}
