import { pathOf } from './byte-store.ts';

/**
 * What the start of a file says of it. A slice is a file of a series, such as DICOM; a packed file is one of which only
 * its reader knows whether it holds a volume.
 */
export type FileKind = 'manifest' | 'volume' | 'slice' | 'packed' | 'image' | 'other';

/** A file whose start was read. */
export interface SniffedFile {
  readonly url: string;
  readonly kind: FileKind;
}

/** What several files are together. */
export type Division =
  /** One volume, whose header or manifest may name other files. */
  | { readonly is: 'volume'; readonly first: string }
  /** One volume of several files, in the order of their names: images that are its slices, or the files of series. */
  | { readonly is: 'stack'; readonly of: 'images' | 'slices'; readonly files: readonly string[] }
  /** Several volumes, or images that may be several. */
  | { readonly is: 'several'; readonly of: 'volumes' | 'images'; readonly urls: readonly string[] }
  | { readonly is: 'nothing' };

/** A kind comes before those after it: the other files belong to such a file. */
const order: readonly FileKind[] = ['manifest', 'volume', 'slice', 'packed', 'image'];

/**
 * Decides whether several files are one volume, the slices of one, or several volumes.
 * @param isStack - whether the page says that images are the slices of one volume
 */
export function divideFiles(files: readonly SniffedFile[], isStack: boolean): Division {
  const kind = order.find((one) => files.some((file) => file.kind === one));
  const urls = files.filter((file) => file.kind === kind).map(({ url }) => url);
  if (!kind) return { is: 'nothing' };
  if (urls.length === 1) return { is: 'volume', first: urls[0] };
  if (kind === 'slice') return { is: 'stack', of: 'slices', files: sortByName(urls) };
  if (kind !== 'image') return { is: 'several', of: 'volumes', urls };
  return isStack ? { is: 'stack', of: 'images', files: sortByName(urls) } : { is: 'several', of: 'images', urls };
}

/** In the order of their names, in which numbers count as numbers. */
function sortByName(urls: readonly string[]): string[] {
  const { compare } = new Intl.Collator('en', { numeric: true });
  const sorted = [...urls];
  sorted.sort((a, b) => compare(pathOf(a), pathOf(b)));
  return sorted;
}
