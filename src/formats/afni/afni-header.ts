import { corruptFile } from '../base/file-problem.ts';
import { readHeaderLines } from '../grid-files/read-header-lines.ts';

export const what = 'the AFNI header';

/** Attributes of a header, by name: texts, or lists of numbers. */
export type AfniHeader = ReadonlyMap<string, string | readonly number[]>;

/** More than a header with thousands of volumes has. */
const maxNumbers = 2 ** 20;

/**
 * Reads a header: blocks of `type = …`, `name = …`, `count = …`, and then so many numbers, or a text that begins with "'".
 * Source: AFNI, README.attributes
 * @throws {VolumeViewError} `format/corrupt`
 */
export function readAfniHeader(bytes: Uint8Array): AfniHeader {
  const header = new Map<string, string | readonly number[]>();
  let [name, isText] = ['', false];
  let numbers: number[] = [];
  let total = 0;
  const finish = (): void => {
    if (name !== '' && !isText) header.set(name, numbers);
    [name, isText, numbers] = ['', false, []];
  };
  for (const { text } of readHeaderLines(what, bytes)) {
    const [, key, value] = /^\s*(type|name|count)\s*=\s*(.{0,200})/.exec(text) ?? [];
    if (key === 'type') {
      finish();
      isText = value.startsWith('string');
    } else if (key === 'name') name = value.trim();
    else if (key === 'count') continue;
    else if (isText && text.startsWith("'")) header.set(name, text.slice(1).replace(/~$/, ''));
    else if (!isText && name !== '') {
      for (const word of text.split(/\s+/)) {
        if (word !== '') numbers.push(Number(word));
      }
      total += text.length;
      if (total > 20 * maxNumbers)
        throw corruptFile(what, `holds more than ${maxNumbers.toLocaleString('en')} numbers; the file is damaged`);
    }
  }
  finish();
  return header;
}

/** Numbers of an attribute, all finite, at least `count` of them; null if it is absent. @throws {VolumeViewError} `format/corrupt` */
export function numbersOf(header: AfniHeader, name: string, count: number): readonly number[] | null {
  const value = header.get(name);
  if (value === undefined || typeof value === 'string') return null;
  if (value.length >= count && value.every(Number.isFinite)) return value;
  throw corruptFile(
    what,
    `got ${name} "${value.slice(0, 6).join(' ')}"; expected ${count} number${count > 1 ? 's' : ''} or more`,
  );
}
