import { VolumeViewError } from '../../core/errors.ts';
import type { Budget } from './budget.ts';
import type { PieceReader } from './piece-reader.ts';

/** Maximum bytes that are read after the samples to reach a gzip file's checksum; the rest is ignored. */
const maxTrailingBytes = 2 ** 24;

/** A file whose header comes first and whose samples follow. */
export interface StreamSource {
  /** Maximum number of bytes that the file can have, unpacked. */
  readonly atMost: number;
  onProgress(loaded: number, total: number): void;
  readonly budget: Budget;
}

/**
 * Reads a range of a file's samples, in a buffer of their own.
 * @param span.what - for messages, such as 'NIfTI'
 * @param span.isPart - whether other samples follow, so that the end of the file is not read, and a checksum there is
 * not checked
 * @throws {VolumeViewError} `format/corrupt` before memory is allocated that the file can't fill; `format/too-large`
 */
export async function readSpan(
  reader: PieceReader,
  { atMost, onProgress, budget }: StreamSource,
  { what, offset, bytes, isPart }: { what: string; offset: number; bytes: number; isPart: boolean },
): Promise<Uint8Array<ArrayBuffer>> {
  const fail = (got: string): VolumeViewError =>
    new VolumeViewError(
      'format/corrupt',
      `the ${what} file ends early: got ${got}; its header asks for ${offset + bytes} bytes`,
    );
  // Refuse a header that announces more data than the file can hold, before memory is allocated.
  if (offset + bytes > atMost) throw fail(`at most ${atMost} bytes`);
  budget.take(bytes, `the ${what} file`);
  const got = await reader.readRange(offset, bytes, onProgress);
  if (got.length < bytes) throw fail(`${reader.total} bytes`);
  // The end of a gzip file holds the checksum.
  if (!isPart) await reader.drain(maxTrailingBytes);
  return got;
}
