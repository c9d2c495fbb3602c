// The frames of a DICOM file, packed, and our own unpacker, for codecs.mjs.
import { Budget } from '../../src/formats/base/budget.ts';
import { readPicture } from '../../src/formats/dicom/picture.ts';
import { readDicomFile } from '../../src/formats/dicom/read-file.ts';
import { unpackJpeg } from '../../src/formats/dicom/unpack-jpeg.ts';

/** The frames; of several, each has to be in one piece. */
export function listPacked(bytes: Uint8Array<ArrayBuffer>): {
  readonly columns: number;
  readonly rows: number;
  readonly bitsAllocated: number;
  readonly frames: readonly Uint8Array[];
} {
  const picture = readPicture(readDicomFile(bytes, new Budget(), 'the file'), 'the file');
  if (!picture) throw new Error('the file has no pixels');
  const { columns, rows, bitsAllocated, pixels, frames } = picture;
  const { fragments } = pixels;
  if (fragments.length !== frames && frames > 1) throw new Error('the frames are in several pieces');
  const whole = Uint8Array.from(fragments.flatMap((piece) => [...piece]));
  return { columns, rows, bitsAllocated, frames: frames > 1 ? fragments : [whole] };
}

export const unpackOwn = (
  packed: Uint8Array,
  size: { readonly columns: number; readonly rows: number; readonly bitsAllocated: number },
): Uint16Array => unpackJpeg(packed, size, 'the file').numbers;
