// The structure of a TIFF file: pages, each with a directory of entries. Sources: TIFF 6.0 (Adobe, 1992), BigTIFF (libtiff)
//
// Why not geotiff 3.0.5: it never ends on pages that lead back to themselves, takes 4 GB for a list that a file of 118 bytes announces,
// unpacks pieces without a limit, and all pieces of a page at once. To guard it, this file would be needed too; then it adds 280 kB
// (with LERC, WebAssembly and its workers), takes 1.6 to 1.9 times as long, and lacks whole numbers of 64 bits.
import type { Budget } from '../base/budget.ts';
import { corruptFile } from '../base/file-problem.ts';

export const what = 'the TIFF file';

/** What a directory says of one thing. */
export interface Entry {
  readonly type: number;
  readonly count: number;
  /** Where its values begin. */
  readonly at: number;
}

/** The entries of a page that are used here, by their number. */
export type Directory = ReadonlyMap<number, Entry>;

/** The entries that are used. */
export const tags = {
  kind: 254,
  columns: 256,
  rows: 257,
  bits: 258,
  compression: 259,
  photometric: 262,
  fillOrder: 266,
  description: 270,
  stripOffsets: 273,
  samples: 277,
  rowsPerStrip: 278,
  stripBytes: 279,
  xResolution: 282,
  yResolution: 283,
  planar: 284,
  resolutionUnit: 296,
  predictor: 317,
  colorMap: 320,
  tileColumns: 322,
  tileRows: 323,
  tileOffsets: 324,
  tileBytes: 325,
  format: 339,
  jpegTables: 347,
  depth: 32997,
  /** Of MetaMorph and of Zeiss, which say in a form of their own what their pages are. */
  metaMorph: 33629,
  lsm: 34412,
} as const;

const known: ReadonlySet<number> = new Set(Object.values(tags));

/** Bytes of a value of each type. */
const sizes: Readonly<Record<number, number>> = {
  1: 1, // BYTE
  2: 1, // ASCII
  3: 2, // SHORT
  4: 4, // LONG
  5: 8, // RATIONAL
  6: 1, // SBYTE
  7: 1, // UNDEFINED
  8: 2, // SSHORT
  9: 4, // SLONG
  10: 8, // SRATIONAL
  11: 4, // FLOAT
  12: 8, // DOUBLE
  13: 4, // IFD
  16: 8, // LONG8
  17: 8, // SLONG8
  18: 8, // IFD8
};

/** More than any microscope writes, and few enough to list. */
const maxPages = 2 ** 17;

/** What a directory takes in memory. */
const directoryBytes = 2048;

/** A file whose structure is read when it is asked for. All of its methods throw {VolumeViewError} `format/corrupt` and `format/too-large`. */
export class TiffFile {
  readonly littleEndian: boolean;
  readonly #isBig: boolean;
  readonly #view: DataView;

  constructor(
    readonly bytes: Uint8Array<ArrayBuffer>,
    readonly budget: Budget,
  ) {
    this.#view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    this.littleEndian = bytes[0] === 0x49;
    this.#isBig = this.#u16(2) === 43;
  }

  /** The directories of all pages, in their order. */
  readDirectories(): Directory[] {
    const [head, next] = this.#isBig ? [8, 8] : [2, 4];
    if (this.#isBig && (this.#u16(4) !== 8 || this.#u16(6) !== 0))
      throw corruptFile(what, `got addresses of ${this.#u16(4)} bytes; expected 8`);
    const list: Directory[] = [];
    const seen = new Set<number>();
    for (let at = this.#address(this.#isBig ? 8 : 4); at !== 0;) {
      if (seen.has(at)) throw corruptFile(what, 'has pages that lead back to an earlier one; the file is damaged');
      seen.add(at);
      if (list.length === maxPages)
        throw corruptFile(what, `has more than ${maxPages.toLocaleString('en')} pages; expected fewer`);
      const count = this.#isBig ? this.#address(at) : this.#u16(at);
      const [start, size] = [at + head, this.#isBig ? 20 : 12];
      this.#need(start, count * size + next);
      this.budget.take(directoryBytes, 'a page of the TIFF file');
      this.budget.step(count, 'a page of the TIFF file');
      list.push(this.#readDirectory(start, count, size));
      at = this.#address(start + count * size);
    }
    if (list.length === 0) throw corruptFile(what, 'has no pages; expected one for each slice');
    return list;
  }

  /** The numbers of an entry; none where the page does not have it. Of fractions, numerator and denominator follow each other. */
  numbers(directory: Directory, tag: number): number[] {
    const entry = directory.get(tag);
    if (!entry) return [];
    const { type, count, at } = entry;
    this.budget.step(count, 'a list of the TIFF file');
    this.budget.take(8 * count, 'a list of the TIFF file');
    this.budget.giveBack(8 * count);
    const isFraction = type === 5 || type === 10;
    const size = isFraction ? 4 : sizes[type];
    return Array.from({ length: isFraction ? 2 * count : count }, (_, i) => this.#number(type, at + i * size));
  }

  /** The first number of an entry. */
  number(directory: Directory, tag: number): number | undefined {
    const entry = directory.get(tag);
    return entry && entry.count > 0 ? this.#number(entry.type, entry.at) : undefined;
  }

  /** A text up to its first 0: UTF-8, or Latin-1 as older programs write it. */
  text(directory: Directory, tag: number): string {
    const bytes = this.part(directory, tag);
    this.budget.take(2 * bytes.length, 'a text of the TIFF file');
    this.budget.giveBack(2 * bytes.length);
    const end = bytes.indexOf(0);
    const text = end < 0 ? bytes : bytes.subarray(0, end);
    try {
      return new TextDecoder('utf-8', { fatal: true }).decode(text);
    } catch {
      return new TextDecoder('latin1').decode(text);
    }
  }

  /** The bytes of an entry. */
  part(directory: Directory, tag: number): Uint8Array {
    const entry = directory.get(tag);
    return entry ? this.bytes.subarray(entry.at, entry.at + entry.count * sizes[entry.type]) : new Uint8Array();
  }

  /** Bytes of the file. @param of - what has them, for messages */
  slice(at: number, length: number, of: string): Uint8Array<ArrayBuffer> {
    if (at >= 0 && length >= 0 && at + length <= this.bytes.length) return this.bytes.subarray(at, at + length);
    throw corruptFile(
      what,
      `ends early: got ${this.bytes.length.toLocaleString('en')} bytes; ${of} needs ${length.toLocaleString('en')} from ${at.toLocaleString('en')} on. Copy the file again`,
    );
  }

  #readDirectory(start: number, count: number, size: number): Directory {
    const directory = new Map<number, Entry>();
    for (let i = 0; i < count; i++) {
      const at = start + i * size;
      const tag = this.#u16(at);
      if (!known.has(tag)) continue;
      const type = this.#u16(at + 2);
      const values = this.#isBig ? this.#address(at + 4) : this.#view.getUint32(at + 4, this.littleEndian);
      if (!(type in sizes))
        throw corruptFile(what, `got the type ${type} for entry ${tag} of a page; expected 1 to 18`);
      const length = values * sizes[type];
      const own = at + (this.#isBig ? 12 : 8);
      const from = length <= (this.#isBig ? 8 : 4) ? own : this.#address(own);
      this.#need(from, length);
      directory.set(tag, { type, count: values, at: from });
    }
    return directory;
  }

  #number(type: number, at: number): number {
    const little = this.littleEndian;
    switch (type) {
      case 3:
        return this.#view.getUint16(at, little);
      case 4:
      case 5:
      case 13:
        return this.#view.getUint32(at, little);
      case 6:
        return this.#view.getInt8(at);
      case 8:
        return this.#view.getInt16(at, little);
      case 9:
      case 10:
        return this.#view.getInt32(at, little);
      case 11:
        return this.#view.getFloat32(at, little);
      case 12:
        return this.#view.getFloat64(at, little);
      case 16:
      case 18:
        return Number(this.#view.getBigUint64(at, little));
      case 17:
        return Number(this.#view.getBigInt64(at, little));
      default:
        return this.#view.getUint8(at);
    }
  }

  #u16(at: number): number {
    this.#need(at, 2);
    return this.#view.getUint16(at, this.littleEndian);
  }

  /** A place in the file, or a number of things in it. */
  #address(at: number): number {
    this.#need(at, this.#isBig ? 8 : 4);
    return this.#isBig
      ? Number(this.#view.getBigUint64(at, this.littleEndian))
      : this.#view.getUint32(at, this.littleEndian);
  }

  #need(at: number, length: number): void {
    this.slice(at, length, 'its list of pages');
  }
}
