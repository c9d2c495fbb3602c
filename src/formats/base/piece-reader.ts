import { VolumeViewError } from '../../core/errors.ts';
import type { Budget } from './budget.ts';

/** A range that is at least this share of a piece is not copied. The rest of the piece then stays in memory with it. */
const minShare = 7 / 8;

/** Reads a file's start, and then one range of its bytes, from a stream of pieces. */
export class PieceReader {
  /** Bytes received so far. */
  total = 0;
  readonly #iterator: AsyncIterator<Uint8Array<ArrayBuffer>>;
  #start = new Uint8Array(0);

  constructor(pieces: AsyncIterable<Uint8Array<ArrayBuffer>>) {
    this.#iterator = pieces[Symbol.asyncIterator]();
  }

  /** The first `length` bytes, or fewer if the file is shorter. */
  async readStart(length: number): Promise<Uint8Array<ArrayBuffer>> {
    while (this.#start.length < length) {
      const piece = await this.#next();
      if (!piece) break;
      if (this.#start.length === 0) {
        this.#start = piece;
        continue;
      }
      const longer = new Uint8Array(this.#start.length + piece.length);
      longer.set(this.#start);
      longer.set(piece, this.#start.length);
      this.#start = longer;
    }
    return this.#start.subarray(0, length);
  }

  /**
   * Bytes `offset` to `offset + length`, or fewer if the file is shorter, in a buffer that begins with them. If the
   * start holds almost nothing else (a file that is not packed), the bytes are moved to its front: a large file is not
   * copied. Else they get a buffer of their own.
   */
  async readRange(
    offset: number,
    length: number,
    onProgress: (loaded: number, total: number) => void,
  ): Promise<Uint8Array<ArrayBuffer>> {
    const start = this.#start;
    if (start.byteOffset === 0 && start.length >= offset + length && length >= minShare * start.buffer.byteLength) {
      start.copyWithin(0, offset, offset + length);
      onProgress(length, length);
      return start.subarray(0, length);
    }
    const bytes = new Uint8Array(length);
    let at = 0;
    let piece: Uint8Array<ArrayBuffer> | null = this.#start;
    for (; piece && at < offset + length; piece = at < offset + length ? await this.#next() : null) {
      const part = piece.subarray(Math.max(0, offset - at), Math.max(0, offset + length - at));
      bytes.set(part, Math.max(0, at - offset));
      at += piece.length;
      onProgress(Math.max(0, Math.min(length, at - offset)), length);
    }
    return bytes.subarray(0, Math.max(0, Math.min(length, at - offset)));
  }

  /** Reads to the end, but at most about `maxBytes` bytes. */
  async drain(maxBytes: number): Promise<void> {
    const end = this.total + maxBytes;
    while (this.total < end && (await this.#next()));
  }

  /** Stops the source. */
  async stop(): Promise<void> {
    await this.#iterator.return?.();
  }

  async #next(): Promise<Uint8Array<ArrayBuffer> | null> {
    const { done, value } = await this.#iterator.next();
    if (done) return null;
    this.total += value.length;
    return value;
  }
}

/** Yields bytes that are already in memory, as one piece. */
export async function* yieldOnce(bytes: Uint8Array<ArrayBuffer>): AsyncGenerator<Uint8Array<ArrayBuffer>> {
  yield bytes;
}

/** Maximum bytes that are read after the samples to reach a gzip file's checksum; the rest is ignored. */
export const maxTrailingBytes = 2 ** 24;

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
