import type { NumberType } from '../base/number-types.ts';
import { corruptFile } from '../base/file-problem.ts';

const longestNumber = 64;

/**
 * Reads numbers written as text, separated by white space or commas.
 * @param count - numbers that are wanted; further ones are ignored
 * @returns their bytes, in this machine's order
 * @throws {VolumeViewError} `format/corrupt`
 */
export function readTextNumbers(
  what: string,
  text: Uint8Array,
  count: number,
  type: NumberType,
): Uint8Array<ArrayBuffer> {
  // A number and its separator take two characters: a shorter text can't hold `count` numbers.
  if (count > (text.length + 1) / 2)
    throw corruptFile(what, `asks for ${count} numbers, and ${text.length} characters follow; the file is cut short`);
  const bytes = new Uint8Array(count * type.bytesPerSample);
  const values = type.read.view(bytes);
  let at = 0;
  for (let i = 0; i < count; i++) {
    while (at < text.length && isGap(text[at])) at++;
    const start = at;
    while (at < text.length && !isGap(text[at]) && at - start < longestNumber) at++;
    if (start === at) throw corruptFile(what, `asks for ${count} numbers and got ${i}; the file is cut short`);
    const token = String.fromCharCode(...text.subarray(start, at));
    if (!setNumber(values, i, token))
      throw corruptFile(what, `got "${token}" as number ${i + 1}; expected a number of type ${type.name}`);
  }
  return bytes;
}

/** White space, or a comma. */
function isGap(code: number): boolean {
  return code <= 0x20 || code === 0x2c;
}

/** Stores a number; false if the text is not a number of the type. */
function setNumber(values: ReturnType<NumberType['read']['view']>, i: number, token: string): boolean {
  if (values instanceof BigInt64Array || values instanceof BigUint64Array) {
    if (!/^[+-]?\d+$/.test(token)) return false;
    const value = BigInt(token.replace('+', ''));
    values[i] = value;
    return values[i] === value;
  }
  const value = parseNumber(token);
  if (value === null) return false;
  values[i] = value;
  return values instanceof Float32Array || values instanceof Float64Array || values[i] === value;
}

function parseNumber(token: string): number | null {
  const word = /^([+-]?)(nan|inf(?:inity)?)$/i.exec(token);
  if (word) return word[2].toLowerCase() === 'nan' ? NaN : word[1] === '-' ? -Infinity : Infinity;
  return /^[+-]?(\d+(\.\d*)?|\.\d+)(e[+-]?\d+)?$/i.test(token) ? Number(token) : null;
}
