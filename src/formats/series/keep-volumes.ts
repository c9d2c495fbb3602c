import { corruptFile } from '../base/file-problem.ts';
import type { Budget } from '../base/budget.ts';
import { maxTrailingBytes } from '../base/piece-reader.ts';
import type { StreamSource } from '../base/piece-reader.ts';
import type { DecodeInput } from '../base/decoded-volume.ts';
import type { ScanBytes } from '../base/scan-data.ts';

/** Maximum bytes of the volumes of one file that are kept, unpacked. */
export const maxKeptBytes = 2 ** 29;

/** The number of scans of one source. */
export const maxScans = 10_000;

/** Bytes that are collected in this thread's memory before the browser gets them. */
const pieceBytes = 2 ** 23;

/** Volumes that lie one after another in a file. */
export interface SeriesSpan {
  /** For messages: 'the NIfTI file'. */
  readonly what: string;
  /** Where the first one begins in the unpacked file. */
  readonly offset: number;
  /** Of one volume. */
  readonly bytes: number;
  readonly count: number;
  /** Bytes after the last one that the reader looks at; 0 if undefined. A file that lacks them is not cut short. */
  readonly tail?: number;
}

/** The volumes of a file, and what of them is left out, in words. */
export interface KeptVolumes {
  readonly volumes: readonly ScanBytes[];
  readonly left: string | null;
  /** The unpacked file, or its start. */
  readonly file: Blob;
}

/** How many volumes can be kept; at least one. Half of the memory that is left stays free to read them. */
export function countKept({ bytes, count }: Pick<SeriesSpan, 'bytes' | 'count'>, budget: Budget): number {
  return Math.max(1, Math.min(count, maxScans, Math.floor(Math.min(maxKeptBytes, budget.leftBytes / 2) / bytes)));
}

/** What of the volumes is not kept, in words; null if all are. */
export function describeKept(kept: number, count: number): string | null {
  if (kept === count) return null;
  const which = kept + 1 < count ? `volumes ${kept + 1} to ${count}` : `volume ${count}`;
  return kept === maxScans
    ? `${which} of the file: at most ${maxScans.toLocaleString('en')} can be shown`
    : `${which} of the file: unpacked, they take more memory than a page keeps for one file (${Math.floor(maxKeptBytes / 2 ** 20)} MiB, less on small devices). An unpacked file on a server that answers byte ranges is shown as a whole`;
}

/**
 * Unpacks a file once, and gives its volumes to the browser to keep.
 * @throws {VolumeViewError} `format/corrupt` where the file has fewer bytes than its header says, `format/too-large`
 */
export async function keepVolumes(
  unpacked: AsyncIterable<Uint8Array<ArrayBuffer>>,
  span: SeriesSpan,
  { atMost, budget, onProgress }: StreamSource,
): Promise<KeptVolumes> {
  const { what, offset, bytes, count, tail = 0 } = span;
  checkEnd(span, atMost, `at most ${atMost} bytes`);
  const kept = countKept(span, budget);
  budget.take(kept * bytes, what);
  const end = offset + kept * bytes;
  const parts: Blob[] = [];
  let pieces: Uint8Array<ArrayBuffer>[] = [];
  let [size, held] = [0, 0];
  const pass = (): void => {
    parts.push(new Blob(pieces));
    pieces = [];
    held = 0;
  };
  for await (const piece of unpacked) {
    if (size < end + tail) {
      pieces.push(piece);
      held += piece.length;
    }
    size += piece.length;
    onProgress(Math.min(size, end), end);
    if (held >= pieceBytes) pass();
    // The end of a gzip file holds the checksum.
    if (size >= end + (kept === count ? maxTrailingBytes : 0)) break;
  }
  pass();
  if (size < end) checkEnd(span, size, `${size} bytes`);
  const all = new Blob(parts);
  return {
    volumes: Array.from({ length: kept }, (_, i) => all.slice(offset + i * bytes, offset + (i + 1) * bytes)),
    left: describeKept(kept, count),
    file: all,
  };
}

/** Volumes in a file of which the server sends parts. @param missing - bytes of the file after its start */
export function listRanges({ url, bytes: start }: DecodeInput, missing: number, span: SeriesSpan): KeptVolumes {
  const { offset, bytes, count } = span;
  const size = start.length + missing;
  checkEnd(span, size, `${size} bytes`);
  const shown = Math.min(count, maxScans);
  return {
    volumes: Array.from({ length: shown }, (_, i) => ({
      url,
      start: offset + i * bytes,
      end: offset + (i + 1) * bytes,
    })),
    left: describeKept(shown, count),
    file: new Blob([start]),
  };
}

function checkEnd({ what, offset, bytes, count }: SeriesSpan, size: number, got: string): void {
  const expected = offset + bytes * count;
  if (size < expected)
    throw corruptFile(
      what,
      `ends early: got ${got}; its header asks for ${expected.toLocaleString('en')} bytes, ${count.toLocaleString('en')} volumes of ${bytes.toLocaleString('en')}`,
    );
}
