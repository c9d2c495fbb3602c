// What one file says of its pixels: their size, their numbers, and how they are packed.
import { corruptFile, unsupportedFile } from '../base/file-problem.ts';
import type { FramePlaces } from '../base/scan-data.ts';
import { readColors } from './colors.ts';
import type { Colors } from './colors.ts';
import type { DataSet } from './data-set.ts';
import type { DicomFile } from './read-file.ts';
import type { PixelElement } from './read-elements.ts';
import { segmentations, tags } from './tags.ts';
import type { TransferSyntax } from './transfer-syntax.ts';

/** The type of stored numbers. */
export type StoredType = 'uint8' | 'int8' | 'uint16' | 'int16' | 'uint32' | 'int32' | 'float32' | 'float64';

/** The pixels of a file: one or several frames of the same size. */
export interface Picture {
  /** For messages: 'file 12 of 300'. */
  readonly what: string;
  readonly set: DataSet;
  readonly syntax: TransferSyntax;
  readonly pixels: PixelElement;
  /** Of the file, of which only the start was read; null where the pixels are here. */
  readonly url: string | null;
  /** Where its frames lie, which are read one by one; undefined where the file is read as a whole, or its frames are asked for by number. */
  readonly places?: FramePlaces;
  /** Its file: the URL of a file of a folder, or the bytes. */
  readonly file: string | Uint8Array<ArrayBuffer>;
  readonly rows: number;
  readonly columns: number;
  readonly frames: number;
  readonly type: StoredType;
  readonly bitsAllocated: number;
  readonly bitsStored: number;
  /** How many bits lie below those of a number. */
  readonly shift: number;
  readonly isSigned: boolean;
  /** Whether the smallest number is white. */
  readonly isInverted: boolean;
  /** Of a picture in colours, whose brightness is its numbers; null for gray. */
  readonly colors: Colors | null;
  /** Stored numbers from the first to the second one are no data. */
  readonly padding: readonly [number, number] | null;
}

/** More than any scanner writes, and few enough to list. */
const maxFrames = 2 ** 16;

/** Whether the numbers of a file are labels, and no values. */
export const isSegmentation = (set: DataSet): boolean => segmentations.has(set.text(tags.sopClass));

/** Source: PS3.6, annex A */
const structureSet = '1.2.840.10008.5.1.4.1.1.481.3';

/** Whether a file has contours (RTSTRUCT), and no pixels. */
export const isStructureSet = (set: DataSet): boolean => set.text(tags.sopClass) === structureSet;

/**
 * Reads how the pixels of a file lie in it.
 * @returns null for a file without pixels, such as a report
 * @throws {VolumeViewError} `format/unsupported`, `format/corrupt`
 */
export function readPicture({ set, pixels, syntax, file }: DicomFile, what: string): Picture | null {
  if (isStructureSet(set))
    throw unsupportedFile(
      what,
      'has contours (RTSTRUCT): they are shown over their scan by <volume-labels src="…">, in the <volume-view> of the scan, one file alone, on a DICOMweb server by the address of its instance',
    );
  if (!pixels) {
    // Reports and lists of files do not say how large a picture is.
    if (set.has(tags.rows) && set.has(tags.columns))
      throw corruptFile(what, 'says how large its picture is, and ends before it. Copy the file again');
    return null;
  }
  if (isSegmentation(set))
    throw unsupportedFile(
      what,
      'is a segmentation: its labels are shown over their scan by <volume-labels src="…">, in the <volume-view> of the scan, one file alone, on a DICOMweb server by the address of its instance',
    );
  checkTiles(set, what);
  const photometric = set.text(tags.photometric).toUpperCase() || 'MONOCHROME2';
  const samples = set.number(tags.samplesPerPixel) ?? 1;
  const isGray = samples === 1 && /^MONOCHROME[12]$/.test(photometric);
  const colors = isGray ? null : readColors(set, photometric, samples, syntax.packing);
  const bits = set.number(tags.bitsAllocated);
  if (!isGray && (!colors || (bits !== 8 && colors.kind !== 'palette')))
    throw unsupportedFile(
      what,
      `is in colours (${/^(RGB|PALETTE COLOR|YBR_[A-Z]{1,7}(_42[02])?)$/.test(photometric) ? photometric : `${say(samples)} numbers per pixel`}) in a form that is not read; expected gray values, or colours of 8 bits that are not packed with lossless JPEG or JPEG-LS. Unpack it: dcmdjpeg in.dcm out.dcm`,
    );
  const numbers = readNumbers(set, pixels, what);
  return {
    ...pictureOf({ set, pixels, syntax, file }, what, numbers),
    isInverted: photometric === 'MONOCHROME1',
    colors,
    padding: colors ? null : readPadding(set, numbers),
  };
}

/**
 * The frames of a scanned slide are tiles of one large picture. Source: PS3.3, C.8.12.4.1 and C.7.6.17.3
 * @throws {VolumeViewError} `format/unsupported` where there is more than one
 */
function checkTiles(set: DataSet, what: string): void {
  const [columns, rows] = [tags.totalColumns, tags.totalRows].map((tag) => set.number(tag) ?? 0);
  const isTiled = set.text(tags.dimensionOrganization).toUpperCase().startsWith('TILED');
  const isOne =
    (set.number(tags.frames) ?? 1) === 1 &&
    columns <= (set.number(tags.columns) ?? 0) &&
    rows <= (set.number(tags.rows) ?? 0);
  if (isOne || !(isTiled || columns > 0 || rows > 0)) return;
  throw unsupportedFile(
    what,
    `is a picture of ${say(columns)} x ${say(rows)} pixels in tiles, such as a slide of a microscope, and no volume; expected slices. Open it in a viewer of slides, or save a small level as a picture: vips openslideload in.dcm out.png --level 3`,
  );
}

/** The same for a segmentation, whose numbers are what they are, whatever colours it has for them. */
export function readLabelPicture({ set, pixels, syntax, file }: DicomFile, what: string): Picture {
  if (!pixels) throw corruptFile(what, 'is a segmentation without pixels; expected those of its segments');
  const isBits = set.number(tags.bitsAllocated) === 1;
  const numbers: Numbers = isBits
    ? { type: 'uint8', bitsAllocated: 1, bitsStored: 1, shift: 0, isSigned: false }
    : readNumbers(set, pixels, what);
  return {
    ...pictureOf({ set, pixels, syntax, file }, what, numbers),
    isInverted: false,
    colors: null,
    padding: isBits ? null : readPadding(set, numbers),
  };
}

/** What pictures of all kinds have. @throws {VolumeViewError} `format/corrupt` */
function pictureOf(
  { set, pixels, syntax, file }: Pick<DicomFile, 'set' | 'syntax' | 'file'> & Pick<Picture, 'pixels'>,
  what: string,
  numbers: Numbers,
): Omit<Picture, 'isInverted' | 'colors' | 'padding'> {
  return { what, set, syntax, pixels, url: null, file, ...readSize(set, what), ...numbers };
}

/** @throws {VolumeViewError} `format/corrupt` */
function readSize(set: DataSet, what: string): Pick<Picture, 'rows' | 'columns' | 'frames'> {
  const [rows, columns] = [tags.rows, tags.columns].map((tag) => set.number(tag) ?? NaN);
  if (![rows, columns].every((n) => Number.isInteger(n) && n >= 1 && n <= 0xffff))
    throw corruptFile(what, `got ${say(columns)} columns and ${say(rows)} rows; expected whole numbers from 1`);
  const frames = set.number(tags.frames) ?? 1;
  if (!(Number.isInteger(frames) && frames >= 1 && frames <= maxFrames))
    throw corruptFile(
      what,
      `got ${say(frames)} frames; expected a whole number from 1 to ${maxFrames.toLocaleString('en')}`,
    );
  return { rows, columns, frames };
}

type Numbers = Pick<Picture, 'type' | 'bitsAllocated' | 'bitsStored' | 'shift' | 'isSigned'>;

function readNumbers(set: DataSet, { numbers }: PixelElement, what: string): Numbers {
  if (numbers !== 'integers') {
    const bits = numbers === 'float32' ? 32 : 64;
    return { type: numbers, bitsAllocated: bits, bitsStored: bits, shift: 0, isSigned: true };
  }
  const allocated = set.number(tags.bitsAllocated) ?? NaN;
  if (![8, 16, 32].includes(allocated))
    throw unsupportedFile(
      what,
      `has ${say(allocated)} bits for a pixel; expected 8, 16 or 32. Convert it: gdcmconv --raw in.dcm out.dcm`,
    );
  const stored = set.number(tags.bitsStored) ?? allocated;
  const high = set.number(tags.highBit) ?? stored - 1;
  if (
    !(
      Number.isInteger(stored) &&
      stored >= 1 &&
      stored <= allocated &&
      Number.isInteger(high) &&
      high < allocated &&
      high >= stored - 1
    )
  )
    throw corruptFile(
      what,
      `says that ${say(stored)} bits up to bit ${say(high)} of ${allocated} are used; expected bits within those`,
    );
  const isSigned = set.number(tags.pixelRepresentation) === 1;
  return {
    type: `${isSigned ? 'int' : 'uint'}${allocated as 8 | 16 | 32}`,
    bitsAllocated: allocated,
    bitsStored: stored,
    shift: high + 1 - stored,
    isSigned,
  };
}

/** Padding is given in the type of the pixels, whatever the file calls it. Source: PS3.3, C.7.5.1.1.2 */
function readPadding(set: DataSet, { type, isSigned, bitsAllocated }: Numbers): readonly [number, number] | null {
  if (type === 'float32' || type === 'float64') return null;
  const read = (tag: (typeof tags)['paddingValue']): number | undefined => {
    const value = set.number(tag);
    if (value === undefined || !isSigned) return value;
    // As US, negative numbers of 16 bits look large.
    return value >= 2 ** (Math.min(16, bitsAllocated) - 1) ? value - 2 ** Math.min(16, bitsAllocated) : value;
  };
  const first = read(tags.paddingValue);
  if (first === undefined) return null;
  const last = read(tags.paddingLimit) ?? first;
  return [Math.min(first, last), Math.max(first, last)];
}

const say = (value: number): string => (Number.isNaN(value) ? 'no' : String(value));
