import { loadReader } from '../base/load-reader.ts';

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
  const { J2KDecoder } = await startLibrary();
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

function release(decoder: OpenJpegDecoder): void {
  try {
    decoder.delete();
  } catch {
    // A library that has ended by itself has nothing to release.
  }
}

async function startLibrary(): Promise<OpenJpegModule> {
  const silent = { print: () => undefined, printErr: () => undefined };
  const isNode = !('__dirname' in globalThis) && 'process' in globalThis;
  // In Node the library asks for its folder, which it does not need: its bytes are given.
  if (isNode) Reflect.set(globalThis, '__dirname', '');
  try {
    if (mayCompile()) {
      const { startOpenJpeg } = await loadReader(() => import('#openjpeg-wasm'));
      return await startOpenJpeg(silent);
    }
    const { startOpenJpeg } = await loadReader(() => import('#openjpeg-js'));
    return await startOpenJpeg(silent);
  } finally {
    if (isNode) Reflect.deleteProperty(globalThis, '__dirname');
  }
}

/** Whether a module without content can be compiled: a policy without 'wasm-unsafe-eval' refuses all. */
function mayCompile(): boolean {
  try {
    return new WebAssembly.Module(Uint8Array.of(0, 0x61, 0x73, 0x6d, 1, 0, 0, 0)) instanceof WebAssembly.Module;
  } catch {
    return false;
  }
}
