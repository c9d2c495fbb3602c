import { VolumeViewError } from '../errors.ts';

/** Deflate can not do better than this, so a small file can not ask for much memory. Source: zlib's technical notes. */
export const maxDeflateRatio = 1032;

/** True where bytes begin with gzip's signature and the deflate method (RFC 1952). */
export function isGzip(bytes: Uint8Array): boolean {
  return bytes.length > 2 && bytes[0] === 0x1f && bytes[1] === 0x8b && bytes[2] === 8;
}

/**
 * Unpack a gzip file piece by piece, so that a reader can read a header before it allocates, and stop when it has
 * enough. The browser's own decompressor does it, checksum included; like it, this takes files of one member only.
 * @throws {VolumeViewError} `format/corrupt` while being read, where the file ends early or its checksum is wrong
 */
export function gunzip(bytes: Uint8Array<ArrayBuffer>): AsyncGenerator<Uint8Array<ArrayBuffer>> {
  return unpack(bytes, 'gzip', `the gzip file of ${bytes.length} bytes ends early or is damaged (or is several gzip files in one); fetch it again, or compress the data again with gzip`);
}

/** @param damaged - what the error says where the data end early or are damaged */
export async function* unpack(bytes: Uint8Array<ArrayBuffer>, form: CompressionFormat, damaged: string): AsyncGenerator<Uint8Array<ArrayBuffer>> {
  const reader = new Blob([bytes]).stream().pipeThrough(new DecompressionStream(form)).getReader();
  try {
    for (;;) {
      const { done, value } = await reader.read();
      if (done) return;
      yield value;
    }
  } catch (cause) {
    throw new VolumeViewError('format/corrupt', damaged, { cause });
  } finally {
    // A reader that stops early leaves the stream open; one that failed has nothing left to cancel.
    await reader.cancel().catch(() => undefined);
  }
}
