import { VolumeViewError } from '../../core/errors.ts';
import { cartesianGrid } from '../../volume/grid.ts';
import { fitVolume } from '../../volume/reduce.ts';
import type { DeviceLimits } from '../../volume/reduce.ts';
import type { Budget } from '../base/budget.ts';
import { chooseScan } from '../base/choose-scan.ts';
import { countSampleBytes } from '../base/count-sample-bytes.ts';
import type { DecodedCartesianVolume, DecodeSettings, ProgressListener } from '../base/decoded-volume.ts';
import type { ScansListener } from '../base/load-request.ts';
import { placeVolume } from '../base/place-volume.ts';
import { storeSamples, wholeNumbersOf } from '../base/store-samples.ts';
import { timeAt } from '../series/scan-times.ts';
import { chooseLevel, coarseEnough, countVoxels, cutLevel, detailOf, isReadable, worldOfBox } from './choose-level.ts';
import type { LevelBox } from './choose-level.ts';
import { describeImage } from './describe-image.ts';
import type { FileTree } from './file-tree.ts';
import type { ArrayBox } from './list-chunks.ts';
import { secondsOf } from './time-units.ts';
import { chooseChannels } from './ome-channels.ts';
import { openImage } from './open-image.ts';
import type { OmeImage } from './open-image.ts';
import { readBox } from './read-box.ts';
import { limitsOfChannels, readChannels } from './read-channels.ts';

/** The load for which a volume is read. */
export interface ZarrLoad {
  /** What the volume has to fit. */
  readonly limits: DeviceLimits;
  readonly budget: Budget;
  readonly signal?: AbortSignal;
  readonly onProgress: ProgressListener;
  readonly onScans?: ScansListener;
  /** So many volumes of other files are numbered before its images; 0 where undefined. */
  readonly before?: number;
}

/** The coarsest level is shown first where the chosen one has at least so many times its voxels. */
const minForPart = 4;

/** Labels with voxels that are longer by this factor than those of the volume look coarse in it. */
const muchCoarser = 1.5;

/** Times that a page can have as scans. */
const maxTimes = 10_000;

/**
 * Reads an image of an OME-Zarr: the finest level that the device holds, of a region if there is one. The coarsest level is shown first.
 * Several times are scans. Source: OME-Zarr 0.5 (ngff.openmicroscopy.org), Zarr 2 and 3 (zarr-specs.readthedocs.io)
 * @throws {VolumeViewError} `format/corrupt`, `format/unsupported`, `format/too-large`, `attribute/invalid`, `source/…`; the signal's reason
 */
export async function readZarr(
  tree: FileTree,
  settings: DecodeSettings,
  load: ZarrLoad,
): Promise<DecodedCartesianVolume> {
  const image = await openImage(tree, settings.series && settings.series - (load.before ?? 0), load);
  const { axes, levels } = image;
  const { shape } = levels[0].array;
  const shown = chooseChannels(image, tree);
  const { time, times } = chooseTime(image, settings, load);
  const firstChannel = shown.kind === 'values' ? shown.index : shown.list[0].index;
  const arrayBox = ({ first, dimensions }: LevelBox, channel = firstChannel): ArrayBox => {
    const at = shape.map((_, axis) => (axis === axes.time ? time : axis === axes.channel ? channel : 0));
    return { axes: axes.space, first, dimensions, at };
  };
  // A region that holds nothing of the volume is an error of the view, which says it.
  const region =
    settings.region && levels.every((level) => cutLevel(level, axes, settings.region!)) ? settings.region : null;
  const { labelDetail } = settings;
  if (labelDetail !== undefined && settings.region && !region) throw nothingThere();
  const boxes = levels.map((level) => cutLevel(level, axes, region)!);
  const stored = Math.min(4, levels[0].array.type.bytesPerSample);
  const limits = { ...load.limits, maxBytes: Math.min(load.limits.maxBytes, settings.maxBytes ?? Infinity) };
  const ofChannels = shown.kind === 'colors' ? limitsOfChannels(limits, shown.list.length, stored) : null;
  const chosen = chooseLevel(
    labelDetail === undefined ? boxes : labelLevels(boxes, labelDetail, image),
    arrayBox,
    ofChannels ? { ...ofChannels, maxBytes: stored * ofChannels.maxBytes } : limits,
    axes,
  );
  const coarsest = boxes[boxes.length - 1];
  if (!isReadable(chosen, arrayBox(chosen)))
    throw new VolumeViewError(
      'format/too-large',
      `the coarsest level of the ${image.format} has ${chosen.dimensions.join(' x ')} voxels in too many chunks, or in too large ones; expected a pyramid with a smaller level, or larger chunks`,
    );
  if (labelDetail !== undefined && !image.labels && stored * countVoxels(chosen) > limits.maxBytes)
    throw tooManyLabels(image.format, chosen);
  // As scans, the other times are shown too.
  const describe = describeImage(image, { shown, time, times, volumes: settings.scan ? 1 : times });
  const readSamples = async (box: LevelBox, channel: number, onProgress: ProgressListener) => {
    const { array } = box.level;
    countSampleBytes(`the ${image.format}`, box.dimensions, array.type);
    const bytes = await readBox(tree, array, arrayBox(box, channel), { ...load, onProgress });
    const { scale, offset, ...rest } = storeSamples(bytes, array.type, array.littleEndian, {
      slope: 1,
      intercept: 0,
      budget: load.budget,
      chooseWhole: await wholeNumbersOf(array.type),
    });
    return { ...rest, slope: scale, intercept: offset };
  };
  const windows = new Map<number, readonly [number, number]>();
  const read = async (box: LevelBox, onProgress: ProgressListener): Promise<DecodedCartesianVolume> => {
    const whole = { dimensions: box.dimensions, indexToWorld: worldOfBox(box, axes) };
    const { dimensions, indexToWorld, ...values } =
      shown.kind === 'colors'
        ? await readChannels(whole, shown.list, (index, report) => readSamples(box, index, report), {
            budget: load.budget,
            onProgress,
            windows,
            limits: ofChannels!,
          })
        : { ...whole, ...(await readSamples(box, shown.index, onProgress)) };
    return placeVolume({ ...describe, ...values, grid: cartesianGrid(dimensions, indexToWorld) }, settings);
  };
  if (
    labelDetail === undefined &&
    coarsest !== chosen &&
    minForPart * countVoxels(coarsest) <= countVoxels(chosen) &&
    isReadable(coarsest, arrayBox(coarsest))
  ) {
    const part = await read(coarsest, () => load.onProgress(0, 0));
    const whole = placeVolume({ ...part, grid: cartesianGrid(chosen.dimensions, worldOfBox(chosen, axes)) }, settings);
    await tree.showPart(part, whole.grid);
    load.budget.giveBack(bytesOf(part));
  }
  const volume = await read(chosen, load.onProgress);
  const [finest] = boxes;
  if (chosen === finest) return volume;
  // Where even the coarsest level is too large, it is made smaller here, so that it is known from what. Labels have no mean.
  const { samples, dimensions, indexToWorld } =
    volume.isLabels || volume.channels
      ? { ...volume.grid, samples: volume.samples }
      : fitVolume({ ...volume.grid, samples: volume.samples }, limits);
  return {
    ...volume,
    samples,
    grid: cartesianGrid(dimensions, indexToWorld),
    reduced: { from: finest.dimensions, to: dimensions },
    ...(labelDetail !== undefined &&
      detailOf(chosen, axes) > muchCoarser * labelDetail && {
        left: [...(volume.left ?? []), sayCoarse(chosen, finest)],
      }),
    ...(samples !== volume.samples && { indexed: undefined }),
  };
}

/** The levels that labels may be read of. Values of an image that is not said to have labels may be means in all but the finest one. */
function labelLevels(boxes: readonly LevelBox[], detail: number, { axes, labels }: OmeImage): readonly LevelBox[] {
  return labels ? coarseEnough(boxes, detail, axes) : boxes.slice(0, 1);
}

function nothingThere(): VolumeViewError {
  return new VolumeViewError(
    'format/unsupported',
    'the labels and the volume have no place in common; expected files of the same body in the same coordinates',
  );
}

function tooManyLabels(format: string, { dimensions }: LevelBox): VolumeViewError {
  return new VolumeViewError(
    'format/too-large',
    `the ${format} has ${dimensions.join(' x ')} voxels; expected at most 1 GiB of labels, or a pyramid whose metadata have "image-label", of which a coarser level can be read`,
  );
}

function sayCoarse({ dimensions }: LevelBox, finest: LevelBox): string {
  return `the labels are those of ${dimensions.join(' x ')} larger voxels, instead of ${finest.dimensions.join(' x ')}: the finer levels have more than 1 GiB, and small labels may be missing`;
}

/** Bytes that were taken for a volume's samples. */
function bytesOf({ samples, channels }: DecodedCartesianVolume): number {
  const each = channels?.list.reduce(
    (sum, { samples: { byteLength } }) => sum + byteLength,
    channels.colors.byteLength,
  );
  return samples.byteLength + (each ?? 0);
}

/** The time that is read, from 0, and the number of times; the page hears of them as scans where it asks for one. */
function chooseTime(
  { axes, levels }: OmeImage,
  { scan }: DecodeSettings,
  { onScans }: ZarrLoad,
): { readonly time: number; readonly times: number } {
  const [{ array, scale, translation }] = levels;
  const times = axes.time === null ? 1 : array.shape[axes.time];
  if (axes.time === null || times === 1 || !scan) return { time: 0, times };
  if (times > maxTimes)
    throw new VolumeViewError(
      'format/too-large',
      `the Zarr has ${times.toLocaleString('en')} times; expected at most ${maxTimes.toLocaleString('en')}`,
    );
  const seconds = secondsOf(axes.timeUnit);
  const step = scale[axes.time] * (seconds ?? NaN);
  const steps = step > 0 ? { first: translation[axes.time] * seconds!, step, unit: 's' } : null;
  const known = Array.from({ length: times }, (_, index) => timeAt(index, steps));
  onScans?.(known);
  return { time: chooseScan(known, scan).index, times };
}
