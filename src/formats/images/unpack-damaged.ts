import { Unzlib } from 'fflate';
import { corruptPng } from './png-chunks.ts';

/** Receives a picture's bytes as they are unpacked. */
interface Taker {
  readonly isFull: boolean;
  take(piece: Uint8Array): void;
}

/**
 * Unpacks zlib data up to the place where they are damaged, or where other data follow.
 * @param pieceBytes - packed bytes per piece
 * @throws {VolumeViewError} `format/corrupt` if that is less than the picture
 */
export function unpackDamaged(packed: Uint8Array<ArrayBuffer>, picture: Taker, pieceBytes: number): void {
  try {
    const inflator = new Unzlib((piece) => picture.take(piece));
    for (let at = 0; at < packed.length && !picture.isFull; at += pieceBytes)
      inflator.push(packed.subarray(at, at + pieceBytes));
    if (!picture.isFull) inflator.push(new Uint8Array(0), true);
  } catch (cause) {
    throw corruptPng(`is damaged (${cause instanceof Error ? cause.message : String(cause)})`, { cause });
  }
}
