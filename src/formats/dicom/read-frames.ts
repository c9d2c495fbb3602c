// The frames of all files of a DICOM series.
import { VolumeViewError } from '../../core/errors.ts';
import type { Budget } from '../base/budget.ts';
import type { DecodeInput } from '../base/decoded-volume.ts';
import { unsupportedFile } from '../base/file-problem.ts';
import type { ReadContext } from '../base/format.ts';
import { checkFrames } from './decode-frame.ts';
import type { Frame } from './frame.ts';
import { count } from './group-frames.ts';
import type { ChosenFrames } from './group-frames.ts';
import { listFrames } from './list-frames.ts';
import { isSegmentation, readPicture } from './picture.ts';
import type { Picture } from './picture.ts';
import { isDicom } from './is-dicom.ts';
import { readDicomFile } from './read-file.ts';
import type { DicomFile } from './read-file.ts';

/** How messages name the files: without their own names. */
export const nameAll = (files: number): string =>
  files > 1 ? `the ${files.toLocaleString('en')} DICOM files` : 'the DICOM file';

export interface ReadFrames extends ChosenFrames {
  /** Where the only file is a segmentation, this file, and no frames. */
  readonly segmentation?: DicomFile;
}

/** The frames of all files, and what files are left out. */
export async function readFrames(input: DecodeInput, context: ReadContext, files: number): Promise<ReadFrames> {
  const { budget } = context;
  const frames: Frame[] = [];
  const refused: VolumeViewError[] = [];
  let segmentation: DicomFile | undefined;
  let [place, withoutPixels] = [0, 0];
  const read = ({ bytes }: DecodeInput): void => {
    const what = files > 1 ? `file ${++place} of ${files}` : 'the DICOM file';
    try {
      if (!isDicom(bytes))
        throw unsupportedFile(what, 'does not begin as DICOM does: it is damaged, cut short, or of another kind');
      const file = readDicomFile(bytes, budget, what);
      if (files === 1 && isSegmentation(file.set)) {
        segmentation = file;
        return;
      }
      const picture = readOne(file, budget, what);
      if (picture) frames.push(...listFrames(picture));
      else withoutPixels++;
    } catch (error) {
      // Folders hold pictures of other kinds too.
      if (!(error instanceof VolumeViewError && error.code === 'format/unsupported')) throw error;
      refused.push(error);
    }
  };
  read(input);
  if (segmentation) return { frames: [], left: [], segmentation };
  for await (const file of context.fetchFiles(context.further)) read(file);
  if (frames.length > 0) {
    return {
      frames,
      left: refused.length > 0 ? [`${count(refused.length, 'file')} of ${files}: ${refused[0].message}`] : [],
    };
  }
  throw (
    refused[0] ??
    unsupportedFile(
      nameAll(files),
      `hold${files > 1 ? '' : 's'} no picture: reports, plans and lists of files (DICOMDIR) have none. Choose the folder with the pictures${withoutPixels > 1 ? ', or all files in it' : ''}`,
    )
  );
}

/** Memory for what is known of one frame: a small file may have thousands. */
const describingBytes = 1500;

/** Memory that the file takes stays taken where it has pixels. */
function readOne(file: DicomFile, budget: Budget, what: string): Picture | null {
  const picture = readPicture(file, what);
  if (!picture) return null;
  if (picture.frames > 1) checkFrames(picture);
  budget.take(file.set.bytes.length + describingBytes * picture.frames, what);
  return picture;
}
