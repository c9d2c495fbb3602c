import type { DecodeInput } from './base/decoded-volume.ts';
import type { FileStart, Format } from './base/format.ts';
import { gunzip, isGzip } from './codecs/gunzip.ts';
import { loadReader } from './base/load-reader.ts';

/**
 * Finds a file's format: by its bytes, then by its name.
 * @param formats - the usual ones; the rare ones are known in addition
 * @throws {VolumeViewError} `format/unknown`, `format/corrupt`, with a message about what was received
 */
export async function sniffFile(input: DecodeInput, formats: readonly Format[]): Promise<Format> {
  const start = await lookAt(input.bytes);
  const found = findByBytes(start, formats);
  if (found && !found.last) return found;
  const { chooseRare } = await loadReader(() => import('#rare/formats/choose-rare.ts'));
  return chooseRare(input, start, formats, found);
}

/** The format of a file by its bytes alone, or null. */
export async function findFormat<F extends Format>(
  bytes: Uint8Array<ArrayBuffer>,
  formats: readonly F[],
): Promise<F | null> {
  return findByBytes(await lookAt(bytes), formats);
}

/** The format whose bytes a file begins with, or null. */
export function findByBytes<F extends Format>(start: FileStart, formats: readonly F[]): F | null {
  const matching = formats.filter((format) => format.matches(start));
  return matching.find(({ last }) => !last) ?? matching[0] ?? null;
}

/** What formats look at in a file. @param bytes - the whole file, or its start */
export async function lookAt(bytes: Uint8Array<ArrayBuffer>): Promise<FileStart> {
  return {
    bytes,
    unpacked: isGzip(bytes) ? await firstPiece(bytes) : null,
    text: new TextDecoder().decode(bytes.subarray(0, 512)).trimStart(),
  };
}

/** The first bytes that a gzip file holds; none if it is damaged, which its reader explains. */
async function firstPiece(bytes: Uint8Array<ArrayBuffer>): Promise<Uint8Array> {
  try {
    for await (const piece of gunzip(bytes.subarray(0, 1 << 16))) return piece;
  } catch {
    // The stream was cut short on purpose, and may also be damaged.
  }
  return new Uint8Array();
}
