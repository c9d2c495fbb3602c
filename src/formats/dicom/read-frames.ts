// The frames of all files of a DICOM series.
import { VolumeViewError } from '../../core/errors.ts';
import type { DecodeInput } from '../base/decoded-volume.ts';
import { unsupportedFile } from '../base/file-problem.ts';
import type { ReadContext } from '../base/format.ts';
import { readAhead } from '../base/read-ahead.ts';
import { checkDamage, describeDamage, findDamage } from './damage.ts';
import type { Damage } from './damage.ts';
import { checkFrames } from './decode-frame.ts';
import type { Frame } from './frame.ts';
import { count } from './group-frames.ts';
import type { ChosenFrames } from './group-frames.ts';
import { isDicom } from './is-dicom.ts';
import { listFrames } from './list-frames.ts';
import { readStart } from './load-pixels.ts';
import { isSegmentation, isStructureSet, readPicture } from './picture.ts';
import type { Picture } from './picture.ts';
import { readDicomFile } from './read-file.ts';
import type { DicomFile } from './read-file.ts';
import { tags } from './tags.ts';
import { unpackFile } from './unpack-file.ts';

/** How messages name the files: without their own names. */
export const nameAll = (files: number): string =>
  files > 1 ? `the ${files.toLocaleString('en')} DICOM files` : 'the DICOM file';

export interface ReadFrames extends ChosenFrames {
  /** Where the only file is a segmentation, or has contours: this file, and no frames. */
  readonly labels?: DicomFile;
}

/** So many reasons why files are not shown are said. */
const maxReasons = 4;

/** Memory for what is known of one frame: a small file may have thousands. */
const describingBytes = 1500;

/**
 * The frames of all files, and what files are left out. Of files that are read in parts only what is before the pixels is read.
 * @throws {VolumeViewError} where no file has a picture, or most are damaged
 */
export async function readFrames(input: DecodeInput, context: ReadContext, files: number): Promise<ReadFrames> {
  const only = files === 1 && !context.folder ? readWhole(await unpack(input, context), context, nameOne(1, 1)) : null;
  if (only && (isSegmentation(only.set) || isStructureSet(only.set))) return { frames: [], left: [], labels: only };
  const frames: Frame[] = [];
  const refused: Refused[] = [];
  const damaged: Damage[] = [];
  let [place, withoutPixels, lists] = [0, 0, 0];
  for await (const read of only ? [() => findPicture(only, nameOne(1, 1))] : readPictures(input, context, files)) {
    const what = nameOne(++place, files);
    try {
      const picture = read();
      if (picture === 'list') lists++;
      else if (picture) {
        takeMemory(picture, context);
        frames.push(...listFrames(picture));
      } else withoutPixels++;
    } catch (error) {
      const damage = files > 1 ? findDamage(error, what) : null;
      if (damage) damaged.push(damage);
      // Folders hold pictures of other kinds too.
      else if (error instanceof VolumeViewError && error.code === 'format/unsupported') refused.push({ what, error });
      else throw error;
    }
  }
  checkDamage(damaged, files);
  if (frames.length > 0) {
    return {
      frames,
      left: [
        ...describeRefused(refused, files),
        ...(withoutPixels > 0
          ? [`${count(withoutPixels, 'file')} of ${files} without a picture: reports, plans and the like have none`]
          : []),
        ...describeDamage(damaged, 'left out'),
      ],
    };
  }
  throw (
    damaged[0]?.error ??
    (refused[0] as Refused | undefined)?.error ??
    unsupportedFile(
      nameAll(files),
      `hold${files > 1 ? '' : 's'} no picture: reports, plans and lists of files (DICOMDIR) have none. Choose the folder with the pictures${withoutPixels + lists > 1 ? ', or all files in it' : ''}`,
    )
  );
}

interface Refused {
  /** The file, as its message calls it. */
  readonly what: string;
  readonly error: VolumeViewError;
}

/** Files that are refused for the same reason are named once. */
function describeRefused(refused: readonly Refused[], files: number): string[] {
  const counts = new Map<string, { readonly message: string; count: number }>();
  for (const { what, error } of refused) {
    const reason = error.message.replace(what, '');
    const known = counts.get(reason);
    if (known) known.count++;
    else counts.set(reason, { message: error.message, count: 1 });
  }
  const words = [...counts.values()].map((one) => `${count(one.count, 'file')} of ${files}: ${one.message}`);
  return words.length > maxReasons ? [...words.slice(0, maxReasons), '…'] : words;
}

const nameOne = (place: number, files: number): string => (files > 1 ? `file ${place} of ${files}` : 'the DICOM file');

/** Yields for each file a function that gives what it has, or throws. */
async function* readPictures(input: DecodeInput, context: ReadContext, files: number): AsyncGenerator<() => Found> {
  const { further, folder } = context;
  if (!folder) {
    let place = 1;
    const first = await unpack(input, context);
    yield () => findPicture(readWhole(first, context, nameOne(1, files)), nameOne(1, files));
    for await (const file of context.fetchFiles(further)) {
      place++;
      const next = await unpack(file, context);
      yield () => findPicture(readWhole(next, context, nameOne(place, files)), nameOne(place, files));
    }
    return;
  }
  const read = async (url: string, i: number): Promise<Found> => {
    const what = nameOne(i + 1, files);
    const picture =
      (await readStart(url, context, what)) ??
      findPicture(readWhole(await unpack(await folder.readWhole(url), context), context, what), what);
    if (!picture || picture === 'list') return picture;
    // Else its bytes are kept.
    return folder.sourceOf(url) === null ? picture : { ...picture, file: url };
  };
  for await (const one of readAhead([input.url, ...further], read)) {
    yield () => {
      if (one.status === 'rejected') throw one.reason;
      return one.value;
    };
  }
}

/** A file may be packed with gzip. */
const unpack = async (input: DecodeInput, { budget }: ReadContext): Promise<DecodeInput> => ({
  ...input,
  bytes: await unpackFile(input.bytes, budget, 'the DICOM file'),
});

function readWhole({ bytes }: DecodeInput, { budget }: ReadContext, what: string): DicomFile {
  if (!isDicom(bytes))
    throw unsupportedFile(what, 'does not begin as DICOM does: it is damaged, cut short, or of another kind');
  return readDicomFile(bytes, budget, what);
}

/** What a file has: a picture, nothing of that kind, or a list of other files (DICOMDIR), which every disk of a hospital has. */
type Found = Picture | 'list' | null;

/** Media Storage Directory Storage. Source: PS3.4, annex B.5 */
const listOfFiles = '1.2.840.10008.1.3.10';

function findPicture(file: DicomFile, what: string): Found {
  if (file.set.has(tags.firstRecord) || file.set.text(tags.sopClass) === listOfFiles) return 'list';
  const picture = readPicture(file, what);
  if (picture && picture.frames > 1) checkFrames(picture);
  return picture;
}

/** Memory of what was read of a file stays taken where it has pixels. That of unpacked ones is taken already. */
function takeMemory({ set, syntax, frames, what }: Picture, { budget }: ReadContext): void {
  budget.take((syntax.isDeflated ? 0 : set.bytes.length) + describingBytes * frames, what);
}
