import type { Stop } from '../../src/optics/transfer/transfer-function.ts';
import { writeTransferFunction } from '../../src/optics/transfer/write-transfer-function.ts';
import type { Vector3 } from '../../src/volume/matrix.ts';

/**
 * How the values of a property are written in its attribute. Any value that a script sets becomes text, even an invalid one: then the
 * element reports the error, as it does for text in HTML.
 */
export interface Kind<T> {
  /** The value of a text; null where there is no text or it can't be read. @param text - null where the attribute is absent */
  read(text: string | null): T;
  /** @returns the text; null removes the attribute */
  write(value: T | string | null | undefined): string | null;
}

/** The text as JavaScript writes it. */
const write = (value: string | number | boolean | null | undefined): string | null =>
  value === null || value === undefined ? null : String(value);

const isNumber = (text: string): boolean => text.trim() !== '' && Number.isFinite(Number(text));

export const text: Kind<string | null> = { read: (text) => text, write };

/** A boolean: true where the attribute is present, whatever its text. */
export const flag: Kind<boolean> = { read: (text) => text !== null, write: (value) => (value ? '' : null) };

export const number: Kind<number | null> = {
  read: (text) => (text !== null && isNumber(text) ? Number(text) : null),
  write,
};

/** A number, or `auto` where the element chooses. */
export const numberOrAuto: Kind<number | 'auto' | null> = {
  read: (text) => (text?.trim().toLowerCase() === 'auto' ? 'auto' : number.read(text)),
  write,
};

/** A number, or else a text. */
export const numberOrText: Kind<number | string | null> = { read: (text) => number.read(text) ?? text, write };

/** A number; or an empty text, for a number that the element chooses; or `none`. */
export const numberOrFlag: Kind<number | boolean | 'none'> = {
  read: (text) =>
    text?.trim() === '' ? true : text?.trim().toLowerCase() === 'none' ? 'none' : (number.read(text) ?? false),
  write: (value) => (value === true ? '' : value === false ? null : write(value)),
};

/** Numbers, separated by blanks or commas. */
export const numbers: Kind<readonly number[] | null> = {
  read: (text) => {
    const words = text?.trim().split(/[\s,]+/);
    return words?.every(isNumber) ? words.map(Number) : null;
  },
  write: (value) => write(typeof value === 'object' ? value?.join(' ') : value),
};

/** Exactly `count` numbers. */
function exactly<Numbers extends readonly number[]>(count: number): Kind<Numbers | null> {
  const read = (text: string | null): Numbers | null => {
    const found = numbers.read(text);
    return found?.length === count ? (found as unknown as Numbers) : null;
  };
  return { read, write: numbers.write };
}

export const pair = exactly<readonly [number, number]>(2);
export const vector = exactly<Vector3>(3);

/** Two opposite corners of a box. */
export const box = exactly<readonly [x0: number, y0: number, z0: number, x1: number, y1: number, z1: number]>(6);

/** Two numbers, or else a text. */
export const pairOrText: Kind<readonly [number, number] | string | null> = {
  read: (text) => pair.read(text) ?? text,
  write: numbers.write,
};

/** Columns and rows, `10x10`. */
export const size: Kind<readonly [columns: number, rows: number] | null> = {
  read: (text) => {
    const [, columns, rows] = /^\s*(\d+)\s*x\s*(\d+)\s*$/i.exec(text ?? '') ?? [];
    return rows === undefined ? null : [Number(columns), Number(rows)];
  },
  write: (value) => write(typeof value === 'object' ? value?.join('x') : value),
};

/** The name of a preset, or stops: a text, or, for writing, a list too. */
export const transferFunction: Kind<string | readonly Stop[] | null> = {
  read: (text) => text,
  write: (value) => (value && typeof value === 'object' ? writeTransferFunction(value) : write(value)),
};
