import type { Vector3 } from '../../volume/matrix.ts';
import { millimetresOf } from '../base/length-units.ts';
import { tags } from './tiff-file.ts';
import type { Directory, TiffFile } from './tiff-file.ts';

/** What a description says of lengths. */
interface Lengths {
  /** Of all of them, except y and z where these have their own. */
  readonly unit: string;
  readonly yUnit?: string;
  readonly zUnit?: string;
  /** Of slices; NaN where it is not said. */
  readonly distance: number;
}

/**
 * Pixels are as wide as the tags of resolution say, in the unit of the description; slices as far apart as it says. Lengths
 * in a unit that is none of length, such as pixels, stay as they are: so the shape of voxels is right. Slices at distances that can't be compared
 * with those of pixels, such as seconds, are as far apart as these.
 * @returns null where the file does not say lengths
 */
export function readSpacing(
  file: TiffFile,
  first: Directory,
  { unit, yUnit, zUnit, distance }: Lengths,
): Vector3 | null {
  const known = millimetresOf(unit);
  const per = file.number(first, tags.resolutionUnit) ?? 1;
  // Without a unit, dots per inch or centimetre are those of a printer.
  if (known === undefined && per !== 1) return null;
  // Pixels may be given in centimetres together with slices in micrometres. Source: ImageJ 1.54, FileOpener, decodeDescriptionString
  const factor = per === 3 && unit === 'um' ? 1e4 : 1;
  const length = (tag: number): number => {
    // ImageJ leaves out what is 1.
    const [pixels, units] = first.has(tag) ? file.numbers(first, tag) : [1, 1];
    return (factor * units) / pixels;
  };
  const x = length(tags.xResolution);
  const y = length(tags.yResolution) * unitsPer(yUnit, unit);
  const z = Math.abs(distance) * unitsPer(zUnit, unit);
  if (![x, y].every(isLength)) return null;
  const millimetres = known ?? 1;
  return [x * millimetres, y * millimetres, (isLength(z) ? z : x) * millimetres];
}

/** How many of a unit are one of another, which may be missing; NaN where they can't be compared. */
export function unitsPer(other: string | undefined, unit: string): number {
  if (other === undefined || other === unit) return 1;
  return (millimetresOf(other) ?? NaN) / (millimetresOf(unit) ?? NaN);
}

const isLength = (value: number): boolean => value > 0 && Number.isFinite(value);
