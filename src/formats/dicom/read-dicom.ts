import { cartesianGrid } from '../../volume/grid.ts';
import type { CartesianGrid } from '../../volume/grid.ts';
import type { DecodedCartesianVolume, DecodeSettings } from '../base/decoded-volume.ts';
import { corruptFile } from '../base/file-problem.ts';
import type { FormatReader, ReadContext } from '../base/format.ts';
import { loadReader } from '../base/load-reader.ts';
import { hostIsLittleEndian, numberTypes } from '../base/number-types.ts';
import { placeVolume } from '../base/place-volume.ts';
import { storeSamples, wholeNumbersOf } from '../base/store-samples.ts';
import { chooseFirst, coarsenGrid, cutCoarsePart, minSlices } from './coarse-part.ts';
import type { Frame } from './frame.ts';
import { gatherSamples } from './gather-samples.ts';
import type { Gathered } from './gather-samples.ts';
import { chooseFrames } from './group-frames.ts';
import type { ChosenFrames } from './group-frames.ts';
import { describeFiles } from './describe-files.ts';
import { describeSeries } from './describe-series.ts';
import { joinPhases } from './join-phases.ts';
import { nameAll, readFrames } from './read-frames.ts';
import { stackFrames } from './stack-frames.ts';

/**
 * Reads the files of a DICOM series as one volume. Nothing of a file leaves this module but its values with their unit,
 * their place, their kind (such as CT) and their window: no name, no number of a patient, no date. Messages say 'file 12
 * of 300', because names of files may be those of patients.
 */
export const readDicom: FormatReader = async (input, settings, given) => {
  const urls = [input.url, ...given.further];
  const files = urls.length;
  try {
    // Of a list that is read at once, files are fetched but once.
    const folder = given.folder ?? (files < minSlices ? undefined : await given.openList?.(input, urls));
    const context = { ...given, folder };
    const { frames, left, labels } = await readFrames(input, context, files);
    if (labels) {
      const { readLabels } = await loadReader(() => import('./read-labels.ts'));
      return placeVolume(await readLabels(labels, context), settings);
    }
    const chosen = chooseFrames(frames, context.budget, settings.series);
    const phases = settings.scan && !context.isPart ? chosen.phases : undefined;
    expectFiles(phases ? phases.frames.flat() : chosen.frames, context);
    const series = chosen.series.length > 1 ? await describeSeries(chosen, context) : undefined;
    const scans =
      phases && (await joinPhases({ ...phases, left: [...left, ...phases.left] }, settings, context, describeFiles));
    const volume =
      scans ?? (await joinFrames({ frames: chosen.frames, left: [...left, ...chosen.left] }, settings, context));
    return { ...volume, series };
  } catch (cause) {
    // The usual words for such an error have the name of the file.
    if (!(cause instanceof RangeError || cause instanceof TypeError)) throw cause;
    throw corruptFile(nameAll(files), `can not be decoded (${cause.message}): damaged, or too large for this browser`);
  }
};

function expectFiles(frames: readonly Frame[], { folder }: ReadContext): void {
  folder?.expect(frames.map(({ picture }) => picture.url).filter((url) => url !== null));
}

async function joinFrames(
  { frames, left }: ChosenFrames,
  settings: DecodeSettings,
  context: ReadContext,
): Promise<DecodedCartesianVolume> {
  const stack = stackFrames(frames);
  const { folder } = context;
  const [{ columns, rows }] = frames;
  const slices = stack.resample?.length ?? stack.slices.length;
  const place = (volume: DecodedCartesianVolume): DecodedCartesianVolume => placeVolume(volume, settings);
  const whole = cartesianGrid([columns, rows, slices], stack.indexToWorld);
  const gathered = await gatherSamples(stack, context, {
    // Slices that are computed between others need all of them.
    first: folder && !stack.resample ? chooseFirst(slices) : [],
    onFirst: async (some) => {
      const numbers = cutCoarsePart(some, whole.dimensions);
      const part = place(
        await describeVolume({ frames, left: [] }, stack.anatomical, { ...some, numbers, grid: whole }, context),
      );
      await folder!.showPart({ ...part, grid: coarsenGrid(part.grid) }, part.grid);
    },
  });
  const all = [...left, ...stack.left, ...gathered.left];
  return place(await describeVolume({ frames, left: all }, stack.anatomical, { ...gathered, grid: whole }, context));
}

/** The numbers as samples, and what their files say of them. */
async function describeVolume(
  files: ChosenFrames,
  anatomical: boolean,
  { type, numbers, slope, intercept, grid }: Omit<Gathered, 'left'> & { readonly grid: CartesianGrid },
  { budget }: ReadContext,
): Promise<DecodedCartesianVolume> {
  const stored = storeSamples(new Uint8Array(numbers.buffer as ArrayBuffer), numberTypes[type], hostIsLittleEndian, {
    slope,
    intercept,
    budget,
    chooseWhole: await wholeNumbersOf(numberTypes[type]),
  });
  const isAsStored = slope === 1 && intercept === 0;
  return {
    ...describeFiles(files, anatomical, grid),
    samples: stored.samples,
    slope: slope * stored.scale,
    intercept: slope * stored.offset + intercept,
    ...(isAsStored ? { indexed: stored.indexed, rounded: stored.rounded } : {}),
    unkept: stored.unkept,
  };
}
