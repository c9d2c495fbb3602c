import type { Budget } from '../base/budget.ts';
import { PartGatherer } from '../base/gather-parts.ts';
import { gunzip, isGzip, maxDeflateRatio } from '../codecs/gunzip.ts';
import { isZlib, unzlib } from '../codecs/unzlib.ts';
import type { ReadContext } from '../base/format.ts';
import type { NumberType } from '../base/number-types.ts';
import { PieceReader, yieldOnce } from '../base/piece-reader.ts';
import { corruptFile } from '../base/file-problem.ts';
import { readTextNumbers } from './read-text-numbers.ts';

/** Where a header says that its samples are, and how they are written. */
export interface SampleLayout {
  /** For messages, such as 'the NRRD file'. */
  readonly what: string;
  readonly type: NumberType;
  /** 'deflate' is gzip or zlib: their first bytes differ. 'text' gives numbers in this machine's byte order. */
  readonly encoding: 'raw' | 'deflate' | 'bzip2' | 'text';
  /** Bytes of samples in each file, after decoding. */
  readonly bytesPerFile: number;
  /** Offset of the samples in the first file, bytes; 0 in other files. */
  readonly start?: number;
  /**
   * Of each file, after `start`: first the lines to skip, then the bytes to skip. 'all before' skips everything except
   * the end, for raw only.
   */
  readonly skipLines?: number;
  readonly skipBytes?: number | 'all before';
  /** Of each file, bytes to skip of what it unpacks to. */
  readonly skipUnpacked?: number;
}

/**
 * Reads samples from one file after another, until it has as many as wanted.
 * @param files - their bytes; the buffers are taken over
 * @param wanted - bytes, from the first sample on
 * @returns `wanted` bytes, taken from the budget
 * @throws {VolumeViewError} `format/corrupt` before it takes memory that the files can't fill, `format/too-large`
 */
export async function readSamples(
  files: AsyncIterable<Uint8Array<ArrayBuffer>>,
  layout: SampleLayout,
  wanted: number,
  { onProgress, budget }: Pick<ReadContext, 'onProgress' | 'budget'>,
): Promise<Uint8Array<ArrayBuffer>> {
  const all = new PartGatherer(wanted, layout.what, budget);
  let { start = 0 } = layout;
  for await (const file of files) {
    const bytes = await readFile(file, { layout, start, budget }, Math.min(layout.bytesPerFile, wanted - all.length));
    if (bytes.length === wanted) {
      onProgress(wanted, wanted);
      return bytes;
    }
    all.add(bytes);
    onProgress(all.length, wanted);
    if (all.length >= wanted) return all.finish();
    start = 0;
  }
  throw endsEarly(layout, `${all.length} bytes in all files`, wanted);
}

interface FilePart {
  readonly layout: SampleLayout;
  readonly start: number;
  readonly budget: Budget;
}

/** @returns `wanted` bytes, taken from the budget */
async function readFile(
  file: Uint8Array<ArrayBuffer>,
  { layout, start, budget }: FilePart,
  wanted: number,
): Promise<Uint8Array<ArrayBuffer>> {
  const { what, type, encoding, skipUnpacked = 0 } = layout;
  const from = findStart(file, layout, start);
  switch (encoding) {
    case 'raw': {
      if (from + wanted > file.length) throw endsEarly(layout, `${Math.max(0, file.length - from)} bytes`, wanted);
      budget.take(wanted, what);
      return readPieces(yieldOnce(file), { layout, from, wanted });
    }
    case 'deflate': {
      const packed = file.subarray(from);
      if (skipUnpacked + wanted > packed.length * maxDeflateRatio)
        throw endsEarly(layout, `${packed.length} packed bytes`, wanted);
      if (!isGzip(packed) && !isZlib(packed))
        throw corruptFile(
          what,
          'has data that begin neither as gzip nor as zlib do; it is damaged, or not compressed as it says',
        );
      budget.take(wanted, what);
      return readPieces(isGzip(packed) ? gunzip(packed) : unzlib(packed), { layout, from: skipUnpacked, wanted });
    }
    case 'bzip2': {
      const { bunzip2 } = await import('../codecs/bunzip2.ts');
      budget.take(skipUnpacked + layout.bytesPerFile, what);
      const unpacked = bunzip2(file.subarray(from), skipUnpacked + layout.bytesPerFile);
      budget.giveBack(skipUnpacked + layout.bytesPerFile - wanted);
      if (unpacked.length < skipUnpacked + wanted) throw endsEarly(layout, `${unpacked.length} bytes unpacked`, wanted);
      return unpacked.subarray(skipUnpacked, skipUnpacked + wanted);
    }
    case 'text': {
      // The bytes are at most a few times as many as the characters.
      const numbers = readTextNumbers(what, file.subarray(from), wanted / type.bytesPerSample, type);
      budget.take(wanted, what);
      return numbers;
    }
  }
}

/**
 * The bytes from `from` on. If they are all that a packed file holds, its end is read too, because the checksum is
 * there.
 */
async function readPieces(
  pieces: AsyncIterable<Uint8Array<ArrayBuffer>>,
  { layout, from, wanted }: { layout: SampleLayout; from: number; wanted: number },
): Promise<Uint8Array<ArrayBuffer>> {
  const reader = new PieceReader(pieces);
  try {
    await reader.readStart(1);
    const bytes = await reader.readRange(from, wanted, () => undefined);
    if (bytes.length < wanted) throw endsEarly(layout, `${Math.max(0, reader.total - from)} bytes`, wanted);
    if (layout.encoding !== 'deflate' || wanted < layout.bytesPerFile) return bytes;
    await reader.drain(1);
    if (reader.total > from + wanted)
      throw corruptFile(
        layout.what,
        `unpacks to more than the ${wanted} bytes that its header asks for; it is damaged, or its header is of another file`,
      );
    return bytes;
  } finally {
    await reader.stop();
  }
}

function findStart(file: Uint8Array, layout: SampleLayout, start: number): number {
  const { what, skipLines = 0, skipBytes = 0, bytesPerFile } = layout;
  let at = start;
  for (let line = 0; line < skipLines; line++) {
    const end = file.indexOf(0x0a, at);
    if (end < 0) throw corruptFile(what, `asks to skip ${skipLines} lines and got ${line}; the file is cut short`);
    at = end + 1;
  }
  if (skipBytes !== 'all before') return at + skipBytes;
  if (file.length - at < bytesPerFile) throw endsEarly(layout, `${file.length - at} bytes`, bytesPerFile);
  return file.length - bytesPerFile;
}

function endsEarly({ what }: SampleLayout, got: string, wanted: number): Error {
  return corruptFile(what, `ends early: got ${got}; its header asks for ${wanted} bytes of samples`);
}
