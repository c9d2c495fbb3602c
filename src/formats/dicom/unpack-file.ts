import { VolumeViewError } from '../../core/errors.ts';
import type { Budget } from '../base/budget.ts';
import { keptBytes } from '../base/format.ts';
import { joinPieces } from '../base/join-pieces.ts';
import { gunzip, isGzip } from '../codecs/gunzip.ts';
import { isDicom } from './is-dicom.ts';

/**
 * Unpacks a file that comes from an archive as a gzip file. Of a damaged one only the start is given, as it is taken on trust
 * where the archive is opened: then its pixels end early, and its slice is no data.
 * @throws {VolumeViewError} `format/too-large`
 */
export async function unpackFile(
  bytes: Uint8Array<ArrayBuffer>,
  budget: Budget,
  what: string,
): Promise<Uint8Array<ArrayBuffer>> {
  if (isDicom(bytes) || !isGzip(bytes)) return bytes;
  const pieces: Uint8Array[] = [];
  let length = 0;
  try {
    for await (const piece of gunzip(bytes)) {
      budget.take(piece.length, what);
      pieces.push(piece);
      length += piece.length;
    }
  } catch (cause) {
    if (!(cause instanceof VolumeViewError && cause.code === 'format/corrupt')) throw cause;
    return joinPieces(pieces).slice(0, Math.min(keptBytes, length >> 1));
  }
  return joinPieces(pieces);
}
