// The numbers of a page.
import { bytesOfColors, combineChannels, describeAlpha, describeLoss, lumaOf } from '../base/channels.ts';
import { corruptFile } from '../base/file-problem.ts';
import { countSampleBytes } from '../base/count-sample-bytes.ts';
import { hostIsLittleEndian } from '../base/number-types.ts';
import { readHalfFloats } from '../base/half-floats.ts';
import { tags, what } from './tiff-file.ts';
import type { TiffFile } from './tiff-file.ts';
import type { TiffPage } from './tiff-page.ts';
import { unpackBlock } from './unpack-block.ts';

/** How the numbers of a page become one for each pixel. */
export interface PageUse {
  /** Whether numbers stand as they are where the page says that 0 is white, or has a table of colours. */
  readonly isRaw: boolean;
  /** What is lost is added here, in words. */
  readonly left: Set<string>;
}

export interface PageTarget {
  /** One number for each pixel: `pageBytes` long, in this machine's byte order. */
  readonly numbers: Uint8Array;
  /** The red, green and blue of each pixel, 0 to 255, where they are wanted. */
  readonly rgb?: Uint8Array;
}

/** Whether a page has colours that are shown. */
const isInColors = ({ colors, samples }: TiffPage, { isRaw }: PageUse): boolean =>
  (colors === 'RGB' && samples <= 4) || (colors === 'palette' && !isRaw);

/** Planes that are read of colours in planes: those of red, green and blue, and one that says how opaque a pixel is. */
const planesOf = ({ samples }: TiffPage): number => (samples === 4 ? 4 : 3);

/** Room for the colours of a number of pages; undefined where they have none. @throws {VolumeViewError} `format/too-large` */
export function allocateColors(
  { file: { budget }, page, use }: { file: TiffFile; page: TiffPage; use: PageUse },
  pages: number,
): Uint8Array<ArrayBuffer> | undefined {
  if (!isInColors(page, use)) return undefined;
  const pixels = page.columns * page.rows * pages;
  budget.take(bytesOfColors * pixels, 'the colours of the TIFF file');
  return new Uint8Array(3 * pixels);
}

/** The brightness of white. */
export const whiteOf = ({ colors, type }: TiffPage): number =>
  colors === 'RGB' && type.bytesPerSample === 2 ? 0xffff : 0xff;

/** Bytes of the numbers that are made of a page. @throws {VolumeViewError} `format/too-large` */
export const pageBytes = ({ columns, rows, type }: TiffPage): number => countSampleBytes(what, [columns, rows], type);

/**
 * Reads one number for each pixel.
 * @param to - where they are written
 * @throws {VolumeViewError} `format/corrupt`, `format/too-large`
 */
export function decodePage(file: TiffFile, page: TiffPage, to: PageTarget, use: PageUse): void {
  const { columns, rows, bits, samples, colors, isPlanar, blockColumns, blockRows } = page;
  const step = isPlanar ? 1 : samples;
  const planes = isPlanar && colors === 'RGB' ? planesOf(page) : 1;
  const rowNumbers = blockColumns * step;
  const rowBytes = Math.ceil((rowNumbers * bits) / 8);
  const planeBytes = countSampleBytes(what, [rowBytes, blockRows], { name: 'bytes', bytesPerSample: 1 });
  const [across, down] = [Math.ceil(columns / blockColumns), Math.ceil(rows / blockRows)];
  const { offsets, lengths } = listBlocks(file, page, across * down * (isPlanar ? samples : 1));
  // Up to four times as many bytes where small numbers become bytes, or colours lie apart.
  const taken = 6 * planes * planeBytes;
  file.budget.take(taken, 'a piece of a page');
  const blocks = Array.from({ length: planes }, () => new Uint8Array(planeBytes));
  const write = makeWriter(file, page, to, use);
  for (let block = 0; block < across * down; block++) {
    const [left, top] = [(block % across) * blockColumns, Math.floor(block / across) * blockRows];
    const height = Math.min(blockRows, rows - top);
    blocks.forEach((bytes, plane) => {
      const at = block + plane * across * down;
      // A piece without bytes is one of zeros, as GDAL writes it.
      if (offsets[at] === 0 && lengths[at] === 0) return void bytes.fill(0);
      const packed = file.slice(offsets[at] + (page.shift ?? 0), lengths[at], 'a piece of a page');
      const got = unpackBlock(packed, bytes, { page, rowNumbers, step }, file);
      if (got < height * rowBytes)
        throw corruptFile(
          what,
          `ends early: got ${got.toLocaleString('en')} bytes of a piece of a page; expected ${(height * rowBytes).toLocaleString('en')}. Copy the file again`,
        );
    });
    write(blocks, { left, top, width: Math.min(blockColumns, columns - left), height });
  }
  file.budget.giveBack(taken);
}

function listBlocks(
  file: TiffFile,
  { directory, isTiled, compression, rows, columns, bits, samples }: TiffPage,
  count: number,
): { offsets: number[]; lengths: number[] } {
  const [offsetTag, lengthTag] = isTiled ? [tags.tileOffsets, tags.tileBytes] : [tags.stripOffsets, tags.stripBytes];
  const offsets = file.numbers(directory, offsetTag);
  let lengths = file.numbers(directory, lengthTag);
  // Old programs leave out the length of a page that is one strip.
  if (lengths.length === 0 && count === 1 && compression === 1)
    lengths = [rows * Math.ceil((columns * bits * samples) / 8)];
  if (offsets.length < count || lengths.length < count)
    throw corruptFile(
      what,
      `lists ${Math.min(offsets.length, lengths.length).toLocaleString('en')} pieces of a page; expected ${count.toLocaleString('en')}`,
    );
  return { offsets, lengths };
}

interface BlockPlace {
  readonly left: number;
  readonly top: number;
  /** Of the part that lies in the page. */
  readonly width: number;
  readonly height: number;
}

type Writer = (blocks: readonly Uint8Array<ArrayBuffer>[], place: BlockPlace) => void;

/** What writes the numbers of a piece to their places. */
function makeWriter(file: TiffFile, page: TiffPage, to: PageTarget, use: PageUse): Writer {
  const { columns, bits, samples, isPlanar, blockColumns, type } = page;
  const size = type.bytesPerSample;
  const convert = makeConverter(file, page, { ...use, keepsColors: to.rgb !== undefined });
  const colorsOf = to.rgb && readColors(file, page);
  const toOne = (blocks: readonly Uint8Array<ArrayBuffer>[]): Uint8Array => {
    const numbers =
      bits < 8 ? spreadBits(blocks[0], page) : bits === 16 && size === 4 ? toFloats(blocks[0]) : blocks[0];
    return convert ? convert(bits < 8 ? [numbers] : blocks) : firstOf(numbers, isPlanar ? 1 : samples, size);
  };
  return (blocks, { left, top, width, height }) => {
    const numbers = toOne(blocks);
    for (let y = 0; y < height; y++) {
      const start = y * blockColumns * size;
      to.numbers.set(numbers.subarray(start, start + width * size), ((top + y) * columns + left) * size);
    }
    if (!to.rgb || !colorsOf) return;
    const colorAt = colorsOf(bits < 8 ? [spreadBits(blocks[0], page)] : blocks);
    for (let y = 0; y < height; y++)
      for (let x = 0; x < width; x++)
        for (let c = 0; c < 3; c++) to.rgb[3 * ((top + y) * columns + left + x) + c] = colorAt(y * blockColumns + x, c);
  };
}

/** The first number of each pixel. */
function firstOf(bytes: Uint8Array<ArrayBuffer>, step: number, size: number): Uint8Array {
  if (step === 1) return bytes;
  const first = new Uint8Array(bytes.length / step);
  for (let to = 0, from = 0; to < first.length; to += size, from += step * size)
    for (let byte = 0; byte < size; byte++) first[to + byte] = bytes[from + byte];
  return first;
}

const toFloats = (bytes: Uint8Array<ArrayBuffer>): Uint8Array<ArrayBuffer> =>
  new Uint8Array(readHalfFloats(bytes).buffer);

/** A byte for each number of 1, 2 or 4 bits; each row begins with a byte of its own. */
function spreadBits(
  bytes: Uint8Array<ArrayBuffer>,
  { bits, samples, isPlanar, blockColumns, blockRows }: TiffPage,
): Uint8Array<ArrayBuffer> {
  const rowNumbers = blockColumns * (isPlanar ? 1 : samples);
  const rowBytes = Math.ceil((rowNumbers * bits) / 8);
  const spread = new Uint8Array(rowNumbers * blockRows);
  for (let y = 0, to = 0; y < blockRows; y++) {
    for (let x = 0; x < rowNumbers; x++, to++) {
      const bit = x * bits;
      spread[to] = (bytes[y * rowBytes + (bit >> 3)] >> (8 - bits - (bit & 7))) & ((1 << bits) - 1);
    }
  }
  return spread;
}

type Converter = (blocks: readonly Uint8Array<ArrayBuffer>[]) => Uint8Array;

/** What makes brightness of a piece; null where its numbers stand as they are. */
function makeConverter(
  file: TiffFile,
  page: TiffPage,
  { isRaw, left, keepsColors }: PageUse & { readonly keepsColors: boolean },
): Converter | null {
  const { colors, samples, isPlanar, isInverted, type, bits } = page;
  const isWide = type.bytesPerSample === 2;
  const view = (bytes: Uint8Array<ArrayBuffer>): Uint8Array<ArrayBuffer> | Uint16Array<ArrayBuffer> =>
    isWide ? new Uint16Array(bytes.buffer, bytes.byteOffset, bytes.length / 2) : bytes;
  const bytesOf = ({ buffer, byteOffset, byteLength }: ArrayBufferView): Uint8Array =>
    new Uint8Array(buffer, byteOffset, byteLength);
  if (colors === 'RGB')
    return (blocks) => {
      const numbers = isPlanar ? interleave(blocks, type.bytesPerSample) : blocks[0];
      const channels = isPlanar ? planesOf(page) : samples;
      // The highest byte of a number is enough to know colours from gray.
      if (channels <= 4)
        (keepsColors ? describeAlpha : describeLoss)(
          isWide ? numbers.subarray(1) : numbers,
          channels,
          type.bytesPerSample,
        ).forEach((one) => left.add(one));
      return bytesOf(combineChannels(view(numbers), channels, 'gray'));
    };
  if (colors === 'palette') {
    if (isRaw) {
      left.add('the table of colours of the pages, which only gives them a look: their numbers are shown');
      return null;
    }
    const colorOf = readPalette(file, page);
    const table = Uint8Array.from({ length: 2 ** bits }, (_, i) => lumaOf(colorOf(i, 0), colorOf(i, 1), colorOf(i, 2)));
    if (!keepsColors) left.add('the colours of the pages: their brightness is shown (luma, Rec. ITU-R BT.709)');
    return ([bytes]) => {
      if (samples === 2)
        describeAlpha(isWide ? bytes.subarray(1) : bytes, samples, type.bytesPerSample).forEach((one) => left.add(one));
      const mapped = bytesOf(view(bytes).map((number) => table[number] ?? 0));
      return firstOf(new Uint8Array(mapped), samples, type.bytesPerSample);
    };
  }
  if (!isInverted || isRaw) return null;
  const top = 2 ** bits - 1;
  return ([bytes]) =>
    firstOf(
      new Uint8Array(bytesOf(view(bytes).map((number) => top - number))),
      isPlanar ? 1 : samples,
      type.bytesPerSample,
    );
}

/** The red, green and blue of a pixel of a piece, 0 to 255. @param blocks - a byte for each number below 8 bits */
function readColors(
  file: TiffFile,
  page: TiffPage,
): (blocks: readonly Uint8Array<ArrayBuffer>[]) => (pixel: number, c: number) => number {
  const { colors, samples, isPlanar, type } = page;
  const size = type.bytesPerSample;
  // Of numbers of 16 bits the high byte.
  const high = hostIsLittleEndian ? size - 1 : 0;
  if (colors !== 'palette')
    return (blocks) =>
      isPlanar
        ? (pixel, c) => blocks[c][pixel * size + high]
        : (pixel, c) => blocks[0][(pixel * samples + c) * size + high];
  const colorOf = readPalette(file, page);
  return ([bytes]) => {
    const numbers = size === 2 ? new Uint16Array(bytes.buffer, bytes.byteOffset, bytes.length / 2) : bytes;
    return (pixel, c) => Math.round(colorOf(numbers[pixel * samples], c));
  };
}

/** Red, green and blue of an entry, 0 to 255. Source: TIFF 6.0, ColorMap: all reds come first, of 16 bits */
function readPalette(file: TiffFile, { directory, bits }: TiffPage): (entry: number, c: number) => number {
  const entries = 2 ** bits;
  const map = file.numbers(directory, tags.colorMap);
  if (map.length < 3 * entries)
    throw corruptFile(what, `got a table of ${map.length} numbers for its colours; expected ${3 * entries}`);
  // Some programs write numbers of 8 bits.
  const unit = map.some((number) => number > 255) ? 257 : 1;
  return (entry, c) => map[c * entries + entry] / unit;
}

function interleave(blocks: readonly Uint8Array<ArrayBuffer>[], size: number): Uint8Array<ArrayBuffer> {
  const all = new Uint8Array(blocks.length * blocks[0].length);
  blocks.forEach((bytes, plane) => {
    for (let i = 0; i < bytes.length; i++)
      all[Math.floor(i / size) * size * blocks.length + plane * size + (i % size)] = bytes[i];
  });
  return all;
}
