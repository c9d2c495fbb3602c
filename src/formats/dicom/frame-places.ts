// Frames of a file that are read without the others, in parts from its server.
import type { DecodeInput } from '../base/decoded-volume.ts';
import { corruptFile } from '../base/file-problem.ts';
import { joinPieces } from '../base/join-pieces.ts';
import { Queue } from '../base/queue.ts';
import type { FileRange, FramePlaces } from '../base/scan-data.ts';
import { frameBytes, isInPairs } from './decode-frame.ts';
import type { Picture } from './picture.ts';
import { itemTags } from './tags.ts';

/** Reads a part of the file. */
export type ReadRange = (range: FileRange) => Promise<Pick<DecodeInput, 'bytes'>>;

/** Frames with fewer bytes between them are read together: another request takes longer than these bytes. */
const maxGap = 2 ** 16;

/** Bytes of a request for several frames. */
const maxTogether = 2 ** 22;

/** The number of requests at a time, for all frames of a volume. */
const maxRequests = 6;

/**
 * Finds the frames of a file of which only what is before its pixels was read.
 * @param fileBytes - of the whole file
 * @returns null where the file does not say where each frame begins: then it has to be read as a whole
 */
export async function findFramePlaces(
  picture: Picture,
  fileBytes: number,
  read: ReadRange,
): Promise<FramePlaces | null> {
  const { pixels, frames } = picture;
  const from = pixels.start;
  if (pixels.bytes) {
    const size = frameBytes(picture);
    if (isInPairs(picture) && size % 2 === 1) return null; // Two frames share a pair of bytes.
    const ranges = Array.from({ length: frames }, (_, i) => ({ start: from + i * size, end: from + (i + 1) * size }));
    return { ranges, isPacked: false };
  }
  const { bytes } = await read({ start: from, end: Math.min(fileBytes, from + itemBytes + 4 * frames) });
  const starts = readOffsets(bytes, frames);
  if (!starts) return null;
  const ranges = starts.map((start, i) => ({
    start: from + bytes.length + start,
    end: i + 1 < frames ? from + bytes.length + starts[i + 1] : fileBytes,
  }));
  return ranges.every(({ start, end }) => end > start && end <= fileBytes) ? { ranges, isPacked: true } : null;
}

/** Bytes before a piece of packed pixels: a mark, and its length. Source: DICOM PS3.5, 7.5 */
const itemBytes = 8;

/** The first piece has the place of each frame, after itself; or none. Source: PS3.5, A.4 */
function readOffsets(bytes: Uint8Array<ArrayBuffer>, frames: number): number[] | null {
  if (bytes.length !== itemBytes + 4 * frames) return null;
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
  if (readMark(view, 0) !== itemTags.item || view.getUint32(4, true) !== 4 * frames) return null;
  return Array.from({ length: frames }, (_, i) => view.getUint32(itemBytes + 4 * i, true));
}

const readMark = (view: DataView, at: number): number =>
  view.getUint16(at, true) * 0x10000 + view.getUint16(at + 2, true);

/** Reads frames, some of them together, a few requests at a time. */
export class FrameReader {
  readonly #requests = new Queue(maxRequests);

  /**
   * @param head - the file up to its pixels
   * @param what - for messages: 'file 12 of 300'
   * @returns a file of these frames alone, in their order
   * @throws {VolumeViewError} `format/corrupt` where they are not there any longer, and what reading throws
   */
  async read(
    head: Uint8Array<ArrayBuffer>,
    { ranges, isPacked }: FramePlaces,
    read: ReadRange,
    what: string,
  ): Promise<Uint8Array<ArrayBuffer>> {
    const frames: Uint8Array<ArrayBuffer>[] = [];
    const readGroup = async ({ start, end, members }: Group): Promise<void> => {
      const { bytes } = await this.#requests.run(() => read({ start, end }));
      if (bytes.length !== end - start)
        throw corruptFile(
          what,
          `sent ${bytes.length.toLocaleString('en')} bytes of its frames; expected ${(end - start).toLocaleString('en')}: it has changed since it was opened, or is cut short. Load it again`,
        );
      for (const i of members) frames[i] = bytes.subarray(ranges[i].start - start, ranges[i].end - start);
    };
    await Promise.all(groupRanges(ranges).map(readGroup));
    return joinPieces([head, ...(isPacked ? writePacked(frames) : frames)]);
  }
}

interface Group {
  readonly start: number;
  end: number;
  /** By their places among the ranges. */
  readonly members: number[];
}

function groupRanges(ranges: readonly FileRange[]): Group[] {
  const order = [...ranges.keys()];
  order.sort((a, b) => ranges[a].start - ranges[b].start);
  const groups: Group[] = [];
  for (const i of order) {
    const { start, end } = ranges[i];
    const last = groups.at(-1);
    if (last && start - last.end <= maxGap && end - last.start <= maxTogether) {
      last.end = Math.max(last.end, end);
      last.members.push(i);
    } else groups.push({ start, end, members: [i] });
  }
  return groups;
}

/** Frames in pieces, after a list of where each begins. */
function writePacked(frames: readonly Uint8Array<ArrayBuffer>[]): Uint8Array<ArrayBuffer>[] {
  const pieces = frames.map(cutAfterPieces);
  const list = new DataView(new ArrayBuffer(itemBytes + 4 * pieces.length));
  list.setUint16(0, itemTags.item >>> 16, true);
  list.setUint16(2, itemTags.item & 0xffff, true);
  list.setUint32(4, 4 * pieces.length, true);
  let at = 0;
  for (const [i, { length }] of pieces.entries()) {
    list.setUint32(itemBytes + 4 * i, at, true);
    at += length;
  }
  return [new Uint8Array(list.buffer), ...pieces];
}

/** Behind the last frame of a file is the mark of its end, and may be other elements. */
function cutAfterPieces(frame: Uint8Array<ArrayBuffer>): Uint8Array<ArrayBuffer> {
  const view = new DataView(frame.buffer, frame.byteOffset, frame.length);
  let at = 0;
  while (at + itemBytes <= frame.length && readMark(view, at) === itemTags.item)
    at += itemBytes + view.getUint32(at + 4, true);
  return frame.subarray(0, Math.min(at, frame.length));
}
