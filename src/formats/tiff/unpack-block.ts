// The bytes of a strip or tile.
import { inflateSync } from 'fflate';
import { corruptFile, unsupportedFile } from '../base/file-problem.ts';
import { hostIsLittleEndian, swapBytes } from '../base/number-types.ts';
import { maxDeflateRatio } from '../codecs/gunzip.ts';
import { isZlib } from '../codecs/unzlib.ts';
import { unzstd } from '../codecs/unzstd.ts';
import { unpackLzw } from './lzw.ts';
import { unpackBits } from './pack-bits.ts';
import { what } from './tiff-file.ts';
import type { TiffFile } from './tiff-file.ts';
import type { TiffPage } from './tiff-page.ts';

/** How pieces may be packed. Sources: TIFF 6.0, and libtiff's tiff.h for the later ones */
const methods: Readonly<Record<number, string>> = {
  1: 'none',
  5: 'LZW',
  8: 'Deflate',
  32946: 'Deflate',
  32773: 'PackBits',
  34926: 'Zstandard',
  50000: 'Zstandard',
};

/** What an error says about the others. */
const refused: Readonly<Record<number, string>> = {
  2: 'CCITT fax',
  3: 'CCITT fax',
  4: 'CCITT fax',
  6: 'JPEG of the old kind',
  7: 'JPEG',
  33003: 'JPEG 2000',
  33005: 'JPEG 2000',
  34712: 'JPEG 2000',
  34887: 'LERC',
  34925: 'LZMA',
  50001: 'WebP',
  50002: 'JPEG XL',
  50003: 'PNG',
};

/** Checks that a page can be unpacked, before memory is used for it. @throws {VolumeViewError} `format/unsupported` */
export function checkPacking({ compression, predictor, type, bits, colors }: TiffPage): void {
  if (!(compression in methods))
    throw unsupportedFile(
      what,
      `is packed with ${refused[compression] ?? `method ${compression}`}; expected no packing, LZW, Deflate, PackBits or Zstandard. Convert it: bfconvert -compression LZW in.tif out.ome.tif`,
    );
  if (colors === 'YBR')
    throw unsupportedFile(what, 'is in colours of the kind YCbCr; convert it to RGB: tiff2rgba in.tif out.tif');
  const isFloat = type.read.kind === 'floats' && !type.complex;
  const isKnown =
    predictor === 1 || (predictor === 2 && bits >= 8 && bits <= 64 && !type.complex) || (predictor === 3 && isFloat);
  if (!isKnown)
    throw unsupportedFile(
      what,
      `has the predictor ${predictor} with numbers of ${bits} bits; expected 1, 2 for whole numbers or 3 for floats`,
    );
}

/** How the rows of a piece lie. */
export interface PageRows {
  readonly page: TiffPage;
  /** Numbers of a row. */
  readonly rowNumbers: number;
  /** Numbers of a pixel. */
  readonly step: number;
}

/**
 * Unpacks a piece of a page, and undoes its predictor.
 * @param out - row by row, all numbers of a pixel together, in this machine's byte order; rows that are missing are left as they are
 * @returns bytes written
 */
export function unpackBlock(
  packed: Uint8Array<ArrayBuffer>,
  out: Uint8Array<ArrayBuffer>,
  { page, rowNumbers, step }: PageRows,
  file: TiffFile,
): number {
  const { bits, predictor } = page;
  const written = unpack(packed, out, page, file);
  const filled = out.subarray(0, written);
  if (bits <= 8 && predictor === 1) return written;
  if (predictor === 3) {
    joinFloats(filled, rowNumbers, step, bits / 8);
    return written;
  }
  if (file.littleEndian !== hostIsLittleEndian) swapBytes(filled, page.type.complex ? bits / 16 : bits / 8);
  if (predictor === 2) addUp(filled, rowNumbers, step, bits);
  return written;
}

function unpack(
  packed: Uint8Array<ArrayBuffer>,
  out: Uint8Array<ArrayBuffer>,
  { compression }: TiffPage,
  { budget }: TiffFile,
): number {
  const damaged = (): Error =>
    corruptFile(what, `has packed pixels (${methods[compression]}) that are damaged; copy the file again`);
  switch (methods[compression]) {
    case 'LZW':
      budget.step(out.length / 16, 'the packed pixels');
      return unpackLzw(packed, out) ?? throwIt(damaged());
    case 'Zstandard': {
      const bytes = unzstd(packed, out.length, budget);
      out.set(bytes);
      return bytes.length;
    }
    case 'PackBits':
      budget.step(packed.length / 16, 'the packed pixels');
      return unpackBits(packed, out);
    case 'Deflate': {
      // No program packs so few bytes into so many; unpacking them would take long, for nothing.
      if (!isZlib(packed) || packed.length > 2 * out.length + 4096) throw damaged();
      budget.step((maxDeflateRatio * packed.length) / 16, 'the packed pixels');
      try {
        return inflateSync(packed.subarray(2), { out }).length;
      } catch {
        throw damaged();
      }
    }
    default: {
      const bytes = packed.subarray(0, out.length);
      out.set(bytes);
      return bytes.length;
    }
  }
}

function throwIt(error: Error): never {
  throw error;
}

const wholeNumbers = { 8: Uint8Array, 16: Uint16Array, 32: Uint32Array } as const;

/** Numbers that are differences to the pixel before. Source: TIFF 6.0, section 14 */
function addUp(bytes: Uint8Array<ArrayBuffer>, rowNumbers: number, step: number, bits: number): void {
  const { buffer, byteOffset } = bytes;
  const count = Math.floor((bytes.length * 8) / bits);
  if (bits === 64) {
    const numbers = new BigUint64Array(buffer, byteOffset, count);
    for (let row = 0; row < count; row += rowNumbers)
      for (let i = row + step; i < Math.min(count, row + rowNumbers); i++) numbers[i] += numbers[i - step];
    return;
  }
  const numbers = new wholeNumbers[bits as 8 | 16 | 32](buffer, byteOffset, count);
  for (let row = 0; row < count; row += rowNumbers)
    for (let i = row + step; i < Math.min(count, row + rowNumbers); i++) numbers[i] += numbers[i - step];
}

/**
 * Floats of which the highest bytes of a row come first, then the second ones, and so on; each is the difference to the one before.
 * Source: Adobe Photoshop TIFF Technical Note 3 (2005)
 */
function joinFloats(bytes: Uint8Array<ArrayBuffer>, rowNumbers: number, step: number, size: number): void {
  const rowBytes = rowNumbers * size;
  for (let start = 0; start + rowBytes <= bytes.length; start += rowBytes) {
    const row = bytes.subarray(start, start + rowBytes);
    for (let i = step; i < rowBytes; i++) row[i] += row[i - step];
    const apart = row.slice();
    for (let byte = 0; byte < size; byte++) {
      const place = hostIsLittleEndian ? size - 1 - byte : byte;
      for (let i = 0; i < rowNumbers; i++) row[i * size + place] = apart[byte * rowNumbers + i];
    }
  }
}
