import { loadReader } from '../base/load-reader.ts';
import { beSilent, mayCompile, release, startLibrary } from './start-library.ts';

/** Unpacks JPEG-LS of 2 to 16 bits, row by row; null where the bytes are damaged, and for all after those. */
export type UnpackLs = (packed: Uint8Array, precision: number) => Uint8Array | Uint16Array | null;

/** Marks the end of a stream. Of one that is cut, without it, the library searches its memory for minutes. Source: T.87, annex C.1.1 */
const end = [0xff, 0xd9];

/**
 * Loads CharLS as WebAssembly: 7 to 17 times as fast as our own decoder, which is used where the page's policy (CSP) does not allow
 * WebAssembly. Its memory never becomes smaller, so each load of a volume has its own.
 * @returns null where the policy refuses it
 */
export async function loadCharls(): Promise<UnpackLs | null> {
  if (!mayCompile()) return null;
  const { startCharls } = await loadReader(() => import('#charls-wasm'));
  const { JpegLSDecoder } = await startLibrary(() => startCharls(beSilent()));
  /** What the library does after damaged bytes is not known. */
  let isSound = true;
  return (packed, precision) => {
    if (!isSound) return null;
    const decoder = new JpegLSDecoder();
    try {
      const buffer = decoder.getEncodedBuffer(packed.length + end.length);
      buffer.set(packed);
      buffer.set(end, packed.length);
      decoder.decode();
      const bytes = decoder.getDecodedBuffer().slice();
      return precision > 8 ? new Uint16Array(bytes.buffer) : bytes;
    } catch {
      isSound = false; // The library throws numbers, and its own end where it lacks memory.
      return null;
    } finally {
      release(decoder);
    }
  };
}
