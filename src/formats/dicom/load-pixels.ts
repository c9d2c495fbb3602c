// Pixels of files of which only the start was read.
import type { Budget } from '../base/budget.ts';
import { corruptFile } from '../base/file-problem.ts';
import { keptBytes } from '../base/format.ts';
import type { ReadContext } from '../base/format.ts';
import { checkFrames } from './decode-frame.ts';
import { listFrames } from './list-frames.ts';
import { readPicture } from './picture.ts';
import type { Picture } from './picture.ts';
import { readDicomFile } from './read-file.ts';

/** Bytes of the first and the second try to have all of a file that lies before its pixels. */
const tries = [keptBytes, 2 ** 18];

type Files = Pick<ReadContext, 'folder' | 'budget'>;

/**
 * Reads what a file says of its picture, without its pixels.
 * @returns null where it is better to read the whole file: it has several pictures, or its start is in an unusual form
 */
export async function readStart(url: string, { folder, budget }: Files, what: string): Promise<Picture | null> {
  for (const length of tries) {
    const { bytes, missing = 0, packedBytes } = await folder!.readStart(url, length);
    // The rest is there, and will be read if it is needed.
    if (length === keptBytes) budget.addFile(packedBytes ?? bytes.length + missing);
    if (missing === 0) return null;
    const start = findPixels(bytes, budget, what);
    if (start === null) continue;
    // Only what is before the pixels stays in memory.
    const kept = bytes.slice(0, start);
    const picture = readPicture(readDicomFile(kept, budget, what, bytes.length + missing - start), what);
    return picture?.frames === 1 && listFrames(picture).length === 1 ? { ...picture, url, file: url } : null;
  }
  return null;
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

/**
 * A picture with its pixels.
 * @throws {VolumeViewError} `format/corrupt` where the file ends early, and what reading it throws
 */
export async function loadPixels(picture: Picture, { folder, budget }: Files): Promise<Picture> {
  const { url, what } = picture;
  if (url === null) return picture;
  const { bytes } = await folder!.readWhole(url);
  const file = readDicomFile(bytes, budget, what);
  const { pixels, syntax } = file;
  if (!pixels)
    throw corruptFile(what, 'has no pixels any longer: it was changed while it was read. Choose the files again');
  // A server may say with the pixels how they are packed, on which the colours of a picture depend.
  const known = syntax.packing === picture.syntax.packing ? picture : readPicture(file, what)!;
  const whole = { ...known, pixels, url: null };
  checkFrames(whole);
  return whole;
}
