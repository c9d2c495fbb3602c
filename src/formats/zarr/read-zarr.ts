import { VolumeViewError } from '../../core/errors.ts';
import { cartesianGrid } from '../../volume/grid.ts';
import { fitVolume } from '../../volume/reduce.ts';
import type { DeviceLimits } from '../../volume/reduce.ts';
import type { Budget } from '../base/budget.ts';
import { countSampleBytes } from '../base/count-sample-bytes.ts';
import type { DecodedCartesianVolume, DecodeSettings, ProgressListener } from '../base/decoded-volume.ts';
import type { ScansListener } from '../base/load-request.ts';
import { placeVolume } from '../base/place-volume.ts';
import { storeSamples, wholeNumbersOf } from '../base/store-samples.ts';
import { chooseLevel, countVoxels, cutLevel, isOneSlice, isReadable, storedBytes, worldOfBox } from './choose-level.ts';
import type { ArrayBox, LevelBox } from './choose-level.ts';
import { chooseTime } from './choose-time.ts';
import { describeImage } from './describe-image.ts';
import type { FileTree } from './file-tree.ts';
import { chooseChannels } from './ome-channels.ts';
import { openImage } from './open-image.ts';
import { labelLevels, nothingThere, sayCoarse, tooManyLabels } from './label-levels.ts';
import { readBoxes } from './read-box.ts';
import { limitsOfChannels, readChannels } from './read-channels.ts';
import type { ChannelSamples } from './read-channels.ts';
import { choosePinned } from './pinned-level.ts';
import { suggestForTimes } from './suggest-for-times.ts';

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
  const arrayBox = ({ first, dimensions }: LevelBox, channel = firstChannel, atTime = time): ArrayBox => {
    const at = shape.map((_, axis) => (axis === axes.time ? atTime : axis === axes.channel ? channel : 0));
    return { axes: axes.space, first, dimensions, at };
  };
  // A region that holds nothing of the volume is an error of the view, which says it.
  const region =
    settings.region && levels.every((level) => cutLevel(level, axes, settings.region!)) ? settings.region : null;
  const { labelDetail } = settings;
  if (labelDetail !== undefined && settings.region && !region) throw nothingThere();
  const boxes = levels.map((level) => cutLevel(level, axes, region)!);
  const isSlice = isOneSlice(boxes[0]);
  const stored = storedBytes(levels[0].array.type);
  const limits = { ...load.limits, maxBytes: Math.min(load.limits.maxBytes, settings.maxBytes ?? Infinity) };
  const ofChannels = shown.kind === 'colors' ? limitsOfChannels(limits, shown.list.length, stored) : null;
  const pinned =
    shown.kind === 'values' && times === 1 ? choosePinned(image, boxes, arrayBox, { limits, settings }) : null;
  const chosen = pinned
    ? pinned.box
    : chooseLevel(
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
  const readSamples = async (
    box: LevelBox,
    channels: readonly number[],
    onProgress: ProgressListener,
    atTime = time,
  ): Promise<readonly ChannelSamples[]> => {
    const { array } = box.level;
    const numbers = box === chosen && pinned?.numbers;
    countSampleBytes(`the ${image.format}`, box.dimensions, array.type);
    const arrayBoxes = channels.map((channel) => arrayBox(box, channel, atTime));
    const all = await readBoxes(tree, array, arrayBoxes, { ...load, onProgress });
    const chooseWhole = await wholeNumbersOf(array.type);
    return all.map((bytes) => {
      // As its bricks are stored.
      if (numbers) return { samples: numbers.store(bytes), slope: numbers.slope, intercept: numbers.intercept };
      // Floats of 16 bits are copied.
      if (array.type.name === 'float16') load.budget.take(2 * bytes.length, 'the volume');
      const { scale, offset, ...rest } = storeSamples(bytes, array.type, array.littleEndian, {
        slope: 1,
        intercept: 0,
        budget: load.budget,
        chooseWhole,
      });
      return { ...rest, slope: scale, intercept: offset };
    });
  };
  const found =
    settings.scan && times > 1 && !image.labels
      ? await suggestForTimes(
          { shown, times, level: levels[levels.length - 1], axes, describe, isSlice },
          load.budget,
          readSamples,
        )
      : null;
  const windows = new Map(found?.windows);
  const read = async (box: LevelBox, onProgress: ProgressListener): Promise<DecodedCartesianVolume> => {
    const whole = { dimensions: box.dimensions, indexToWorld: worldOfBox(box, axes) };
    const { dimensions, indexToWorld, ...values } =
      shown.kind === 'colors'
        ? await readChannels(whole, shown.list, (channels, report) => readSamples(box, channels, report), {
            budget: load.budget,
            onProgress,
            windows,
            limits: ofChannels!,
            inChunk: axes.channel === null ? 1 : box.level.array.chunk[axes.channel],
            isSlice,
          })
        : { ...whole, ...(await readSamples(box, [shown.index], onProgress))[0] };
    return placeVolume(
      { ...describe, ...found?.appearance, ...values, grid: cartesianGrid(dimensions, indexToWorld) },
      settings,
    );
  };
  if (
    labelDetail === undefined &&
    coarsest !== chosen &&
    // One slice looks like a picture, which is no stand-in for a volume.
    isOneSlice(coarsest) === isSlice &&
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
  if (pinned) {
    const [{ dimensions }] = pinned.levels;
    const isAll = dimensions.every((n, axis) => n === finest.dimensions[axis]);
    return {
      ...volume,
      levels: pinned.levels,
      ...(!isAll && { reduced: { from: finest.dimensions, to: dimensions } }),
    };
  }
  const coarse = labelDetail === undefined ? undefined : sayCoarse(chosen, finest, labelDetail, axes);
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
    ...(coarse && { left: [...(volume.left ?? []), coarse] }),
    ...(samples !== volume.samples && { indexed: undefined }),
  };
}

/** Bytes that were taken for a volume's samples. */
function bytesOf({ samples, channels }: DecodedCartesianVolume): number {
  const each = channels?.list.reduce(
    (sum, { samples: { byteLength } }) => sum + byteLength,
    channels.colors.byteLength,
  );
  return samples.byteLength + (each ?? 0);
}
