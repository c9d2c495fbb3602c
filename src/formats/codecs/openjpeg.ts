import { loadReader } from '../base/load-reader.ts';
import { findJ2kStart } from './j2k-start.ts';
import { beSilent, mayCompile, release, startLibrary } from './start-library.ts';

/** An unpacked picture of JPEG 2000. */
export interface J2kPicture {
  readonly columns: number;
  readonly rows: number;
  /** Numbers of a pixel. */
  readonly components: number;
  /** Bits of a number. */
  readonly precision: number;
  readonly isSigned: boolean;
  /** Row by row, all numbers of a pixel together. */
  readonly numbers: Uint8Array | Uint16Array | Int8Array | Int16Array;
}

/** Unpacks JPEG 2000 or HTJ2K; null where the bytes are damaged. Then the unpacker is not to be used again. */
export type UnpackJ2k = (packed: Uint8Array) => J2kPicture | null;

/**
 * Loads OpenJPEG: as WebAssembly, or in plain JavaScript where the page's policy (CSP) does not allow WebAssembly. Its memory
 * never becomes smaller, so each load of a volume has its own.
 */
export async function loadOpenJpeg(): Promise<UnpackJ2k> {
  const { J2KDecoder } = await startOpenJpeg();
  return (stream) => {
    const unsigned = withoutSign(stream);
    const packed = unsigned ?? stream;
    const decoder = new J2KDecoder();
    try {
      decoder.getEncodedBuffer(packed.length).set(packed);
      decoder.decode();
      const { width, height, componentCount, bitsPerSample, isSigned: hasSign } = decoder.getFrameInfo();
      const bytes = decoder.getDecodedBuffer().slice();
      const isSigned = unsigned !== null || hasSign;
      const [wide, narrow] = isSigned ? [Int16Array, Int8Array] : [Uint16Array, Uint8Array];
      const numbers = new (bitsPerSample > 8 ? wide : narrow)(bytes.buffer);
      if (unsigned) for (let i = 0; i < bytes.length; i++) numbers[i] = bytes[i] - 2 ** (bitsPerSample - 1);
      if (numbers.length !== width * height * componentCount) return null;
      return {
        columns: width,
        rows: height,
        components: componentCount,
        precision: bitsPerSample,
        isSigned,
        numbers,
      };
    } catch {
      return null; // The library throws numbers, and its own end where it lacks memory.
    } finally {
      release(decoder);
    }
  };
}

/**
 * The library makes negative numbers of up to 8 bits 0. Of a stream that says no sign it adds half of the range to each number, and nothing
 * else differs, so such a stream is given to it. Source: ITU-T T.800, A.5.1 and G.1.2
 * @returns null where no number has a sign, or one has more bits
 */
function withoutSign(packed: Uint8Array): Uint8Array | null {
  const start = findJ2kStart(packed);
  if (start < 0 || start + firstDepth > packed.length) return null;
  const stream = packed.slice(start);
  const count = 256 * stream[firstDepth - 2] + stream[firstDepth - 1];
  const depths = Array.from({ length: count }, (_, i) => firstDepth + 3 * i);
  // A depth is that of a number less 1; its highest bit is the sign.
  const areShort = depths.every((at) => stream[at] >= 0x80 && stream[at] <= 0x87);
  if (count === 0 || !areShort) return null;
  for (const at of depths) stream[at] &= 0x7f;
  return stream;
}

/** Where a stream says how many bits the first of its numbers has. */
const firstDepth = 42;

async function startOpenJpeg(): Promise<OpenJpegModule> {
  const { startOpenJpeg: start } = mayCompile()
    ? await loadReader(() => import('#openjpeg-wasm'))
    : await loadReader(() => import('#openjpeg-js'));
  return startLibrary(() => start(beSilent()));
}
