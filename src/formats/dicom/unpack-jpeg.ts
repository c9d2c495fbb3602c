import { corruptFile } from '../base/file-problem.ts';
import { unpackDct } from './jpeg-dct.ts';
import { unpackLossless } from './jpeg-lossless.ts';
import { unpackLs } from './jpeg-ls.ts';
import { readJpegParts } from './jpeg-parts.ts';

const unpackers = { DCT: unpackDct, lossless: unpackLossless, LS: unpackLs } as const;

/** The size that a frame must have. */
interface FrameSize {
  readonly columns: number;
  readonly rows: number;
  readonly bitsAllocated: number;
}

/**
 * Unpacks a frame of JPEG (8 and 12 bits), lossless JPEG or JPEG-LS: which of them it is, the stream itself says.
 * @throws {VolumeViewError} `format/corrupt`, `format/unsupported`
 */
export function unpackJpeg(packed: Uint8Array, { columns, rows, bitsAllocated }: FrameSize, what: string): Uint16Array {
  const parts = readJpegParts(packed, what);
  if (parts.columns !== columns || parts.rows !== rows || parts.precision > bitsAllocated)
    throw corruptFile(
      what,
      `has packed pixels of ${parts.columns} x ${parts.rows} with ${parts.precision} bits; expected ${columns} x ${rows} with at most ${bitsAllocated}`,
    );
  const numbers = new Uint16Array(columns * rows);
  unpackers[parts.coding](parts, numbers);
  return numbers;
}
