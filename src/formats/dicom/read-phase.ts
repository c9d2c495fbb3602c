// One of several times, of its own files. Loaded when it is shown.
import type { DecodedCartesianVolume } from '../base/decoded-volume.ts';
import { corruptFile } from '../base/file-problem.ts';
import { readAhead } from '../base/read-ahead.ts';
import { hasFiles } from '../base/scan-data.ts';
import type { FramesOfFile, ScanFiles, ScanOfVolume } from '../base/scan-data.ts';
import type { ScanAccess } from '../series/read-scan.ts';
import { FrameReader } from './frame-places.ts';
import type { Frame } from './frame.ts';
import { joinFrames } from './join-frames.ts';
import { listFrames } from './list-frames.ts';
import { withPixels } from './load-pixels.ts';
import { readPicture } from './picture.ts';
import { readDicomFile } from './read-file.ts';
import { unpackFile } from './unpack-file.ts';

/**
 * Decodes one time of a series.
 * @throws {VolumeViewError} `format/corrupt` where a file is not the one that was opened, and what fetching throws; messages
 * have the number of a file, and no name
 */
export async function readPhase(
  { from, format, series }: ScanOfVolume,
  access: ScanAccess,
): Promise<DecodedCartesianVolume> {
  if (!hasFiles(from)) throw new TypeError(`${format} has no files`);
  const { onProgress = () => undefined } = access;
  const pictures: Frame[][] = [];
  const reader = new FrameReader();
  const total = from.files.length;
  const read = (file: ScanFiles['files'][number], i: number): Promise<Frame[]> =>
    readFile(file, `file ${i + 1} of ${total} of this time`, { ...access, reader });
  for await (const one of readAhead(from.files, read)) {
    if (one.status === 'rejected') throw one.reason;
    pictures.push(one.value);
    onProgress(pictures.length, 2 * total);
  }
  const frames = from.slices.map(([file, picture]) => pictures[file][picture]);
  if (frames.includes(undefined as never)) throw changed(`the files of ${format}`);
  const context = {
    budget: access.budget,
    onProgress: (done: number, all: number) => onProgress(all + done, 2 * all),
  };
  return joinFrames({ frames, left: [] }, {}, context, { ...series, format });
}

type FrameAccess = ScanAccess & { readonly reader: FrameReader };

/** The frames of a file; of those that are not read there is no more than what the file says of them. */
async function readFile(file: ScanFiles['files'][number], what: string, access: FrameAccess): Promise<Frame[]> {
  if (typeof file === 'object' && 'frames' in file) return readSome(file, what, access);
  const { budget, fetchFile } = access;
  const given = typeof file === 'string' ? (await fetchFile(file)).bytes : await readBlob(file, what);
  budget.addFile(given.length);
  const bytes = await unpackFile(given, budget, what);
  const picture = readPicture(readDicomFile(bytes, budget, what), what);
  if (!picture) throw changed(what);
  return listFrames(picture);
}

async function readSome(
  { file, pixels, parts, frames }: FramesOfFile,
  what: string,
  { budget, fetchPixels, fetchFile, reader }: FrameAccess,
): Promise<Frame[]> {
  const start = await readBlob(file, what);
  const bytes = parts ? await reader.read(start, parts, (range) => fetchFile(parts.url, range), what) : start;
  budget.addFile(bytes.length);
  const read = readDicomFile(bytes, budget, what, pixels ? 1 : 0);
  const picture = readPicture(read, what);
  if (!picture) throw changed(what);
  const fetched = pixels && (await fetchPixels!(pixels)).bytes;
  budget.addFile(fetched?.length ?? 0);
  const there = withPixels(picture, fetched ? readDicomFile(fetched, budget, what) : read, frames.length);
  return listFrames(picture).map((frame) => ({ ...frame, picture: there, index: frames.indexOf(frame.index) }));
}

async function readBlob(file: Blob, what: string): Promise<Uint8Array<ArrayBuffer>> {
  const buffer = await file.arrayBuffer().catch((): never => {
    throw changed(what);
  });
  return new Uint8Array(buffer);
}

const changed = (what: string): Error =>
  corruptFile(
    what,
    'can not be read any longer: moved, changed or removed since it was opened. Choose the files again',
  );
