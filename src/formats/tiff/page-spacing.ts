import type { Vector3 } from '../../volume/matrix.ts';
import { millimetresOf } from '../base/length-units.ts';
import { tags } from './tiff-file.ts';
import type { Directory, TiffFile } from './tiff-file.ts';

/** What a description says of lengths. */
interface Lengths {
  /** Of all of them. */
  readonly unit: string;
  /** Of slices; NaN where it is not said. */
  readonly distance: number;
}

/**
 * Pixels are as wide as the tags of resolution say, in the unit of the description; slices as far apart as it says. Lengths
 * in a unit that is none of length, such as pixels, stay as they are: so the shape of voxels is right.
 * @returns null where the file does not say lengths
 */
export function readSpacing(file: TiffFile, first: Directory, { unit, distance }: Lengths): Vector3 | null {
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
  const [x, y] = [length(tags.xResolution), length(tags.yResolution)];
  const z = Math.abs(distance);
  if (![x, y].every(isLength)) return null;
  const millimetres = known ?? 1;
  return [x * millimetres, y * millimetres, (isLength(z) ? z : x) * millimetres];
}

const isLength = (value: number): boolean => value > 0 && Number.isFinite(value);
