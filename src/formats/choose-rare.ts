import { VolumeViewError } from '../core/errors.ts';
import type { DecodeInput } from './base/decoded-volume.ts';
import { findForeign } from './base/foreign-formats.ts';
import type { FileStart, Format } from './base/format.ts';
import { nameOf } from './base/name-of.ts';
import { rareFormats } from './rare-formats.ts';

/**
 * Chooses a file's format if its bytes match none of the usual ones: a rare format by its bytes, or by its name if it
 * may hold samples alone, else the one that is asked last, else one by the file's name.
 * @param last - the format that is asked last and whose bytes the file has; null if there is none
 * @throws {VolumeViewError} `format/unknown`, `format/unsupported`, `format/corrupt`, with a message about what was
 * received
 */
export function chooseRare(
  { bytes, url, contentType }: DecodeInput,
  start: FileStart,
  usual: readonly Format[],
  last: Format | null,
): Format {
  const name = nameOf(url);
  const foreign = findForeign(start);
  const found =
    rareFormats.find((format) => format.matches(start)) ??
    (foreign || bytes.length === 0 ? null : findData(name)) ??
    last;
  if (found) return found;
  const formats = [...usual, ...rareFormats];
  const { text } = start;
  if (foreign)
    throw new VolumeViewError(
      'format/unsupported',
      `${name} is ${foreign.name}, which volume-view does not read; convert it ${foreign.advice}`,
    );
  if (text.startsWith('<'))
    throw unknown(`the server answered ${name} with a web page or XML instead of data; check the URL`);
  if (bytes.length === 0) throw unknown(`${name} is empty; check the file`);
  // If the name has one of our endings and the bytes don't match, the file is damaged or cut. Its reader explains that.
  const ending = /\.([^.]+)$/.exec(name)?.[1].toLowerCase() ?? '';
  const named = formats.find(({ endings }) => endings.includes(ending));
  if (named && named.beginning === null) return named;
  if (named) {
    throw new VolumeViewError(
      'format/corrupt',
      `${name} does not begin with ${named.beginning}; the file is damaged, cut short or misnamed`,
    );
  }
  const type = contentType ? ` (sent as ${contentType})` : '';
  throw unknown(`${name}${type} is of no known type; expected ${listWords(formats)}`);
}

/** The format of which a file with this name, packed or not, may hold the samples alone: such files have no mark. */
function findData(name: string): Format | null {
  const ending = /\.([^.]+?)(\.gz)?$/i.exec(name)?.[1].toLowerCase() ?? '';
  return rareFormats.find(({ beginning, endings }) => beginning === null && endings.includes(ending)) ?? null;
}

/** 'a, b or c'. */
function listWords(formats: readonly Format[]): string {
  const words = Array.from(new Set(formats.map((format) => format.words)));
  words.sort((a, b) => a.localeCompare(b, 'en'));
  const last = words.pop() ?? 'nothing';
  return words.length > 0 ? `${words.join(', ')} or ${last}` : last;
}

function unknown(message: string): VolumeViewError {
  return new VolumeViewError('format/unknown', message);
}
