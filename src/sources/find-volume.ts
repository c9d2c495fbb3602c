import { VolumeViewError } from '../core/errors.ts';
import { checkFileCount } from '../formats/base/check-file-count.ts';
import { findForeign } from '../formats/base/foreign-formats.ts';
import type { FileStart, Format } from '../formats/base/format.ts';
import { manifest } from '../formats/manifest/manifest-format.ts';
import { allFormats } from '../formats/registry.ts';
import { lookAt, findByBytes } from '../formats/sniff.ts';
import { pathOf } from './byte-store.ts';
import type { ByteStore } from './byte-store.ts';

/** Bytes of each file by which its format is recognized. */
const startBytes = 2 ** 16;

/** Bytes of a manifest, which has to be read to know that it is one: other programs write JSON files too. */
const maxManifestBytes = 2 ** 26;

/** The file of a store with which its volume begins, and all files of a stack. */
export interface FoundVolume {
  readonly first: string;
  readonly files?: readonly string[];
}

export interface FindOptions {
  /** Whether images are slices of one volume. */
  readonly isStack: boolean;
  readonly signal?: AbortSignal;
}

/**
 * Finds the one volume that the files of an archive, or chosen files, hold: the file of a manifest, else the only file of
 * a volume, whose header may name other files; else the only image, or all images as the slices of a stack.
 * @param what - the store, for messages: 'the ZIP archive scan.zip'
 * @throws {VolumeViewError} `format/unknown` where there is none, `format/unsupported` where there are several
 */
export async function findVolume(
  store: ByteStore,
  what: string,
  { isStack, signal }: FindOptions,
): Promise<FoundVolume> {
  const urls = ((await store.list()) ?? []).filter((url) => !isLitter(url));
  if (urls.length === 0) throw new VolumeViewError('format/unknown', `${what} holds no files; expected one volume`);
  const [first] = urls;
  if (urls.length === 1) return { first, ...(isStack && { files: urls }) };
  const volumes: string[] = [];
  const packed: string[] = [];
  const images: string[] = [];
  const manifests: string[] = [];
  let other: { readonly url: string; readonly name: string; readonly advice: string } | null = null;
  for (const url of urls) {
    signal?.throwIfAborted();
    const { bytes } = await store.read(url, { range: { start: 0, end: startBytes }, signal });
    const start = await lookAt(bytes);
    const format: Format | null = findByBytes(start, allFormats);
    const foreign = format ? null : findForeign(start);
    if (foreign) other ??= { url, ...foreign };
    if (format === manifest) {
      if (await isManifest(store, url)) manifests.push(url);
    } else if (format && 'loadImage' in format) images.push(url);
    else if (format) ((await isCertain(format, start)) ? volumes : packed).push(url);
  }
  const found = [manifests, volumes, packed, images].find((list) => list.length > 0) ?? [];
  if (found.length === 1) return { first: found[0] };
  if (found === images && isStack) return findStack(images, what);
  if (found.length > 1) throw refuseSeveral(what, found, found === images);
  if (other) {
    throw new VolumeViewError(
      'format/unsupported',
      `${what} holds ${urls.length} files and no volume: ${pathOf(other.url)} is ${other.name}, which volume-view does not read; convert it ${other.advice}`,
    );
  }
  throw new VolumeViewError(
    'format/unknown',
    `${what} holds ${urls.length} files, ${listPaths(urls)}, and none of a known type; expected one volume`,
  );
}

/** What systems add to archives and folders by themselves. */
function isLitter(url: string): boolean {
  return /(^|\/)(__MACOSX\/|\.[^/]*$|Thumbs\.db$|desktop\.ini$)/i.test(pathOf(url));
}

/** Of a gzip file that no format recognizes, it is not known whether it holds a volume: it may be the data of a header. */
async function isCertain(format: Format, { unpacked }: FileStart): Promise<boolean> {
  return (
    !format.last ||
    (unpacked !== null && findByBytes(await lookAt(unpacked as Uint8Array<ArrayBuffer>), allFormats) !== null)
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

/** Slices in the order of their names, in which numbers count as numbers. */
function findStack(images: readonly string[], what: string): FoundVolume {
  checkFileCount(what, images.length);
  const { compare } = new Intl.Collator('en', { numeric: true });
  const files = [...images];
  files.sort((a, b) => compare(pathOf(a), pathOf(b)));
  return { first: files[0], files };
}

function refuseSeveral(what: string, found: readonly string[], isImages: boolean): VolumeViewError {
  const advice = isImages
    ? 'Write the attribute stack if each of them is one slice'
    : 'Choose one of them; src takes several URLs for scans in time';
  return new VolumeViewError(
    'format/unsupported',
    `${what} holds ${found.length} ${isImages ? 'images' : 'volumes'}, ${listPaths(found)}; expected one volume. ${advice}`,
  );
}

function listPaths(urls: readonly string[]): string {
  const named = urls.slice(0, 3).map((url) => pathOf(url));
  return named.join(', ') + (urls.length > named.length ? ' …' : '');
}
