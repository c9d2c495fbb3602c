import { checkFileCount } from '../base/check-file-count.ts';
import type { DecodeInput } from '../base/decoded-volume.ts';
import type { ReadContext } from '../base/format.ts';
import { nameOf } from '../base/name-of.ts';
import { corruptFile, unsupportedFile } from '../base/file-problem.ts';

/**
 * The names that a pattern stands for: 'slice%03d.raw 1 20 1' has one number in the syntax of C's printf, its first and
 * last value, and the step.
 */
export function expandPattern(what: string, text: string): string[] | null {
  const words = text.trim().split(/\s+/);
  const numbers = countNumbers(words);
  if (numbers < 2 || text.length > 4096) return null;
  // A fourth number is the dimension of each file, which the header gives too.
  const [first, last, step = 1] = words.slice(-Math.min(numbers, words.length - 1)).map(Number);
  const pattern = text.trim().slice(0, endOfName(text.trim(), Math.min(numbers, words.length - 1)));
  const place = findPlace(pattern);
  if (!place) return null;
  const count = Math.floor((last - first) / step) + 1;
  if (!Number.isFinite(count))
    throw corruptFile(what, `got the files "${shorten(text)}"; expected a step other than 0`);
  checkFileCount(what, count);
  if (place.width > 32)
    throw corruptFile(what, `got a number of ${place.width} digits in "${shorten(text)}"; expected 32 at most`);
  return Array.from(
    { length: count },
    (_, i) => place.before + pad(first + i * step, place.width, place.fill) + place.after,
  );
}

/** Counts the whole numbers at a text's end, four at most. */
function countNumbers(words: readonly string[]): number {
  let count = 0;
  while (count < 4 && /^-?\d+$/.test(words.at(-1 - count) ?? '')) count++;
  return count;
}

/** The index at which the part before the last words ends. */
function endOfName(text: string, words: number): number {
  let end = text.length;
  for (let word = 0; word < words; word++) end = text.slice(0, end).trimEnd().search(/\S+$/);
  return text.slice(0, end).trimEnd().length;
}

/** Finds the first number of C's printf in a name. */
function findPlace(name: string): { before: string; width: number; fill: '0' | ' '; after: string } | null {
  for (let at = name.indexOf('%'); at >= 0; at = name.indexOf('%', at + 1)) {
    const [all, zero, width] = /^%(0?)(\d{0,9})[diu]/.exec(name.slice(at, at + 16)) ?? [];
    if (all !== undefined)
      return {
        before: name.slice(0, at),
        width: Number(width),
        fill: zero ? '0' : ' ',
        after: name.slice(at + all.length),
      };
  }
  return null;
}

/** Pads a number as C's printf does: the sign comes before zeros. */
function pad(value: number, width: number, fill: '0' | ' '): string {
  const sign = value < 0 ? '-' : '';
  const digits = String(Math.abs(value));
  return fill === '0' ? sign + digits.padStart(width - sign.length, '0') : (sign + digits).padStart(width, ' ');
}

/**
 * URLs of the files that a header names. If the page gave a stack, its files are used, whatever their names; else the
 * names are resolved relative to the header.
 * @param names - as the header has them; null if the data follow it in its own file
 * @returns null if the data follow the header
 * @throws {VolumeViewError} `format/unsupported`, `format/too-large`, `format/corrupt`
 */
export function findDataFiles(
  what: string,
  names: readonly string[] | null,
  input: DecodeInput,
  { further }: Pick<ReadContext, 'further'>,
): readonly string[] | null {
  if (!names) {
    if (further.length === 0) return null;
    throw unsupportedFile(
      what,
      `has its data in its own file, and the stack has ${further.length} more; leave them out`,
    );
  }
  checkFileCount(what, names.length);
  if (further.length === 0) return names.map((name) => resolveName(what, name, input.url));
  if (further.length === names.length) return further;
  throw unsupportedFile(
    what,
    `names ${names.length} data file${names.length > 1 ? 's' : ''} and the stack has ${further.length} other files; expected all of them, in the header's order`,
  );
}

/** Bytes of samples in each file. @throws {VolumeViewError} `format/corrupt` if the files can't hold equal parts */
export function shareBytes(
  what: string,
  bytesInAll: number,
  bytesPerSample: number,
  files: readonly string[] | null,
): number {
  const each = bytesInAll / (files?.length ?? 1);
  if (Number.isInteger(each / bytesPerSample)) return each;
  throw corruptFile(
    what,
    `names ${files?.length} data files, which can not hold equal parts of its ${bytesInAll / bytesPerSample} samples; the list is not complete`,
  );
}

/**
 * The URL of a file whose name is relative to its header. A name is not a URL: '#', '?' and '%' in it are characters.
 * Names with a root or a scheme are paths of the machine that wrote the header, and are not followed.
 */
function resolveName(what: string, name: string, base: string): string {
  if (name === '') throw corruptFile(what, 'names no data file; expected a file name');
  // oxlint-disable-next-line no-control-regex -- They are what is looked for.
  if (/[\0-\x1f]/.test(name))
    throw corruptFile(what, 'names a data file with a control character in its name; the file is damaged');
  const path = name.replaceAll('\\', '/');
  if (path.startsWith('/') || /^[a-z][a-z\d+.-]*:/i.test(path)) {
    throw unsupportedFile(
      what,
      `names the data file "${shorten(name)}", an absolute path; expected a name relative to the header: edit it, or list header and data in a stack`,
    );
  }
  if (!/^https?:/.test(base)) {
    throw unsupportedFile(
      what,
      `names the data file "${shorten(name)}", which can not be found from ${nameOf(base)}; expected header and data listed in a stack, or the data in the header's file`,
    );
  }
  return new URL(path.split('/').map(encodeURIComponent).join('/'), base).href;
}

function shorten(name: string): string {
  return name.length > 80 ? `${name.slice(0, 80)}…` : name;
}
