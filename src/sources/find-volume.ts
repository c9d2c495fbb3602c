import { VolumeViewError } from '../core/errors.ts';
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
import type { Division, FileKind, SniffedFile } from './divide-files.ts';
import { GroupReader } from './group-reader.ts';

/** Bytes of a file by which its format is recognized, where the first few do not say it. */
export const startBytes = 2 ** 16;

/** The starts of so many files are kept: 32 MiB. */
const maxStarts = 2 ** 11;

/** Bytes of a manifest, which has to be read to know that it is one: other programs write JSON files too. */
const maxManifestBytes = 2 ** 26;

/** Of packed files, the endings of those that hold a volume, and not the data of a header. */
const packedVolume = /\.(nii|mgh|mha|nrrd|npy|vti|mnc|mrcs?|ccp4|map)\.(gz|bz2|zst)$/i;

const everyFormat: readonly Format[] = [...allFormats, ...rareFormats];

/** The volumes in the files of a store. */
export interface FoundVolumes extends Division {
  /** The starts of some files of a series, which were read already. */
  readonly starts?: ReadonlyMap<string, DecodeInput>;
  /** Known files that are not read, in words without their names: what each is, and what to do. */
  readonly refused: readonly string[];
}

export interface FindOptions {
  /** What holds the files, for messages: 'the ZIP archive scan.zip'. */
  readonly what: string;
  /** Whether there are volumes of other files: then none among these is no error. */
  readonly isBeside?: boolean;
  /** Whether images are slices of one volume. */
  readonly isStack: boolean;
  readonly signal?: AbortSignal;
  /** Called while many files are looked at. */
  readonly onLook?: () => void;
}

/** A call of `onLook` comes after so many files. */
const lookEvery = 32;

/**
 * Finds the volumes that the files of an archive, or chosen files, hold, by the start of each.
 * @param urls - of the store
 * @param what - the store, for messages: 'the ZIP archive scan.zip'
 * @throws {VolumeViewError} `format/unknown` or `format/unsupported` where there is none
 */
export async function findVolumes(
  store: ByteStore,
  urls: readonly string[],
  { what, isStack, isBeside, signal, onLook }: FindOptions,
): Promise<FoundVolumes> {
  if (urls.length === 0) throw new VolumeViewError('format/unknown', `${what} holds no files; expected one volume`);
  if (urls.length === 1 && !isBeside)
    return { parts: [{ of: isStack ? 'images' : 'volume', files: urls, format: '' }], images: [], refused: [] };
  const files: SniffedFile[] = [];
  const starts = new Map<string, DecodeInput>();
  const foreign = new Map<string, { readonly urls: string[]; readonly advice: string }>();
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
    let sniffed = await sniffStart(store, url, start);
    if ((sniffed.kind === 'other' || sniffed.kind === 'packed') && read.value.missing! > 0) {
      start = await lookAt((await store.read(url, { range: { start: 0, end: startBytes }, signal })).bytes);
      sniffed = await sniffStart(store, url, start);
    }
    if (files.push(sniffed) % lookEvery === 0) onLook?.();
    const { kind } = sniffed;
    if (kind === 'slice' && starts.size === 0) loadAhead(start);
    if (kind === 'slice' && starts.size < maxStarts) starts.set(url, keepStart(read.value));
    const other = kind === 'other' ? findForeign(start) : null;
    if (other) foreign.set(other.name, { urls: [...(foreign.get(other.name)?.urls ?? []), url], advice: other.advice });
  }
  const division = divideFiles(files, isStack, isBeside);
  if (division.parts.length === 0 && !isBeside) {
    if (division.images.length > 0) throw refuseImages(what, division.images);
    const [[name, { urls: named, advice }] = [null, { urls: [], advice: '' }]] = foreign;
    throw refuseAll(what, urls, name === null ? null : { url: named[0], name, advice });
  }
  return {
    ...division,
    starts,
    refused: [...foreign].map(
      ([name, { urls: named, advice }]) =>
        `${named.length > 1 ? `${named.length.toLocaleString('en')} other files, each` : 'another file, which is'} ${name}: volume-view does not read it; convert it ${advice}`,
    ),
  };
}

/** The reader comes while the other files are looked at. */
function loadAhead(start: FileStart): void {
  const format: Format | null = findByBytes(start, everyFormat);
  // If it can't be loaded, that is said where it is needed.
  if (format && 'load' in format) format.load().catch(() => null);
}

/** In memory of its own: that of a group is not kept for one of its files. */
const keepStart = (start: DecodeInput): DecodeInput => ({ ...start, bytes: start.bytes.slice() });

/** What a file of a store is, by its start. */
async function sniffStart(store: ByteStore, url: string, start: FileStart): Promise<SniffedFile> {
  const format: Format | null = findByBytes(start, everyFormat);
  return { url, kind: await kindOf(store, url, { format, start }), format: format?.name ?? '' };
}

/** What a file of a store is, by its start. @param start - of the file */
export async function sniffKind(store: ByteStore, url: string, start: FileStart): Promise<FileKind> {
  return kindOf(store, url, { format: findByBytes(start, everyFormat), start });
}

async function kindOf(
  store: ByteStore,
  url: string,
  { format, start }: { readonly format: Format | null; readonly start: FileStart },
): Promise<FileKind> {
  if (!format) return 'other';
  if (format === manifest) return (await isManifest(store, url)) ? 'manifest' : 'other';
  if ('loadImage' in format) return 'image';
  if (format.mayBeSlice) return 'page';
  if (format.isSlice) return 'slice';
  return (await isCertain(format, start)) || packedVolume.test(pathOf(url)) ? 'volume' : 'packed';
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

/**
 * Other programs write JSON, too: the keys decide. A file that is named JSON, and is none, is left to its reader, which says so, where it has such
 * a key: Python writes NaN into what lies next to volumes. Other data may begin with a brace by chance.
 */
async function isManifest(store: ByteStore, url: string): Promise<boolean> {
  const { size } = await store.stat(url);
  if (size === null || size > maxManifestBytes) return false;
  const { bytes } = await store.read(url);
  let text = new TextDecoder().decode(bytes);
  try {
    text = String(Object.keys(JSON.parse(text) as object).map((key) => `"${key}":`));
  } catch {
    if (!/\.json$/i.test(url)) return false;
  }
  return /"(image|video|files|scans)"\s*:/.test(text);
}

function refuseImages(what: string, urls: readonly string[]): VolumeViewError {
  return new VolumeViewError(
    'format/unsupported',
    `${what} holds ${urls.length} images, ${listPaths(urls)}; expected one volume. Write the attribute stack if each of them is one slice`,
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
