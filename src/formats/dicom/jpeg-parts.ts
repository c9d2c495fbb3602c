// The parts of a JPEG or JPEG-LS stream before its packed pixels. Sources: ITU-T T.81, annex B, and T.87, annex C
import { corruptFile, unsupportedFile } from '../base/file-problem.ts';
import { makeHuffmanTable } from './jpeg-huffman.ts';
import type { HuffmanTable } from './jpeg-huffman.ts';

/** One of the colours of a stream, or its gray. */
export interface JpegComponent {
  /** How many blocks of it a piece of the picture has, across and down. */
  readonly across: number;
  readonly down: number;
  /** The tables that the scan uses; null where it uses none. */
  readonly first: HuffmanTable | null;
  readonly others: HuffmanTable | null;
  /** Factors of the 64 coefficients, in their order in the stream. */
  readonly factors: Uint16Array | null;
}

/** A stream of one scan. */
export interface JpegParts {
  readonly bytes: Uint8Array;
  /** Where the packed pixels begin. */
  readonly start: number;
  readonly coding: 'DCT' | 'lossless' | 'LS';
  /** Bits of a number. */
  readonly precision: number;
  readonly rows: number;
  readonly columns: number;
  /** One; of JPEG with loss, also three. */
  readonly components: readonly JpegComponent[];
  /** Whether the stream says that its three numbers are red, green and blue (true), or brightness and two colours (false); else null. */
  readonly isRgb: boolean | null;
  /** Numbers, or blocks, after which the coder starts again; 0 for never. */
  readonly restart: number;
  /** Three numbers of the scan: a predictor or the limit of errors, then what depends on the coding. */
  readonly selected: readonly [number, number, number];
  /** Of JPEG-LS: MAXVAL, T1, T2, T3 and RESET; 0 for the usual one. */
  readonly presets: readonly number[];
  /** For messages. */
  readonly what: string;
}

const codings: Readonly<Record<number, JpegParts['coding']>> = {
  0xc0: 'DCT',
  0xc1: 'DCT',
  0xc3: 'lossless',
  0xf7: 'LS',
};

/** @throws {VolumeViewError} `format/corrupt`, `format/unsupported` */
export function readJpegParts(bytes: Uint8Array, what: string): JpegParts {
  const damaged = (): Error => corruptFile(what, 'has packed pixels (JPEG) that are damaged; copy the file again');
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const tables: HuffmanTable[] = [];
  const factors: Uint16Array[] = [];
  let frame: Frame | null = null;
  let [isJfif, isRgb]: [boolean, boolean | null] = [false, null];
  let restart = 0;
  let presets: readonly number[] = [0, 0, 0, 0, 0];
  if (bytes.length < 4 || view.getUint16(0) !== 0xffd8) throw damaged();
  for (let at = 2; at + 4 <= bytes.length;) {
    if (bytes[at] !== 0xff) throw damaged();
    const marker = bytes[at + 1];
    if (marker === 0xff) {
      at++;
      continue;
    }
    const [from, end] = [at + 4, at + 2 + view.getUint16(at + 2)];
    if (end > bytes.length || end < from) throw damaged();
    at = end;
    const part = bytes.subarray(from, end);
    if (marker in codings) {
      if (part.length < 9 || frame) throw damaged();
      frame = readFrame(part, codings[marker]);
      const { coding, listed } = frame;
      if (listed.length !== 1 && !(listed.length === 3 && coding === 'DCT'))
        throw unsupportedFile(
          what,
          `has packed pixels (${coding === 'LS' ? 'JPEG-LS' : coding === 'lossless' ? 'lossless JPEG' : 'JPEG'}) of ${listed.length} numbers each; expected gray values${coding === 'DCT' ? ', or three colours' : ''}`,
        );
    } else if (marker === 0xc4) readHuffmanTables(part, tables, damaged);
    else if (marker >= 0xc0 && marker <= 0xcf && marker !== 0xc8) {
      throw unsupportedFile(
        what,
        'is packed with a rare kind of JPEG (progressive or arithmetic); unpack it: dcmdjpeg in.dcm out.dcm',
      );
    } else if (marker === 0xdb) readFactors(part, factors, damaged);
    else if (marker === 0xdd && part.length >= 2) restart = view.getUint16(from);
    else if (marker === 0xe0 && hasName(part, 'JFIF')) isJfif = true;
    else if (marker === 0xee && part.length >= 12 && hasName(part, 'Adobe')) isRgb = part[11] === 0;
    else if (marker === 0xf8) {
      if (part[0] !== 1 || part.length < 11)
        throw unsupportedFile(what, 'is packed with JPEG-LS with tables; unpack it: gdcmconv --raw in.dcm out.dcm');
      presets = [0, 1, 2, 3, 4].map((i) => view.getUint16(from + 1 + 2 * i));
    } else if (marker === 0xda) {
      const count = part[0];
      if (!frame || part.length < 4 + 2 * count || count < 1 || count > frame.listed.length) throw damaged();
      if (count < frame.listed.length)
        throw unsupportedFile(what, 'is packed with JPEG colour by colour; unpack it: dcmdjpeg in.dcm out.dcm');
      const { listed, ...rest } = frame;
      if (!(rest.precision >= 2 && rest.precision <= 16)) throw damaged();
      return {
        ...rest,
        bytes,
        start: end,
        components: listed.map(({ across, down, factors: used }, i) => ({
          across,
          down,
          first: tables[part[2 + 2 * i] >> 4] ?? null,
          others: tables[4 + (part[2 + 2 * i] & 15)] ?? null,
          factors: factors[used] ?? null,
        })),
        isRgb: isJfif ? false : (isRgb ?? guessColors(listed)),
        restart,
        selected: [part[1 + 2 * count], part[2 + 2 * count], part[3 + 2 * count]],
        presets,
        what,
      };
    }
  }
  throw damaged();
}

const hasName = (part: Uint8Array, name: string): boolean =>
  String.fromCharCode(...part.subarray(0, name.length)) === name;

/** Files of JFIF have brightness and two colours. Of others the names of the three say it, or that they are of different sizes. Source: ITU-T T.871, 6.1 */
function guessColors(listed: Frame['listed']): boolean | null {
  if (listed.map(({ id }) => String.fromCharCode(id)).join('') === 'RGB') return true;
  const [{ across, down }] = listed;
  return listed.every((one) => one.across === across && one.down === down) ? null : false;
}

interface Frame extends Pick<JpegParts, 'coding' | 'precision' | 'rows' | 'columns'> {
  readonly listed: readonly (Pick<JpegComponent, 'across' | 'down'> & {
    readonly id: number;
    /** Which list of factors it has. */
    readonly factors: number;
  })[];
}

/** @param part - 9 bytes or more */
function readFrame(part: Uint8Array, coding: JpegParts['coding']): Frame {
  const count = Math.min(part[5], Math.floor((part.length - 6) / 3));
  return {
    coding,
    precision: part[0],
    rows: part[1] * 256 + part[2],
    columns: part[3] * 256 + part[4],
    listed: Array.from({ length: count }, (_, i) => ({
      id: part[6 + 3 * i],
      across: part[7 + 3 * i] >> 4,
      down: part[7 + 3 * i] & 15,
      factors: part[8 + 3 * i],
    })),
  };
}

function readHuffmanTables(part: Uint8Array, tables: HuffmanTable[], damaged: () => Error): void {
  for (let at = 0; at + 17 <= part.length;) {
    const [kind, place] = [part[at] >> 4, part[at] & 15];
    const counts = part.subarray(at + 1, at + 17);
    const total = counts.reduce((sum, count) => sum + count, 0);
    at += 17;
    if (kind > 1 || place > 3 || at + total > part.length) throw damaged();
    const table = makeHuffmanTable(counts, part.subarray(at, at + total));
    if (!table) throw damaged();
    tables[4 * kind + place] = table;
    at += total;
  }
}

function readFactors(part: Uint8Array, factors: Uint16Array[], damaged: () => Error): void {
  for (let at = 0; at < part.length;) {
    const [size, place] = [part[at] >> 4 ? 2 : 1, part[at] & 15];
    at++;
    if (place > 3 || at + 64 * size > part.length) throw damaged();
    factors[place] = Uint16Array.from({ length: 64 }, (_, i) =>
      size === 2 ? part[at + 2 * i] * 256 + part[at + 2 * i + 1] : part[at + i],
    );
    at += 64 * size;
  }
}
