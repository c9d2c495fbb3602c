// Pixels of files of which only the start was read.
import type { Budget } from '../base/budget.ts';
import { corruptFile } from '../base/file-problem.ts';
import { keptBytes } from '../base/format.ts';
import type { FolderAccess, ReadContext } from '../base/format.ts';
import { usualAhead } from '../base/read-ahead.ts';
import { checkFrames, frameBytes } from './decode-frame.ts';
import { findFramePlaces, FrameReader } from './frame-places.ts';
import type { ReadRange } from './frame-places.ts';
import type { Frame } from './frame.ts';
import { readPicture } from './picture.ts';
import type { Picture } from './picture.ts';
import { readDicomFile } from './read-file.ts';
import type { DicomFile } from './read-file.ts';

/** Bytes of each try to have all of a file that lies before its pixels. */
const tries = [keptBytes, 2 ** 18, 2 ** 22];

/** The last try is only worth it where the file has many times as many bytes: what is before its pixels describes many frames. */
const minTimes = 4;

type Files = Pick<ReadContext, 'folder' | 'budget'>;

/**
 * Reads what a file says of its picture, without its pixels.
 * @returns null where it is better to read the whole file: it has several frames that can't be read alone, or its start is in an unusual form
 */
export async function readStart(url: string, { folder, budget }: Files, what: string): Promise<Picture | null> {
  for (const length of tries) {
    const { bytes, missing = 0, packedBytes } = await folder!.readStart(url, length);
    // The rest is there, and will be read if it is needed.
    if (length === keptBytes) budget.addFile(packedBytes ?? bytes.length + missing);
    if (missing === 0) return null;
    const isLarge = bytes.length + missing >= minTimes * tries[2];
    const start = findPixels(bytes, budget, what);
    if (start === null && length === tries[1] && !isLarge) return null;
    if (start === null) continue;
    // Only what is before the pixels stays in memory.
    const kept = bytes.slice(0, start);
    const picture = readPicture(readDicomFile(kept, budget, what, bytes.length + missing - start), what);
    return picture && withPlaces({ ...picture, url, file: url }, folder!);
  }
  return null;
}

/** Of several frames each has to be had alone. */
async function withPlaces(picture: Picture, { frames, parts }: FolderAccess): Promise<Picture | null> {
  if (picture.frames === 1 || frames) return picture;
  checkFrames(picture);
  const url = picture.url!;
  const size = parts?.sizeOf(url) ?? null;
  const places = size === null ? null : await findFramePlaces(picture, size, (range) => parts!.read(url, range));
  return places && { ...picture, places };
}

/** Where the pixels begin; null where they do not begin in these bytes. */
function findPixels(bytes: Uint8Array<ArrayBuffer>, budget: Budget, what: string): number | null {
  try {
    // All of it counts as missing: fragments are not looked for.
    const { pixels, syntax } = readDicomFile(bytes, budget, what, 1);
    return syntax.isDeflated || !pixels || pixels.start > bytes.length ? null : pixels.start;
  } catch {
    return null; // An element goes beyond them, or is damaged, which reading the whole file says.
  }
}

/** At most so many frames, and so many bytes of them without packing, are read at once. */
const framesAtOnce = { count: 64, bytes: 2 ** 22 };

/** What is read at once: a whole file, or some frames of a file. It is kept until all of them were taken. */
interface Part {
  readonly picture: Picture;
  readonly frames: Frame[];
  readonly isWhole: boolean;
  coming?: Promise<Picture>;
}

/** Loads the pixels of frames, where only the start of their files was read. */
export class PixelLoader {
  /** Of each frame that was not taken yet. */
  readonly #parts = new Map<Frame, Part>();
  readonly #frames = new FrameReader();
  /** How many frames are to be asked for before the first of them is there. */
  readonly ahead: number;

  /**
   * @param order - in which the frames are asked for
   * @param early - so many of them are shown before the others are read
   */
  constructor(
    order: readonly Frame[],
    early: number,
    private readonly files: Files,
  ) {
    const { folder } = files;
    const open = new Map<Picture, Part>();
    const counts = new Map<Picture, number>();
    for (const { picture } of order) counts.set(picture, (counts.get(picture) ?? 0) + 1);
    // Tiles of one frame need all of it, whatever their number. Of a file that is had in parts, most frames are had sooner with all.
    const isWhole = (picture: Picture): boolean =>
      picture.frames === 1 || (picture.places !== undefined && counts.get(picture)! > picture.frames / 2);
    let largest = 1;
    for (const [i, frame] of order.entries()) {
      const { picture } = frame;
      if (i === early) for (const [one, part] of open) if (!part.isWhole) open.delete(one);
      if (picture.url === null) continue;
      let part = open.get(picture);
      if (!part || (!part.isWhole && part.frames.length === countAtOnce(picture)))
        open.set(picture, (part = { picture, frames: [], isWhole: isWhole(picture) }));
      part.frames.push(frame);
      largest = Math.max(largest, part.frames.length);
      this.#parts.set(frame, part);
    }
    const urls = new Set(order.map(({ picture }) => picture.url).filter((url) => url !== null));
    this.ahead = Math.max(folder?.plan([...urls]) ?? usualAhead, urls.size > 0 ? usualAhead * largest : 1);
  }

  /**
   * A frame with its pixels.
   * @throws {VolumeViewError} `format/corrupt` where the file ends early, and what reading it throws
   */
  async load(frame: Frame): Promise<Frame> {
    const part = this.#parts.get(frame);
    if (!part) return frame;
    this.#parts.delete(frame);
    const picture = await (part.coming ??= this.#read(part));
    return { ...frame, picture, index: part.isWhole ? frame.index : part.frames.indexOf(frame) };
  }

  async #read({ picture, frames, isWhole }: Part): Promise<Picture> {
    const { folder, budget } = this.files;
    const { url, what, places, set } = picture;
    if (isWhole) {
      const { bytes } = await folder!.readWhole(url!);
      return withPixels(picture, readDicomFile(bytes, budget, what), picture.frames);
    }
    if (places) {
      const { isPacked } = places;
      const ranges = frames.map(({ index }) => places.ranges[index]);
      const read: ReadRange = (range) => folder!.parts!.read(url!, range);
      const bytes = await this.#frames.read(set.bytes, { ranges, isPacked }, read, what);
      return withPixels(picture, readDicomFile(bytes, budget, what), frames.length);
    }
    const indices = frames.map(({ index }) => index);
    const { bytes } = await folder!.frames!.read(url!, indices);
    return withPixels(picture, readDicomFile(bytes, budget, what), indices.length);
  }
}

/** How many frames of a file are read at once. */
export const countAtOnce = (picture: Picture): number =>
  Math.max(1, Math.min(framesAtOnce.count, Math.floor(framesAtOnce.bytes / frameBytes(picture))));

/**
 * A picture with the pixels of its file, or of some of its frames.
 * @param read - what has the pixels
 * @param frames - how many frames they are
 * @throws {VolumeViewError} `format/corrupt` where they end early
 */
export function withPixels(
  picture: Picture,
  { pixels, syntax, file }: Pick<DicomFile, 'pixels' | 'syntax' | 'file'>,
  frames: number,
): Picture {
  const { what, set } = picture;
  if (!pixels)
    throw corruptFile(what, 'has no pixels any longer: it was changed while it was read. Choose the files again');
  // A server may say with the pixels how they are packed, on which the colours of a picture depend.
  const known = syntax.packing === picture.syntax.packing ? picture : readPicture({ set, pixels, syntax, file }, what)!;
  const whole = { ...known, syntax, pixels, frames, url: null };
  checkFrames(whole);
  return whole;
}
