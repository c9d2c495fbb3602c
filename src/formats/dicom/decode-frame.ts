// The numbers of one frame.
import type { Budget } from '../base/budget.ts';
import { corruptFile, unsupportedFile } from '../base/file-problem.ts';
import { hostIsLittleEndian, swapBytes } from '../base/number-types.ts';
import { applyPalette, samplesPerPixel, writeColors } from './colors.ts';
import { isJ2k, noLibraries } from './load-libraries.ts';
import type { Libraries } from './load-libraries.ts';
import type { Picture, StoredType } from './picture.ts';
import type { TransferSyntax } from './transfer-syntax.ts';
import { unpackRle } from './rle.ts';
import { unpackJ2k } from './unpack-j2k.ts';
import { unpackJpeg, unpackJpegColors } from './unpack-jpeg.ts';
import { joinPieces } from '../base/join-pieces.ts';

export type FrameNumbers =
  | Uint8Array
  | Int8Array
  | Uint16Array
  | Int16Array
  | Uint32Array
  | Int32Array
  | Float32Array
  | Float64Array;

export const arrayOf = {
  uint8: Uint8Array,
  int8: Int8Array,
  uint16: Uint16Array,
  int16: Int16Array,
  uint32: Uint32Array,
  int32: Int32Array,
  float32: Float32Array,
  float64: Float64Array,
} as const satisfies Record<StoredType, unknown>;

/** How packed pixels are that are read. */
const readable: ReadonlySet<string> = new Set<TransferSyntax['packing']>([
  'none',
  'RLE',
  'JPEG',
  'lossless JPEG',
  'JPEG-LS',
  'JPEG 2000',
  'HTJ2K',
]);

/** Checks that all frames of a picture are there, before memory is used for them. @throws {VolumeViewError} `format/corrupt`, `format/unsupported` */
export function checkFrames(picture: Picture): void {
  const { what, pixels, frames, syntax } = picture;
  const { packing } = syntax;
  if (!readable.has(packing)) {
    throw unsupportedFile(
      what,
      `is packed with ${packing === 'unknown' ? 'a method of its own' : packing}, which volume-view does not read; unpack all files of the series: gdcmconv --raw in.dcm out.dcm`,
    );
  }
  if (!pixels.bytes) {
    if (pixels.missing === 0 && pixels.fragments.length < frames)
      throw corruptFile(
        what,
        `ends early: got ${pixels.fragments.length} pieces of packed pixels; expected ${frames} or more, one for each frame`,
      );
    return;
  }
  if (packing !== 'none') throw corruptFile(what, `says that it is packed with ${packing}, and its pixels are not`);
  const wanted = Math.ceil(frames * frameBytes(picture));
  if (pixels.there >= wanted) return;
  throw corruptFile(
    what,
    `ends early: got ${pixels.there.toLocaleString('en')} bytes of pixels; ${frames} frame${frames > 1 ? 's' : ''} of ${picture.columns} x ${picture.rows} pixels of ${picture.bitsAllocated} bits need ${wanted.toLocaleString('en')}. Copy the file again`,
  );
}

/** @returns bytes of a frame that is not packed; of pairs of pixels, which share colours, a row has an even number */
export function frameBytes({ rows, columns, bitsAllocated, colors }: Picture): number {
  return (rows * columns * samplesPerPixel(colors) * bitsAllocated) / 8;
}

export interface DecodeFrameOptions {
  /** Those that its packing needs. */
  readonly libraries?: Libraries;
  /** Where the red, green and blue of each pixel are written, if it is in colours. */
  readonly rgb?: Uint8Array;
}

/**
 * The stored numbers of a frame, row by row: not to be changed, as they may be the file's own bytes.
 * @param frame - from 0
 */
export function decodeFrame(
  picture: Picture,
  frame: number,
  budget: Budget,
  { libraries = noLibraries, rgb }: DecodeFrameOptions = {},
): FrameNumbers {
  const { type, pixels, bitsAllocated, syntax, what, colors } = picture;
  const size = frameBytes(picture);
  const there = viewNumbers(picture, frame * size, budget);
  if (there) return there;
  // The frame, and what unpacking it takes.
  const taken = (isJ2k(picture) ? 16 : syntax.packing === 'JPEG' ? 6 : 3) * size;
  budget.take(taken, what);
  const bytes = new Uint8Array(size);
  const packed = pixels.bytes ? bytesOfFrame(picture, frame, size) : joinFragments(fragmentsOf(picture, frame));
  if (colors && colors.kind !== 'palette') {
    const gray = new Uint8Array(picture.rows * picture.columns);
    const isRle = syntax.packing === 'RLE';
    if (syntax.packing === 'none') copyNumbers(packed, bytes, picture);
    else if (isRle) unpackRle(packed, bytes, samplesPerPixel(colors), what);
    else if (libraries.j2k) bytes.set(unpackJ2k(packed, picture, libraries.j2k).numbers);
    const isRgb = syntax.packing === 'JPEG' ? unpackJpegColors(packed, picture, bytes, what) : null;
    // Runs are those of one colour after the other, and the unpacker puts the first one last.
    const written = isRgb === null ? colors : ({ kind: isRgb ? 'RGB' : 'YBR', isPlanar: false } as const);
    writeColors(bytes, written, { gray, rgb }, isRle);
    budget.giveBack(taken);
    return gray;
  }
  const numbers = new arrayOf[type](bytes.buffer, 0, picture.rows * picture.columns);
  let precision = 0;
  if (syntax.packing === 'none') copyNumbers(packed, bytes, picture);
  else if (syntax.packing === 'RLE') {
    unpackRle(packed, bytes, bitsAllocated / 8, what);
    if (!hostIsLittleEndian) swapBytes(bytes, bitsAllocated / 8);
  } else {
    const unpacked =
      libraries.j2k && isJ2k(picture)
        ? unpackJ2k(packed, picture, libraries.j2k)
        : unpackJpeg(packed, picture, what, libraries.ls);
    numbers.set(unpacked.numbers);
    if (syntax.isLossy) precision = unpacked.precision;
  }
  if (isTrimmed(picture)) trimBits(numbers, numbers, picture, precision);
  if (colors) applyPalette({ gray: numbers, rgb }, colors);
  budget.giveBack(taken);
  return numbers;
}

/** Numbers that need no more than to be looked at, or to be trimmed; null for others. @param start - of the frame, in the pixels */
function viewNumbers(picture: Picture, start: number, budget: Budget): FrameNumbers | null {
  const { type, pixels, bitsAllocated, syntax, colors, what } = picture;
  const isAsHere = bitsAllocated > 8 ? pixels.littleEndian === hostIsLittleEndian : pixels.littleEndian;
  if (syntax.packing !== 'none' || colors || !pixels.bytes || !isAsHere) return null;
  const { buffer, byteOffset, length } = pixels.bytes;
  const count = picture.rows * picture.columns;
  const [at, bytes] = [byteOffset + start, (count * bitsAllocated) / 8];
  if (at % (bitsAllocated / 8) !== 0 || start + bytes > length) return null;
  const numbers = new arrayOf[type](buffer, at, count);
  if (!isTrimmed(picture)) return numbers;
  budget.take(bytes, what);
  const trimmed = new arrayOf[type](count);
  trimBits(numbers, trimmed, picture);
  budget.giveBack(bytes);
  return trimmed;
}

function copyNumbers(from: Uint8Array, bytes: Uint8Array, { pixels, bitsAllocated, what }: Picture): void {
  if (from.length < bytes.length)
    throw corruptFile(what, `ends early: got ${from.length} bytes of a frame; expected ${bytes.length}`);
  bytes.set(from.subarray(0, bytes.length));
  if (bitsAllocated > 8 && pixels.littleEndian !== hostIsLittleEndian) swapBytes(bytes, bitsAllocated / 8);
}

/** Whether bytes lie in words of 16 bits of big endian: two change places. Source: PS3.5, 8.1.1 and annex A.3 */
export const isInPairs = ({ bitsAllocated, pixels }: Picture): boolean =>
  bitsAllocated === 8 && pixels.vr === 'OW' && !pixels.littleEndian;

/** Bytes of a frame in their order. Of pairs the other byte may lie in the next frame, or behind the last one. */
function bytesOfFrame(picture: Picture, frame: number, size: number): Uint8Array {
  const bytes = picture.pixels.bytes!;
  const start = frame * size;
  if (!isInPairs(picture)) return bytes.subarray(start, start + size);
  const { length } = bytes.subarray(start, start + size);
  return Uint8Array.from({ length }, (_, i) => bytes[(start + i) ^ 1]);
}

const joinFragments = (pieces: readonly Uint8Array[]): Uint8Array =>
  pieces.length === 1 ? pieces[0] : joinPieces(pieces);

/**
 * A frame may lie in several pieces: where it begins is said in bytes, or by the mark with which a packed picture begins, or there is
 * one piece for each frame, or one frame.
 * @throws {VolumeViewError} `format/corrupt`
 */
export function fragmentsOf(
  { pixels: { fragments, offsets }, frames, what }: Picture,
  frame: number,
): readonly Uint8Array<ArrayBuffer>[] {
  if (fragments.length === frames) return [fragments[frame]];
  let mine = fragments;
  if (frames > 1) {
    if (offsets.length < frames) {
      const starts = [...fragments.keys()].filter((i) => beginsPicture(fragments[i]));
      if (starts.length === frames && starts[0] === 0) return fragments.slice(starts[frame], starts[frame + 1]);
      throw corruptFile(
        what,
        `has ${fragments.length} pieces of packed pixels for ${frames} frames, and does not say where each begins`,
      );
    }
    const [start, end] = [offsets[frame], offsets[frame + 1] ?? Infinity];
    let at = 0;
    mine = fragments.filter(({ length }) => {
      const place = at;
      at += 8 + length;
      return place >= start && place < end;
    });
  }
  return mine;
}

/**
 * The marks that no packed picture has in its midst: of JPEG and JPEG-LS, of JPEG 2000, and of JPEG 2000 in a file of its own.
 * Source: ISO/IEC 10918-1, B.1.1; 15444-1, A.4 and I.5.1
 */
const firstBytes = [
  [0xff, 0xd8, 0xff],
  [0xff, 0x4f, 0xff, 0x51],
  [0, 0, 0, 0x0c, 0x6a, 0x50, 0x20, 0x20],
];

const beginsPicture = (piece: Uint8Array): boolean =>
  firstBytes.some((mark) => mark.every((byte, i) => piece[i] === byte));

/** Whether bits above and below a number belong to something else, such as overlays. Source: PS3.5, 8.1.1 */
const isTrimmed = ({ bitsAllocated, bitsStored, type }: Picture): boolean =>
  bitsStored < bitsAllocated && !type.startsWith('float');

/**
 * @param precision - bits of an unpacked number whose packing is lossy: where it goes above the bits of the file, it is too large by an
 * error of the packing, as next to metal, and without its highest bits it would be small. pydicom and GDCM keep it too.
 */
function trimBits(from: FrameNumbers, to: FrameNumbers, { bitsStored, shift, isSigned }: Picture, precision = 0): void {
  const above = 32 - Math.max(bitsStored + shift, precision);
  for (let i = 0; i < from.length; i++) {
    const up = from[i] << above;
    to[i] = isSigned ? up >> (above + shift) : up >>> (above + shift);
  }
}
