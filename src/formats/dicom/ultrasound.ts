// How large the pixels of an ultrasound picture are, which it says of parts of the picture. Source: DICOM PS3.3, C.8.5.5
import type { DataSet } from './data-set.ts';
import type { Picture } from './picture.ts';
import { sequences, tags } from './tags.ts';
import type { Tag } from './tags.ts';

/** Two parts have one scale where it differs by less than this share. */
const sameScale = 1e-3;

/** Parts in two dimensions, and centimetres. */
const [flat, centimetres] = [1, 3];

/**
 * @returns mm from column to column and from row to row; null where the parts differ, or lie outside the picture: then it was made
 * larger or smaller, and what is said of them is of another one
 */
export function readRegionSpacing({ set, columns, rows }: Picture): readonly [number, number] | null {
  const regions = set.items(sequences.regions);
  const isInside = (region: DataSet): boolean =>
    (region.number(tags.regionRight) ?? 0) <= columns && (region.number(tags.regionBottom) ?? 0) <= rows;
  if (!regions.every(isInside)) return null;
  const spacings = regions
    .filter(
      (region) =>
        region.number(tags.regionFormat) === flat &&
        [tags.regionUnitX, tags.regionUnitY].every((tag) => region.number(tag) === centimetres),
    )
    .map((region) => [toMillimetres(region, tags.regionDeltaX), toMillimetres(region, tags.regionDeltaY)] as const);
  if (spacings.length === 0) return null;
  const [first] = spacings;
  const areAlike = spacings.every(([x, y]) => isNear(x, first[0]) && isNear(y, first[1]));
  return areAlike && first[0] > 0 && first[1] > 0 ? first : null;
}

const toMillimetres = (region: DataSet, tag: Tag): number => 10 * Math.abs(region.number(tag) ?? NaN);

const isNear = (a: number, b: number): boolean => Math.abs(a - b) <= sameScale * b;
