import type { Budget } from '../base/budget.ts';
import { gunzip } from './gunzip.ts';
import { joinPieces } from '../base/join-pieces.ts';

/**
 * Unpacks a gzip file as a whole, for readers that need all of it at once.
 * @param what - for messages: 'the TIFF file'
 * @throws {VolumeViewError} `format/corrupt`, `format/too-large` before more is unpacked than the budget has
 */
export async function gunzipAll(
  bytes: Uint8Array<ArrayBuffer>,
  budget: Budget,
  what: string,
): Promise<Uint8Array<ArrayBuffer>> {
  const pieces: Uint8Array[] = [];
  let length = 0;
  for await (const piece of gunzip(bytes)) {
    budget.take(piece.length, what);
    pieces.push(piece);
    length += piece.length;
  }
  budget.take(length, what);
  const all = joinPieces(pieces);
  budget.giveBack(length);
  return all;
}
