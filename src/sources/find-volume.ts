import { VolumeViewError } from '../core/errors.ts';
import { checkFileCount } from '../formats/base/check-file-count.ts';
import { findForeign } from '../formats/base/foreign-formats.ts';
import type { DecodeInput } from '../formats/base/decoded-volume.ts';
import { keptBytes } from '../formats/base/format.ts';
import type { FileStart, Format } from '../formats/base/format.ts';
import { readAhead } from '../formats/base/read-ahead.ts';
import { manifest } from '../formats/manifest/manifest-format.ts';
import { rareFormats } from '../formats/rare-formats.ts';
import { allFormats } from '../formats/registry.ts';
import { lookAt, findByBytes } from '../formats/sniff.ts';
import { pathOf } from './byte-store.ts';
import type { ByteStore } from './byte-store.ts';
import { divideFiles } from './divide-files.ts';
import type { FileKind, SniffedFile } from './divide-files.ts';
import { GroupReader } from './group-reader.ts';

/** Bytes of a file by which its format is recognized, where the first few do not say it. */
export const startBytes = 2 ** 16;

/** The starts of so many files are kept: 32 MiB. */
const maxStarts = 2 ** 11;

/** Bytes of a manifest, which has to be read to know that it is one: other programs write JSON files too. */
const maxManifestBytes = 2 ** 26;

const everyFormat: readonly Format[] = [...allFormats, ...rareFormats];

/** The file of a store with which its volume begins, and all files of a stack. */
export interface FoundVolume {
  readonly first: string;
  readonly files?: readonly string[];
  /** Whether names of the files may be those of patients: then messages do not have them. */
  readonly isPrivate?: true;
  /** The starts of some files of a series, which were read already. */
  readonly starts?: ReadonlyMap<string, DecodeInput>;
}

export interface FindOptions {
  /** Whether images are slices of one volume. */
  readonly isStack: boolean;
  readonly signal?: AbortSignal;
  /** Called while many files are looked at. */
  readonly onLook?: () => void;
}

/** A call of `onLook` comes after so many files. */
const lookEvery = 32;

/**
 * Finds the one volume that the files of an archive, or chosen files, hold: the file of a manifest, else the only file of
 * a volume, whose header may name other files; else all files of series; else the only image, or all images as the slices
 * of a stack.
 * @param what - the store, for messages: 'the ZIP archive scan.zip'
 * @throws {VolumeViewError} `format/unknown` where there is none, `format/unsupported` where there are several
 */
export async function findVolume(
  store: ByteStore,
  what: string,
  { isStack, signal, onLook }: FindOptions,
): Promise<FoundVolume> {
  const urls = ((await store.list()) ?? []).filter((url) => !isLitter(url));
  if (urls.length === 0) throw new VolumeViewError('format/unknown', `${what} holds no files; expected one volume`);
  const [first] = urls;
  if (urls.length === 1) return { first, ...(isStack && { files: urls }) };
  const files: SniffedFile[] = [];
  const starts = new Map<string, DecodeInput>();
  let other: { readonly url: string; readonly name: string; readonly advice: string } | null = null;
  const few = { start: 0, end: keptBytes };
  const reader = new GroupReader(store, {
    range: few,
    signal,
    readOne: (url) => store.read(url, { range: few, signal }),
  });
  const ahead = reader.plan(urls, () => keptBytes);
  for await (const read of readAhead(urls, (url) => reader.read(url), ahead)) {
    signal?.throwIfAborted();
    if (read.status === 'rejected') throw read.reason;
    const url = urls[files.length];
    let start = await lookAt(read.value.bytes);
    let kind = await sniffKind(store, url, start);
    if ((kind === 'other' || kind === 'packed') && read.value.missing! > 0) {
      start = await lookAt((await store.read(url, { range: { start: 0, end: startBytes }, signal })).bytes);
      kind = await sniffKind(store, url, start);
    }
    if (files.push({ url, kind }) % lookEvery === 0) onLook?.();
    if (kind === 'slice' && starts.size === 0) loadAhead(start);
    if (kind === 'slice' && starts.size < maxStarts) starts.set(url, keepStart(read.value));
    const foreign = kind === 'other' ? findForeign(start) : null;
    if (foreign) other ??= { url, ...foreign };
  }
  const division = divideFiles(files, isStack);
  switch (division.is) {
    case 'volume':
      return { first: division.first };
    case 'stack':
      checkFileCount(what, division.files.length);
      return {
        first: division.files[0],
        files: division.files,
        ...(division.of === 'slices' && { isPrivate: true, starts }),
      };
    case 'several':
      throw refuseSeveral(what, division.urls, division.of);
    case 'nothing':
      throw refuseAll(what, urls, other);
  }
}

/** The reader comes while the other files are looked at. */
function loadAhead(start: FileStart): void {
  const format: Format | null = findByBytes(start, everyFormat);
  // If it can't be loaded, that is said where it is needed.
  if (format && 'load' in format) format.load().catch(() => null);
}

/** In memory of its own: that of a group is not kept for one of its files. */
const keepStart = (start: DecodeInput): DecodeInput => ({ ...start, bytes: start.bytes.slice() });

/** What a file of a store is, by its start. @param start - of the file */
export async function sniffKind(store: ByteStore, url: string, start: FileStart): Promise<FileKind> {
  const format: Format | null = findByBytes(start, everyFormat);
  if (!format) return 'other';
  if (format === manifest) return (await isManifest(store, url)) ? 'manifest' : 'other';
  if ('loadImage' in format) return 'image';
  if (format.mayBeSlice) return 'image';
  if (format.isSlice) return 'slice';
  return (await isCertain(format, start)) ? 'volume' : 'packed';
}

/** What systems add to archives and folders by themselves. */
export function isLitter(url: string): boolean {
  return /(^|\/)(__MACOSX\/|\.[^/]*$|Thumbs\.db$|desktop\.ini$)/i.test(pathOf(url));
}

/** Of a gzip file that no format recognizes, it is not known whether it holds a volume: it may be the data of a header. */
async function isCertain(format: Format, { unpacked }: FileStart): Promise<boolean> {
  return (
    !format.last ||
    (unpacked !== null && findByBytes(await lookAt(unpacked as Uint8Array<ArrayBuffer>), everyFormat) !== null)
  );
}

/** A file that is meant to be JSON, and is not, is left to its reader, which says so. */
async function isManifest(store: ByteStore, url: string): Promise<boolean> {
  const { size } = await store.stat(url);
  if (size === null || size > maxManifestBytes) return false;
  try {
    const { bytes } = await store.read(url);
    const value = JSON.parse(new TextDecoder().decode(bytes)) as object;
    return ['image', 'files', 'scans'].some((name) => Object.hasOwn(value, name));
  } catch (cause) {
    if (cause instanceof SyntaxError) return true;
    throw cause;
  }
}

function refuseSeveral(what: string, urls: readonly string[], of: 'volumes' | 'images'): VolumeViewError {
  const advice =
    of === 'images'
      ? 'Write the attribute stack if each of them is one slice'
      : 'Choose one of them; src takes several URLs for scans in time';
  return new VolumeViewError(
    'format/unsupported',
    `${what} holds ${urls.length} ${of}, ${listPaths(urls)}; expected one volume. ${advice}`,
  );
}

/** @param other - a file of a known format that is not read */
function refuseAll(
  what: string,
  urls: readonly string[],
  other: { readonly url: string; readonly name: string; readonly advice: string } | null,
): VolumeViewError {
  if (other) {
    return new VolumeViewError(
      'format/unsupported',
      `${what} holds ${urls.length} files and no volume: ${pathOf(other.url)} is ${other.name}, which volume-view does not read; convert it ${other.advice}`,
    );
  }
  return new VolumeViewError(
    'format/unknown',
    `${what} holds ${urls.length} files, ${listPaths(urls)}, and none of a known type; expected one volume`,
  );
}

function listPaths(urls: readonly string[]): string {
  const named = urls.slice(0, 3).map((url) => pathOf(url));
  return named.join(', ') + (urls.length > named.length ? ' …' : '');
}
