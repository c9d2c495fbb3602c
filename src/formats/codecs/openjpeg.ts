import { loadReader } from '../base/load-reader.ts';
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
  return (packed) => {
    const decoder = new J2KDecoder();
    try {
      decoder.getEncodedBuffer(packed.length).set(packed);
      decoder.decode();
      const { width, height, componentCount, bitsPerSample, isSigned } = decoder.getFrameInfo();
      const bytes = decoder.getDecodedBuffer().slice();
      const [wide, narrow] = isSigned ? [Int16Array, Int8Array] : [Uint16Array, Uint8Array];
      const numbers = new (bitsPerSample > 8 ? wide : narrow)(bytes.buffer);
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

async function startOpenJpeg(): Promise<OpenJpegModule> {
  const { startOpenJpeg: start } = mayCompile()
    ? await loadReader(() => import('#openjpeg-wasm'))
    : await loadReader(() => import('#openjpeg-js'));
  return startLibrary(() => start(beSilent()));
}
