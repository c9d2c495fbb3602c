// One volume of frames.
import { cartesianGrid } from '../../volume/grid.ts';
import type { DecodedCartesianVolume, DecodeSettings } from '../base/decoded-volume.ts';
import type { ReadContext } from '../base/format.ts';
import { hostIsLittleEndian, numberTypes } from '../base/number-types.ts';
import { placeVolume } from '../base/place-volume.ts';
import type { SeriesInfo } from '../base/scan-data.ts';
import { storeSamples, wholeNumbersOf } from '../base/store-samples.ts';
import { chooseFirst, coarsenGrid, cutCoarsePart } from './coarse-part.ts';
import { describeFiles } from './describe-files.ts';
import { areInColors, gatherSamples } from './gather-samples.ts';
import type { Gathered } from './gather-samples.ts';
import type { ChosenFrames } from './group-frames.ts';
import { storeCounted } from './number-counts.ts';
import { stackFrames } from './stack-frames.ts';
import type { Stack } from './stack-frames.ts';

/** @returns the number of slices that a stack is shown with */
export const countSlices = ({ resample, slices }: Stack): number => resample?.length ?? slices.length;

/**
 * Decodes frames. Of those in a folder a small volume of some is shown first.
 * @param info - what is said of the volume, with its grid; that of these frames if undefined
 * @throws {VolumeViewError} as stackFrames and gatherSamples say
 */
export async function joinFrames(
  { frames, left }: ChosenFrames,
  settings: DecodeSettings,
  context: Pick<ReadContext, 'budget' | 'folder' | 'onProgress'>,
  info?: SeriesInfo,
): Promise<DecodedCartesianVolume> {
  const stack = stackFrames(frames);
  const { folder } = context;
  const [{ columns, rows }] = frames;
  const slices = countSlices(stack);
  const grid = info?.grid ?? cartesianGrid([columns, rows, slices], stack.indexToWorld);
  const describe = (...more: (readonly string[])[]): SeriesInfo => {
    const all = (info ? [info.left ?? [], ...more] : [left, stack.left, ...more]).flat();
    return info
      ? { ...info, left: all.length > 0 ? all : undefined }
      : describeFiles({ frames, left: all }, stack.anatomical, grid);
  };
  const gathered = await gatherSamples(stack, context, {
    // Slices that are computed between others need all of them; without colours the first picture would have another look.
    first: folder && !stack.resample && !areInColors(frames) ? chooseFirst(slices) : [],
    onFirst: async (some) => {
      const numbers = cutCoarsePart(some, grid.dimensions);
      const part = placeVolume(await storeNumbers(describe(), { ...some, numbers }, context), settings);
      await folder!.showPart({ ...part, grid: coarsenGrid(part.grid) }, part.grid);
    },
  });
  return placeVolume(await storeNumbers(describe(gathered.left), gathered, context), settings);
}

/** The numbers as samples. */
async function storeNumbers(
  info: SeriesInfo,
  { type, numbers, slope, intercept, rgb, counts }: Omit<Gathered, 'left'>,
  { budget }: Pick<ReadContext, 'budget'>,
): Promise<DecodedCartesianVolume> {
  const colors: Pick<DecodedCartesianVolume, 'colors'> = rgb
    ? { colors: { rgb, range: [intercept, 255 * slope + intercept] } }
    : {};
  const counted =
    counts && (numbers instanceof Int16Array || numbers instanceof Uint16Array) ? storeCounted(numbers, counts) : null;
  if (counted) {
    const { samples, offset } = counted;
    return {
      ...info,
      samples,
      slope,
      intercept: slope * offset + intercept,
      counts: counted.counts,
      ...colors,
    };
  }
  const stored = storeSamples(new Uint8Array(numbers.buffer as ArrayBuffer), numberTypes[type], hostIsLittleEndian, {
    slope,
    intercept,
    budget,
    chooseWhole: await wholeNumbersOf(numberTypes[type]),
  });
  const isAsStored = slope === 1 && intercept === 0;
  return {
    ...info,
    samples: stored.samples,
    slope: slope * stored.scale,
    intercept: slope * stored.offset + intercept,
    ...(isAsStored ? { indexed: stored.indexed, rounded: stored.rounded } : {}),
    unkept: stored.unkept,
    ...colors,
  };
}
