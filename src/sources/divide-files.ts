import { pathOf } from './byte-store.ts';

/**
 * What the start of a file says of it. A slice is a file of a series, such as DICOM; a packed file is one of which only
 * its reader knows whether it holds a volume; a page is an image that may be a volume by itself, as TIFF is.
 */
export type FileKind = 'manifest' | 'volume' | 'slice' | 'packed' | 'page' | 'image' | 'other';

/** A file whose start was read. */
export interface SniffedFile {
  readonly url: string;
  readonly kind: FileKind;
  /** The name of its format; '' where it is not known. */
  readonly format: string;
}

/** Files that belong together. */
export interface FilePart {
  /** A `volume` of one file, whose header may name others; `images` that are slices of one volume; or `slices`, the files of all series. */
  readonly of: 'volume' | 'images' | 'slices';
  /** In the order of their names. */
  readonly files: readonly string[];
  readonly format: string;
}

/** What several files are together. */
export interface Division {
  /** Each can be shown; the files of series come last, those of DICOM after all others. */
  readonly parts: readonly FilePart[];
  /** Images that are in none of them. */
  readonly images: readonly string[];
}

/**
 * Decides which volumes several files hold. Next to a manifest there is no other volume, as it may name all of them; packed files and
 * images may belong to other files, so they are volumes only where nothing else is.
 * @param isStack - whether the page says that images are the slices of one volume
 * @param isBeside - whether there are volumes of other files
 */
export function divideFiles(files: readonly SniffedFile[], isStack: boolean, isBeside = false): Division {
  const sorted = sortByName(files);
  const of = (...kinds: readonly FileKind[]): SniffedFile[] => sorted.filter(({ kind }) => kinds.includes(kind));
  const single = (some: readonly SniffedFile[]): FilePart[] =>
    some.map(({ url, format }) => ({ of: 'volume', files: [url], format }));
  const together = (what: 'images' | 'slices', some: readonly SniffedFile[]): FilePart[] =>
    some.length > (what === 'images' ? 1 : 0)
      ? [{ of: what, files: some.map(({ url }) => url), format: some[0].format }]
      : single(some);
  const manifests = of('manifest');
  if (manifests.length > 0) return { parts: single(manifests), images: [] };
  const [volumes, slices, pages, images] = [of('volume'), of('slice'), of('page'), of('image')];
  if (isBeside || volumes.length + slices.length > 0) {
    const stack = isStack && images.length > 1 ? together('images', images) : [];
    return {
      parts: [
        ...single(volumes),
        ...together('images', pages),
        ...stack,
        ...byFormat(slices).flatMap((some) => together('slices', some)),
      ],
      images: stack.length > 0 ? [] : images.map(({ url }) => url),
    };
  }
  const packed = of('packed');
  const all = of('page', 'image');
  if (packed.length > 0) return { parts: single(packed), images: all.map(({ url }) => url) };
  if (isStack || all.length === 1) return { parts: together('images', all), images: [] };
  return { parts: [], images: all.map(({ url }) => url) };
}

/** Files of series of one format belong together. Of DICOM there may be several series, so it comes last. */
function byFormat(slices: readonly SniffedFile[]): SniffedFile[][] {
  const names = [...new Set(slices.map(({ format }) => format))];
  names.sort((a, b) => Number(a === 'DICOM') - Number(b === 'DICOM'));
  return names.map((name) => slices.filter(({ format }) => format === name));
}

/** In the order of their names, in which numbers count as numbers. */
function sortByName(files: readonly SniffedFile[]): SniffedFile[] {
  const { compare } = new Intl.Collator('en', { numeric: true });
  const sorted = [...files];
  sorted.sort((a, b) => compare(pathOf(a.url), pathOf(b.url)));
  return sorted;
}
