import type { Budget } from '../base/budget.ts';
import { corruptFile } from '../base/file-problem.ts';
import type { PageUse } from './decode-page.ts';
import { isImageJ, layOutImageJ } from './imagej-layout.ts';
import type { TiffLayout } from './layout.ts';
import { layOutOme } from './ome-layout.ts';
import { isOme } from './ome-pixels.ts';
import { isShaped, layOutShaped } from './shaped-layout.ts';
import { TiffFile, tags, what } from './tiff-file.ts';
import type { Directory } from './tiff-file.ts';
import { isSlicePage, keyOf, readPage } from './tiff-page.ts';
import type { TiffPage } from './tiff-page.ts';
import { checkPacking } from './unpack-block.ts';

/** A file whose pages are known. */
export interface TiffStack {
  readonly file: TiffFile;
  readonly layout: TiffLayout;
  /** The first slice; the others are like it. */
  readonly page: TiffPage;
  /** The number of pages. */
  readonly pages: number;
  readonly use: PageUse;
  /** @param index - of a page, as the layout has it @throws {VolumeViewError} `format/corrupt` where it is not like the first slice */
  readPageAt(index: number): TiffPage;
}

/** @throws {VolumeViewError} `format/corrupt`, `format/unsupported`, `format/too-large` */
export function openTiff(bytes: Uint8Array<ArrayBuffer>, budget: Budget): TiffStack {
  const file = new TiffFile(bytes, budget);
  const all = file.readDirectories();
  const description = file.text(all[0], tags.description);
  if (isOme(description)) return makeStack(file, layOutOme(description, all.length, budget), all);
  const described = isImageJ(description)
    ? layOutImageJ(file, all[0], description)
    : isShaped(description)
      ? layOutShaped(file, all, description)
      : null;
  if (described) return makeStack(file, described, all, described.pages);
  return layOutPages(file, all);
}

/** Pages without a description: those that are like the first one are slices. */
function layOutPages(file: TiffFile, all: readonly Directory[]): TiffStack {
  const slices = all.filter((page) => isSlicePage(file, page));
  const [first = all[0]] = slices;
  const key = keyOf(file, first);
  const alike = slices.length > 0 ? slices.filter((page) => keyOf(file, page) === key) : [first];
  const others = slices.length - alike.length;
  const layout: TiffLayout = {
    format: 'TIFF',
    slices: alike.length,
    times: 1,
    pageOf: (slice) => slice,
    spacing: null,
    timeStep: null,
    left:
      others > 0
        ? [`${others.toLocaleString('en')} page${others > 1 ? 's' : ''} of other sizes or numbers than the first one`]
        : [],
  };
  return makeStack(file, layout, alike);
}

/** @param count - of pages in the file, where all but the first have no directory of their own */
function makeStack(file: TiffFile, layout: TiffLayout, pages: readonly Directory[], count = pages.length): TiffStack {
  const index = layout.pageOf(0, 0) ?? 0;
  const page = readPage(file, pages[index] ?? pages[0]);
  checkPacking(page);
  const key = keyOf(file, page.directory);
  // ImageJ writes stacks of more than 4 GB so, and tifffile where it is asked to.
  const isOneAfterAnother = pages.length === 1 && count > 1 && page.compression === 1;
  const left = new Set<string>();
  if (page.colors === 'none' && page.samples > 1)
    left.add(page.samples > 2 ? `numbers 2 to ${page.samples} of each pixel` : 'number 2 of each pixel');
  return {
    file,
    layout,
    page,
    pages: isOneAfterAnother ? count : pages.length,
    use: { isRaw: layout.format === 'ImageJ TIFF', left },
    readPageAt: (at) => {
      if (isOneAfterAnother) return { ...page, shift: at * packedBytes(page) };
      const own = pages[at];
      if (keyOf(file, own) !== key)
        throw corruptFile(what, `has a page ${at + 1} of another size or other numbers than the first slice`);
      const next = readPage(file, own);
      checkPacking(next);
      return next;
    },
  };
}

/** Bytes of a page that is not packed. */
const packedBytes = ({ columns, rows, samples, bits }: TiffPage): number =>
  rows * Math.ceil((columns * samples * bits) / 8);
