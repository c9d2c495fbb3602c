import { VolumeViewError } from '../errors.ts';
import type { DecodeInput } from './decoded-volume.ts';
import type { FileStart, Format } from './format.ts';
import { gunzip, isGzip } from './gunzip.ts';

/**
 * What a file is: its bytes say so first, then its name.
 * @param formats - those that are known
 * @throws {VolumeViewError} `format/unknown`, `format/corrupt`, in words that fit what came instead
 */
export async function sniffFile(input: DecodeInput, formats: readonly Format[]): Promise<Format> {
  const start = await lookAt(input.bytes);
  const found = findByBytes(start, formats);
  if (found) return found;
  const name = nameOf(input.url);
  if (start.text.startsWith('<')) throw unknown(`the server answered ${name} with a web page or XML instead of data; check the URL`);
  if (input.bytes.length === 0) throw unknown(`${name} is empty; check the file`);
  // A file that the name calls one of ours and the bytes do not is a damaged or cut one, which its reader explains.
  const ending = /\.([^.]+)$/.exec(name)?.[1].toLowerCase() ?? '';
  const named = formats.find(({ endings }) => endings.includes(ending));
  if (named && named.beginning === null) return named;
  if (named) {
    throw new VolumeViewError('format/corrupt', `${name} does not begin with ${named.beginning}; the file is damaged, cut short or misnamed`);
  }
  const type = input.contentType ? ` (sent as ${input.contentType})` : '';
  throw unknown(`${name}${type} is of no known type; expected ${listWords(formats)}`);
}

/** What a file is by its bytes alone, or null. */
export async function findFormat<F extends Format>(bytes: Uint8Array<ArrayBuffer>, formats: readonly F[]): Promise<F | null> {
  return findByBytes(await lookAt(bytes), formats);
}

function findByBytes<F extends Format>(start: FileStart, formats: readonly F[]): F | null {
  const matching = formats.filter((format) => format.matches(start));
  return matching.find(({ last }) => !last) ?? matching[0] ?? null;
}

async function lookAt(bytes: Uint8Array<ArrayBuffer>): Promise<FileStart> {
  return {
    bytes,
    unpacked: isGzip(bytes) ? await firstPiece(bytes) : null,
    text: new TextDecoder().decode(bytes.subarray(0, 512)).trimStart(),
  };
}

/** The beginning of what a gzip file holds; nothing where it is damaged, which its reader explains. */
async function firstPiece(bytes: Uint8Array<ArrayBuffer>): Promise<Uint8Array> {
  try {
    for await (const piece of gunzip(bytes.subarray(0, 1 << 16))) return piece;
  } catch {
    // The stream was cut short on purpose, and may also be damaged.
  }
  return new Uint8Array();
}

/** 'a, b or c'. */
function listWords(formats: readonly Format[]): string {
  const words = Array.from(new Set(formats.map((format) => format.words)));
  words.sort((a, b) => a.localeCompare(b, 'en'));
  const last = words.pop() ?? 'nothing';
  return words.length > 0 ? `${words.join(', ')} or ${last}` : last;
}

/** The last part of a URL's path, for messages; of a data: URL only its type, of a blob: URL the fragment, where it has one. */
export function nameOf(url: string): string {
  if (url.startsWith('data:')) return url.slice(0, Math.min(40, url.indexOf(',') + 1 || 40));
  if (url.startsWith('blob:') && url.includes('#')) return decodeFragment(url);
  const path = url.replace(/[?#].*$/, '');
  return path.slice(path.lastIndexOf('/') + 1) || path;
}

function decodeFragment(url: string): string {
  const fragment = url.slice(url.indexOf('#') + 1);
  try {
    return decodeURIComponent(fragment);
  } catch {
    return fragment;
  }
}

function unknown(message: string): VolumeViewError {
  return new VolumeViewError('format/unknown', message);
}
