import type { VolumeViewError } from '../../core/errors.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import { invalid, isNumber, split } from '../../viewer/model/parse-attributes.ts';

/**
 * The fields of an author's X3D node, by their names in the standard, whatever case HTML gives them. Its errors name
 * field and node.
 */
export class X3dFields {
  constructor(
    readonly element: Element,
    readonly node: string,
  ) {}

  /** Empty if absent. */
  text(field: string): string {
    return (this.element.getAttribute(field) ?? this.element.getAttribute(field.toLowerCase()) ?? '').trim();
  }

  flag(field: string, fallback: boolean): boolean {
    const word = this.text(field).toLowerCase();
    if (word === '') return fallback;
    if (word !== 'true' && word !== 'false') throw this.error(field, '"true" or "false"');
    return word === 'true';
  }

  /** One number, within the range. */
  number(field: string, fallback: number, [min, max]: readonly [number, number] = [0, 1e6]): number {
    const text = this.text(field);
    if (text === '') return fallback;
    const number = isNumber(text) ? Number(text) : NaN;
    if (!(number >= min && number <= max)) throw this.error(field, `a number from ${min} to ${Number(max.toFixed(4))}`);
    return number;
  }

  whole(field: string, fallback: number, range: readonly [number, number]): number {
    const number = this.number(field, fallback, range);
    if (!Number.isInteger(number)) throw this.error(field, `a whole number from ${range[0]} to ${range[1]}`);
    return number;
  }

  numbers(field: string): number[] {
    const words = split(field, this.text(field));
    if (!words.every(isNumber)) throw this.error(field, 'numbers, separated by blanks');
    return words.map(Number);
  }

  /** Shares of red, green and blue; a fourth number, which has no meaning in the standard, may follow. */
  color(field: string, fallback: Vector3): Vector3 {
    if (this.text(field) === '') return fallback;
    const words = split(field, this.text(field));
    const color = words.slice(0, 3).map((word) => (isNumber(word) ? Number(word) : NaN));
    if (words.length < 3 || words.length > 4 || !color.every((x) => x >= 0 && x <= 1))
      throw this.error(field, 'three numbers from 0 to 1, "red green blue"');
    return color as unknown as Vector3;
  }

  word<const Word extends string>(field: string, fallback: Word, words: readonly Word[]): Word {
    const text = this.text(field).toUpperCase();
    if (text === '') return fallback;
    const word = words.find((one) => one.toUpperCase() === text);
    if (word === undefined) throw this.error(field, words.join(' or '));
    return word;
  }

  error(field: string, expected: string): VolumeViewError {
    return invalid(`${field} of ${this.node}`, this.text(field), expected);
  }
}

/** The first of a texture's URLs, which X3D writes in quotation marks if there are several; '' if there is none. */
export function urlOf(fields: X3dFields): string {
  const text = fields.text('url');
  return (/^["'](.*?)["']/.exec(text)?.[1] ?? text).replace(/\s/g, '%20');
}

/** The field that a texture fills in the node around it, in lower case. */
export function containerFieldOf(texture: Element): string {
  return new X3dFields(texture, '').text('containerField').toLowerCase();
}
