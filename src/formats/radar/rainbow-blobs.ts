import type { Budget } from '../base/budget.ts';
import { corruptFile } from '../base/file-problem.ts';
import { takeDuring } from '../base/take-during.ts';
import { DeflateError, Inflater } from '../codecs/inflate.ts';
import { isZlib } from '../codecs/unzlib.ts';
import { what } from './rainbow-header.ts';

/** A tag is no longer than this. */
const longestTag = 256;

/** More blobs than sweeps and quantities of any radar have. */
const maxBlobs = 10_000;

/** Packed numbers, by what the header calls them. */
export type RainbowBlobs = ReadonlyMap<
  number,
  { readonly packed: Uint8Array<ArrayBuffer>; readonly isPacked: boolean }
>;

/**
 * Lists the blobs after a header. Those of a file that was cut short are listed as far as they are whole.
 * @param from - where they begin
 * @throws {VolumeViewError} `format/corrupt`, `format/too-large`
 */
export function listBlobs(bytes: Uint8Array<ArrayBuffer>, from: number): { blobs: RainbowBlobs; isCut: boolean } {
  const blobs = new Map<number, { packed: Uint8Array<ArrayBuffer>; isPacked: boolean }>();
  const decoder = new TextDecoder('latin1');
  let at = from;
  while (blobs.size < maxBlobs) {
    const text = decoder.decode(bytes.subarray(at, at + longestTag));
    const tag = /^\s*<BLOB\s([^>]*)>\r?\n?/.exec(text);
    if (!tag) break;
    const [id, size, compression] = ['blobid', 'size', 'compression'].map(
      (name) => new RegExp(`${name}="([^"]*)"`).exec(tag[1])?.[1] ?? '',
    );
    const start = at + tag[0].length;
    const end = start + Number(size);
    if (!/^\d+$/.test(id) || !/^\d+$/.test(size) || !['qt', 'none', ''].includes(compression))
      throw corruptFile(
        what,
        `got the part <BLOB ${tag[1].slice(0, 80)}>; expected a number, a size and the packing qt`,
      );
    if (end > bytes.length) return { blobs, isCut: true };
    blobs.set(Number(id), { packed: bytes.subarray(start, end), isPacked: compression === 'qt' });
    const close = /^\s*<\/BLOB>/.exec(decoder.decode(bytes.subarray(end, end + 32)));
    at = end + (close?.[0].length ?? 0);
  }
  return { blobs, isCut: false };
}

/**
 * Unpacks one.
 * @param length - bytes that the header needs
 * @throws {VolumeViewError} `format/corrupt`, `format/too-large` before more than these are unpacked
 */
export function readBlob(blobs: RainbowBlobs, id: number, length: number, budget: Budget): Uint8Array<ArrayBuffer> {
  const blob = blobs.get(id);
  if (!blob) throw corruptFile(what, `lacks its part ${id}; the file is cut short`);
  const { packed, isPacked } = blob;
  if (!isPacked) return checkLength(packed, id, length);
  // Four bytes say how many there are, unpacked; then come zlib's.
  if (!isZlib(packed.subarray(4))) throw corruptFile(what, `has a part ${id} that is no zlib data`);
  return takeDuring(budget, { bytes: length, what }, () => {
    const unpacked = new Uint8Array(length);
    let at = 0;
    try {
      for (const piece of new Inflater().unpack(packed, 6)) {
        unpacked.set(piece.subarray(0, length - at), at);
        at += piece.length;
        if (at >= length) break;
      }
    } catch (cause) {
      if (!(cause instanceof DeflateError)) throw cause;
      throw corruptFile(what, `has a part ${id} that ${cause.message}`);
    }
    return checkLength(unpacked.subarray(0, at), id, length);
  });
}

function checkLength(bytes: Uint8Array<ArrayBuffer>, id: number, length: number): Uint8Array<ArrayBuffer> {
  if (bytes.length >= length) return bytes.subarray(0, length);
  throw corruptFile(what, `has ${bytes.length} bytes in its part ${id}; expected ${length}`);
}
