import { loadReader } from '../base/load-reader.ts';

/** Deflate can't compress better than this, so a small file can't claim much memory. Source: zlib's technical notes. */
export const maxDeflateRatio = 1032;

/** True where bytes begin with gzip's signature and the deflate method (RFC 1952). */
export function isGzip(bytes: Uint8Array): boolean {
  return bytes.length > 2 && bytes[0] === 0x1f && bytes[1] === 0x8b && bytes[2] === 8;
}

/**
 * Unpacks a gzip file, all its members, piece by piece, so that a reader can read a header before it allocates, and
 * stop when it has enough. Other data after the members are ignored.
 * @throws {VolumeViewError} `format/corrupt` during reading, if the file ends early or its checksum is wrong
 */
export function gunzip(bytes: Uint8Array<ArrayBuffer>): AsyncGenerator<Uint8Array<ArrayBuffer>> {
  return unpack(bytes, 'gzip', `the gzip file of ${bytes.length} bytes`);
}

/**
 * The browser's own decompressor unpacks one stream and checks it. It fails if anything follows the stream; then our
 * own decoder continues.
 * @param what - for messages
 */
export async function* unpack(
  bytes: Uint8Array<ArrayBuffer>,
  form: 'gzip' | 'deflate',
  what: string,
): AsyncGenerator<Uint8Array<ArrayBuffer>> {
  const reader = new Blob([bytes]).stream().pipeThrough(new DecompressionStream(form)).getReader();
  let given = 0;
  try {
    for (;;) {
      const { done, value } = await reader.read();
      if (done) return;
      given += value.length;
      yield value;
    }
  } catch {
    // The browser's decompressor threw away what it had not yielded.
  } finally {
    // A reader that stops early leaves the stream open; one that failed has nothing left to cancel.
    await reader.cancel().catch(() => undefined);
  }
  const { unpackSeries } = await loadReader(() => import('#rare/formats/codecs/unpack-series.ts'));
  for (const piece of unpackSeries(bytes, form, what)) {
    const isNew = piece.length > given;
    if (isNew) yield given ? piece.slice(given) : piece;
    given = isNew ? 0 : given - piece.length;
  }
}
