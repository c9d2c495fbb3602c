// Real world values: what stored numbers stand for, where a file has no rescale. Source: PS3.3, C.7.6.16.2.11
import type { Picture } from './picture.ts';
import { sequences, tags } from './tags.ts';

/** Value = slope * stored number + intercept. */
export interface RealWorld {
  readonly slope: number;
  readonly intercept: number;
  /** '' for one that is not known here. */
  readonly unit: string;
}

/** Units by their codes. A code may be any text, so others are not shown. Source: PS3.16, CID 7181 */
const units: Readonly<Record<string, string>> = { "[hnsf'U]": 'HU', 'Bq/ml': 'Bq/ml', '{SUVbw}g/ml': 'SUV' };

/**
 * @param index - of the frame, from 0
 * @returns null where the file says no such values, or several: then each is for other numbers, or another quantity
 */
export function findRealWorld({ set, type }: Picture, index: number): RealWorld | null {
  if (type.startsWith('float')) return null;
  const groups = [set.items(sequences.frameGroups).at(index), set.items(sequences.sharedGroups).at(0), set];
  const mappings = groups.map((group) => group?.items(sequences.realWorld) ?? []).find(({ length }) => length > 0);
  if (mappings?.length !== 1) return null;
  const [mapping] = mappings;
  const [slope, intercept] = [mapping.number(tags.realWorldSlope), mapping.number(tags.realWorldIntercept)];
  if (!slope || intercept === undefined) return null;
  const code = mapping.items(sequences.realWorldUnits).at(0)?.text(tags.codeValue) ?? '';
  return { slope, intercept, unit: units[code] ?? '' };
}
