// What a page says of its numbers.
import { corruptFile, unsupportedFile } from '../base/file-problem.ts';
import { floats, numberTypes, viewAs } from '../base/number-types.ts';
import type { NumberType } from '../base/number-types.ts';
import { tags, what } from './tiff-file.ts';
import type { Directory, TiffFile } from './tiff-file.ts';

export interface TiffPage {
  readonly directory: Directory;
  readonly columns: number;
  readonly rows: number;
  /** Of the numbers that are made of it: those of 1, 2 and 4 bits become 8 bits, half floats become floats. */
  readonly type: NumberType;
  /** Of a number in the file. */
  readonly bits: number;
  /** Numbers of a pixel. */
  readonly samples: number;
  readonly colors: 'none' | 'RGB' | 'YBR' | 'palette';
  /** Whether 0 is white. */
  readonly isInverted: boolean;
  /** Whether the first numbers of all pixels come first, then the second ones. */
  readonly isPlanar: boolean;
  readonly isTiled: boolean;
  /** The size of a strip or tile. */
  readonly blockColumns: number;
  readonly blockRows: number;
  readonly compression: number;
  readonly predictor: number;
  /** Bytes that its numbers lie behind those of its directory; nothing if absent. */
  readonly shift?: number;
}

/** Source: TIFF 6.0, section 8, SampleFormat (339): 1 unsigned, 2 signed, 3 float, 5 and 6 complex; libtiff for the last two */
const types: Readonly<Record<string, NumberType>> = {
  '1:1': numberTypes.uint8,
  '1:2': numberTypes.uint8,
  '1:4': numberTypes.uint8,
  '1:8': numberTypes.uint8,
  '1:16': numberTypes.uint16,
  '1:32': numberTypes.uint32,
  '1:64': numberTypes.uint64,
  '2:8': numberTypes.int8,
  '2:16': numberTypes.int16,
  '2:32': numberTypes.int32,
  '2:64': numberTypes.int64,
  '3:16': numberTypes.float32,
  '3:32': numberTypes.float32,
  '3:64': numberTypes.float64,
  '6:64': floats('complex64', 4, viewAs(Float32Array), true),
  '6:128': floats('complex128', 8, viewAs(Float64Array), true),
};

const advice = 'Convert it with tifffile, or with Bio-Formats: bfconvert -compression LZW in.tif out.ome.tif';

/** Reduced copies of a page, and masks, are not slices. Source: TIFF 6.0, NewSubfileType */
export function isSlicePage(file: TiffFile, directory: Directory): boolean {
  return ((file.number(directory, tags.kind) ?? 0) & 5) === 0;
}

/** What pages have in common that are slices of one volume. */
export function keyOf(file: TiffFile, directory: Directory): string {
  const keys = [tags.columns, tags.rows, tags.bits, tags.samples, tags.format];
  return keys.map((tag) => file.number(directory, tag) ?? 1).join(' ');
}

/** @throws {VolumeViewError} `format/corrupt`, `format/unsupported` */
export function readPage(file: TiffFile, directory: Directory): TiffPage {
  const one = (tag: number, usual: number): number => file.number(directory, tag) ?? usual;
  const [columns, rows, samples] = [one(tags.columns, 0), one(tags.rows, 0), one(tags.samples, 1)];
  if (![columns, rows, samples].every((n) => Number.isSafeInteger(n) && n >= 1) || samples > 0xffff)
    throw corruptFile(
      what,
      `got ${columns} columns and ${rows} rows of ${samples} numbers; expected whole numbers from 1`,
    );
  refuseOthers(file, directory);
  const depths = new Set(file.numbers(directory, tags.bits));
  const formats = new Set(file.numbers(directory, tags.format));
  const [bits = 1] = depths;
  const [format = 1] = formats;
  // 4 is "undefined", which is taken as unsigned.
  const type = types[`${format === 4 ? 1 : format}:${bits}`];
  if (!type || depths.size > 1 || formats.size > 1)
    throw unsupportedFile(
      what,
      `holds numbers of ${[...depths].slice(0, 4).join(' and ')} bits (format ${[...formats].slice(0, 4).join(' and ') || 1}); expected whole numbers of 1, 2, 4, 8, 16, 32 or 64 bits, or floats of 16, 32 or 64. ${advice}`,
    );
  const photometric = one(tags.photometric, 1);
  if (![0, 1, 2, 3, 6].includes(photometric))
    throw unsupportedFile(
      what,
      `is in colours of kind ${photometric} (PhotometricInterpretation); expected gray, RGB or a table of colours. ${advice}`,
    );
  const isTiled = directory.has(tags.tileOffsets);
  const rowsPerStrip = one(tags.rowsPerStrip, rows);
  const [blockColumns, blockRows] = isTiled
    ? [one(tags.tileColumns, 0), one(tags.tileRows, 0)]
    : [columns, Math.min(rows, rowsPerStrip)];
  if (![blockColumns, blockRows].every((n) => Number.isSafeInteger(n) && n >= 1))
    throw corruptFile(what, `got pieces of ${blockColumns} x ${blockRows} pixels; expected whole numbers from 1`);
  const isPlanar = samples > 1 && one(tags.planar, 1) === 2;
  return {
    directory,
    columns,
    rows,
    type,
    bits,
    samples,
    colors: readColors(photometric, samples, type, { bits, isPlanar }),
    isInverted: photometric === 0 && format === 1 && bits <= 16,
    isPlanar,
    isTiled,
    blockColumns,
    blockRows,
    compression: one(tags.compression, 1),
    predictor: one(tags.predictor, 1),
  };
}

function readColors(
  photometric: number,
  samples: number,
  type: NumberType,
  { bits, isPlanar }: Pick<TiffPage, 'bits' | 'isPlanar'>,
): TiffPage['colors'] {
  const isByte = type.name === 'uint8' && bits === 8;
  // A second number says how opaque a pixel is.
  const hasTable = samples === 1 || (samples === 2 && bits >= 8 && !isPlanar);
  if (photometric === 3 && hasTable && (type.name === 'uint8' || type.name === 'uint16')) return 'palette';
  if (photometric === 2 && samples >= 3 && (isByte || type.name === 'uint16')) return 'RGB';
  return photometric === 6 && samples === 3 && isByte ? 'YBR' : 'none';
}

/** Files that other entries make something else than a list of pages. */
function refuseOthers(file: TiffFile, directory: Directory): void {
  if (directory.has(tags.metaMorph) || directory.has(tags.lsm))
    throw unsupportedFile(
      what,
      'is one of MetaMorph (.stk) or Zeiss (.lsm), which describe their pages in a form of their own; convert it to OME-TIFF: bfconvert in.lsm out.ome.tif',
    );
  if ((file.number(directory, tags.depth) ?? 1) > 1)
    throw unsupportedFile(what, `holds a volume in one page (ImageDepth); expected a page for each slice. ${advice}`);
  if ((file.number(directory, tags.fillOrder) ?? 1) !== 1)
    throw unsupportedFile(what, `has bits in reverse order (FillOrder 2). ${advice}`);
}
