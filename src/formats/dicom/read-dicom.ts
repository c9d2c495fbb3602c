import { VolumeViewError } from '../../core/errors.ts';
import { cartesianGrid } from '../../volume/grid.ts';
import type { Budget } from '../base/budget.ts';
import type { DecodedCartesianVolume, DecodeInput } from '../base/decoded-volume.ts';
import { corruptFile, unsupportedFile } from '../base/file-problem.ts';
import type { FormatReader, ReadContext } from '../base/format.ts';
import { hostIsLittleEndian, numberTypes } from '../base/number-types.ts';
import { placeVolume } from '../base/place-volume.ts';
import { storeSamples, wholeNumbersOf } from '../base/store-samples.ts';
import { lostColors } from './colors.ts';
import { checkFrames } from './decode-frame.ts';
import type { Frame } from './frame.ts';
import { gatherSamples } from './gather-samples.ts';
import { modalityOf } from './modality.ts';
import { chooseFrames, count } from './group-frames.ts';
import type { ChosenFrames } from './group-frames.ts';
import { listFrames } from './list-frames.ts';
import { readPicture } from './picture.ts';
import { isDicom } from './is-dicom.ts';
import { readDicomFile } from './read-file.ts';
import { describeSeries } from './describe-series.ts';
import { stackFrames } from './stack-frames.ts';
import { tags } from './tags.ts';

/**
 * Reads the files of a DICOM series as one volume. Nothing of a file leaves this module but its values with their unit,
 * their place, their kind (such as CT) and their window: no name, no number of a patient, no date. Messages say 'file 12
 * of 300', because names of files may be those of patients.
 */
export const readDicom: FormatReader = async (input, settings, context) => {
  const files = 1 + context.further.length;
  try {
    const { frames, left } = await readFrames(input, context, files);
    const chosen = chooseFrames(frames, context.budget, settings.series);
    const series = chosen.series.length > 1 ? describeSeries(chosen, context.budget) : undefined;
    const volume = await joinFrames({ frames: chosen.frames, left: [...left, ...chosen.left] }, context);
    return placeVolume({ ...volume, series }, settings);
  } catch (cause) {
    // The usual words for such an error have the name of the file.
    if (!(cause instanceof RangeError || cause instanceof TypeError)) throw cause;
    throw corruptFile(nameAll(files), `can not be decoded (${cause.message}): damaged, or too large for this browser`);
  }
};

const nameAll = (files: number): string =>
  files > 1 ? `the ${files.toLocaleString('en')} DICOM files` : 'the DICOM file';

/** The frames of all files, and what files are left out. */
async function readFrames(input: DecodeInput, context: ReadContext, files: number): Promise<ChosenFrames> {
  const { budget } = context;
  const frames: Frame[] = [];
  const refused: VolumeViewError[] = [];
  let [place, withoutPixels] = [0, 0];
  const read = ({ bytes }: DecodeInput): void => {
    const what = files > 1 ? `file ${++place} of ${files}` : 'the DICOM file';
    try {
      if (!isDicom(bytes))
        throw unsupportedFile(what, 'does not begin as DICOM does: it is damaged, cut short, or of another kind');
      const picture = readOne(bytes, budget, what);
      if (picture) frames.push(...listFrames(picture));
      else withoutPixels++;
    } catch (error) {
      // Folders hold pictures of other kinds too.
      if (!(error instanceof VolumeViewError && error.code === 'format/unsupported')) throw error;
      refused.push(error);
    }
  };
  read(input);
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
function readOne(bytes: Uint8Array<ArrayBuffer>, budget: Budget, what: string): ReturnType<typeof readPicture> {
  const picture = readPicture(readDicomFile(bytes, budget, what), what);
  if (!picture) return null;
  if (picture.frames > 1) checkFrames(picture);
  budget.take(bytes.length + describingBytes * picture.frames, what);
  return picture;
}

async function joinFrames(
  { frames, left }: ChosenFrames,
  { budget, onProgress }: ReadContext,
): Promise<DecodedCartesianVolume> {
  const stack = stackFrames(frames);
  const { type, numbers, slope, intercept } = await gatherSamples(stack, budget, onProgress);
  const stored = storeSamples(new Uint8Array(numbers.buffer as ArrayBuffer), numberTypes[type], hostIsLittleEndian, {
    slope,
    intercept,
    budget,
    chooseWhole: await wholeNumbersOf(numberTypes[type]),
  });
  const [{ columns, rows, unit, picture }] = frames;
  const isAsStored = slope === 1 && intercept === 0;
  const isBurnedIn = frames.some((frame) => frame.picture.set.text(tags.burnedIn).toUpperCase() === 'YES');
  const window = frames[frames.length >> 1].window ?? frames.find((frame) => frame.window)?.window;
  const all = [
    ...(isBurnedIn
      ? [
          'WARNING: the file says that words are written into its pixels (BurnedInAnnotation), which may be a name: look before you show it to others',
        ]
      : []),
    ...(picture.colors ? [lostColors] : []),
    ...left,
    ...stack.left,
  ];
  const slices = stack.resample?.length ?? stack.slices.length;
  const modality = modalityOf(picture.set);
  return {
    grid: cartesianGrid([columns, rows, slices], stack.indexToWorld),
    anatomical: stack.anatomical,
    samples: stored.samples,
    slope: slope * stored.scale,
    intercept: slope * stored.offset + intercept,
    ...(isAsStored ? { indexed: stored.indexed, rounded: stored.rounded } : {}),
    unkept: stored.unkept,
    unit,
    format: ['DICOM', modality].filter(Boolean).join(', '),
    ...(all.length > 0 ? { left: all } : {}),
    ...(window ? { window } : {}),
    isUptake: modality === 'PT',
  };
}
