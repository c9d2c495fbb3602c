import { corruptFile } from '../base/file-problem.ts';
import type { UnpackLs } from '../codecs/charls.ts';
import { unpackColors, unpackDct } from './jpeg-dct.ts';
import { unpackLossless } from './jpeg-lossless.ts';
import { unpackLs } from './jpeg-ls.ts';
import { readJpegParts } from './jpeg-parts.ts';
import type { JpegParts } from './jpeg-parts.ts';
import type { Unpacked } from './unpack-j2k.ts';

const unpackers = { DCT: unpackDct, lossless: unpackLossless, LS: unpackLs } as const;

/** The size that a frame must have. */
interface FrameSize {
  readonly columns: number;
  readonly rows: number;
  readonly bitsAllocated: number;
}

/**
 * Unpacks a frame of JPEG (8 and 12 bits), lossless JPEG or JPEG-LS: which of them it is, the stream itself says.
 * @param charls - a faster way to unpack JPEG-LS; null where there is none
 * @throws {VolumeViewError} `format/corrupt`, `format/unsupported`
 */
export function unpackJpeg(
  packed: Uint8Array,
  size: FrameSize,
  what: string,
  charls: UnpackLs | null = null,
): Unpacked<Uint16Array> {
  const parts = readFrameParts(packed, size, what);
  const { coding, components, precision } = parts;
  if (components.length !== 1)
    throw corruptFile(what, `has packed pixels (JPEG) of ${components.length} numbers each; expected 1`);
  const numbers = new Uint16Array(size.columns * size.rows);
  const unpacked = coding === 'LS' ? charls?.(packed, precision) : null;
  if (unpacked?.length === numbers.length) numbers.set(unpacked);
  // What the library refuses, our own code unpacks, or says what is wrong with it.
  else unpackers[coding](parts, numbers);
  return { numbers, precision };
}

/**
 * Unpacks a frame of JPEG in three colours of 8 bits.
 * @param numbers - to be written: three for each pixel
 * @returns whether the stream says that they are red, green and blue, or that they are not; null if it does not say it
 * @throws {VolumeViewError} `format/corrupt`, `format/unsupported`
 */
export function unpackJpegColors(
  packed: Uint8Array,
  size: FrameSize,
  numbers: Uint8Array,
  what: string,
): boolean | null {
  const parts = readFrameParts(packed, size, what);
  if (parts.components.length !== 3)
    throw corruptFile(what, `has packed pixels (JPEG) of ${parts.components.length} numbers each; expected 3`);
  unpackColors(parts, numbers);
  return parts.isRgb;
}

function readFrameParts(packed: Uint8Array, { columns, rows, bitsAllocated }: FrameSize, what: string): JpegParts {
  const parts = readJpegParts(packed, what);
  if (parts.columns === columns && parts.rows === rows && parts.precision <= bitsAllocated) return parts;
  throw corruptFile(
    what,
    `has packed pixels of ${parts.columns} x ${parts.rows} with ${parts.precision} bits; expected ${columns} x ${rows} with at most ${bitsAllocated}`,
  );
}
