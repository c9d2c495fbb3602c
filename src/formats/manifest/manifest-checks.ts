import { invertAffine } from '../../volume/matrix.ts';
import type { Matrix4, Vector3 } from '../../volume/matrix.ts';
import { parseMosaicSize } from '../../volume/mosaic-size.ts';
import type { ChannelUse } from '../base/channels.ts';

// Checks for the fields of a manifest.

/** Checks one field's value and converts it to the form that is used; throws what was expected. */
export type Check<T> = (value: unknown) => T;

/** The message says what a field should have been. */
export class Expected extends Error {}

export const isFinite = (value: unknown): value is number => typeof value === 'number' && Number.isFinite(value);

/** Maximum length of a text that a page shows, and of a list; longer than any of them needs. */
export const maxText = 10_000;
export const maxList = 100_000;

export const text: Check<string> = (value) => {
  if (typeof value !== 'string' || value.length > maxText)
    throw new Expected(`a text of at most ${maxText.toLocaleString('en')} characters`);
  return value;
};

/** A name or a unit. */
export const shortText: Check<string> = (value) => {
  if (typeof value !== 'string' || value.length > 200) throw new Expected('a text of at most 200 characters');
  return value;
};

export const filledShortText: Check<string> = (value) => {
  if (value === '') throw new Expected('a text that is not empty');
  return shortText(value);
};

/** URLs, which may hold data, and transfer functions, which have their own limits. */
export const filledText: Check<string> = (value) => {
  if (typeof value !== 'string' || value === '') throw new Expected('a text that is not empty');
  return value;
};

export const filledTexts: Check<readonly string[]> = (value) => {
  if (
    !Array.isArray(value) ||
    value.length === 0 ||
    value.length > maxList ||
    !value.every((one) => typeof one === 'string' && one !== '')
  ) {
    throw new Expected('a list of texts, none of them empty');
  }
  return value as string[];
};

export const mosaicText: Check<{ columns: number; rows: number }> = (value) => {
  const size = typeof value === 'string' ? parseMosaicSize(value) : null;
  if (!size) throw new Expected('"COLUMNSxROWS", such as "10x10"');
  return size;
};

export const count: Check<number> = (value) => {
  if (!Number.isSafeInteger(value) || (value as number) < 1) throw new Expected('a whole number from 1');
  return value as number;
};

export const finite: Check<number> = (value) => {
  if (!isFinite(value)) throw new Expected('a number');
  return value;
};

export const nonZero: Check<number> = (value) => {
  if (!isFinite(value) || value === 0) throw new Expected('a number other than 0');
  return value;
};

export const channelUse: Check<ChannelUse> = (value) => {
  if (value !== 'gray' && value !== 'high-low') throw new Expected('"gray" or "high-low"');
  return value;
};

export const nonZeroTriple: Check<Vector3> = (value) => {
  if (!Array.isArray(value) || value.length !== 3 || !value.every((n) => isFinite(n) && n !== 0)) {
    throw new Expected('three numbers other than 0');
  }
  return value as unknown as Vector3;
};

export const ascendingPair: Check<[number, number]> = (value) => {
  if (
    !Array.isArray(value) ||
    value.length !== 2 ||
    !value.every(isFinite) ||
    value[0] >= value[1] ||
    !isFinite(value[1] - value[0])
  ) {
    throw new Expected('two ascending numbers, [low, high]');
  }
  return value as [number, number];
};

export const affine: Check<Matrix4> = (value) => {
  const isList = Array.isArray(value) && (value.length === 12 || value.length === 16) && value.every(isFinite);
  if (!isList) throw new Expected('12 or 16 numbers, row by row');
  const [a, b, c, d] = value.length === 16 ? value.slice(12) : [0, 0, 0, 1];
  if (a !== 0 || b !== 0 || c !== 0 || d !== 1) throw new Expected('0, 0, 0, 1 as the last row');
  const matrix = [...value.slice(0, 12), 0, 0, 0, 1];
  if (!invertAffine(matrix)) throw new Expected('three axes that do not lie in one plane');
  return matrix;
};
