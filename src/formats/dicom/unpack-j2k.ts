import { corruptFile } from '../base/file-problem.ts';
import { findJ2kStart } from '../codecs/j2k-start.ts';
import type { UnpackJ2k } from '../codecs/openjpeg.ts';
import { samplesPerPixel } from './colors.ts';
import type { Picture } from './picture.ts';

/** What a stream of JPEG 2000 says of itself. */
interface J2kSize {
  readonly columns: number;
  readonly rows: number;
  readonly components: number;
  readonly precision: number;
  readonly isSigned: boolean;
}

/** Unpacked numbers, and how many bits the stream has for each. */
export interface Unpacked<Numbers> {
  readonly numbers: Numbers;
  readonly precision: number;
}

/**
 * Unpacks a frame of JPEG 2000 or HTJ2K.
 * @throws {VolumeViewError} `format/corrupt`, `format/unsupported`, before the library takes memory
 */
export function unpackJ2k(
  packed: Uint8Array,
  {
    columns,
    rows,
    bitsAllocated,
    isSigned,
    colors,
    what,
  }: Pick<Picture, 'columns' | 'rows' | 'bitsAllocated' | 'isSigned' | 'colors' | 'what'>,
  unpack: UnpackJ2k,
): Unpacked<ArrayLike<number>> {
  const size = readSize(packed);
  const damaged = (): Error => corruptFile(what, 'has packed pixels (JPEG 2000) that are damaged; copy the file again');
  if (!size) throw damaged();
  const components = samplesPerPixel(colors);
  if (size.components !== components)
    throw corruptFile(what, `has packed pixels (JPEG 2000) of ${size.components} numbers each; expected ${components}`);
  if (size.columns !== columns || size.rows !== rows || size.precision > Math.min(16, bitsAllocated))
    throw corruptFile(
      what,
      `has packed pixels of ${size.columns} x ${size.rows} with ${size.precision} bits; expected ${columns} x ${rows} with at most ${Math.min(16, bitsAllocated)}`,
    );
  const picture = unpack(packed);
  if (!picture || picture.numbers.length !== columns * rows * components) throw damaged();
  const { numbers } = picture;
  // Some programs pack signed numbers as if they had no sign.
  const above = 32 - size.precision;
  const signed = isSigned && !size.isSigned && above > 0;
  return {
    numbers: signed ? Int32Array.from(numbers, (number) => (number << above) >> above) : numbers,
    precision: size.precision,
  };
}

/** Reads the size before anything is unpacked. Source: ITU-T T.800, A.5.1 */
function readSize(bytes: Uint8Array): J2kSize | null {
  const start = findJ2kStart(bytes);
  if (start < 0 || start + 45 > bytes.length) return null;
  const view = new DataView(bytes.buffer, bytes.byteOffset + start, bytes.byteLength - start);
  const [right, bottom, left, top] = [8, 12, 16, 20].map((at) => view.getUint32(at));
  const depth = view.getUint8(42);
  return {
    columns: right - left,
    rows: bottom - top,
    components: view.getUint16(40),
    precision: (depth & 0x7f) + 1,
    isSigned: depth >= 0x80,
  };
}
