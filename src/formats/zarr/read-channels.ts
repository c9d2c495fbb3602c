import { spanAround } from '../../optics/transfer/span-around.ts';
import { windowFromHistogram } from '../../optics/transfer/window.ts';
import { mixChannels } from '../../volume/channels.ts';
import type { Channel } from '../../volume/channels.ts';
import { summarize } from '../../volume/histogram.ts';
import type { Matrix4, Vector3 } from '../../volume/matrix.ts';
import { chooseReduction, reduceVolume } from '../../volume/reduce.ts';
import type { DeviceLimits } from '../../volume/reduce.ts';
import type { Samples } from '../../volume/samples.ts';
import { colorSliceStops } from '../../volume/slice-stops.ts';
import { pictureWindow, sortValues } from '../appearance/picture-window.ts';
import type { Budget } from '../base/budget.ts';
import type { DecodedCartesianVolume, ProgressListener } from '../base/decoded-volume.ts';
import type { OmeChannel } from './ome-channels.ts';

/** Bytes of the brightness and of the colours of a voxel. */
const mixedBytes = 5;

/** The opacity of a reference length where one channel has all of its colour. */
const fullOpacity = 0.2;

/** Samples of one channel of a box. */
export interface ChannelSamples {
  readonly samples: Samples;
  readonly slope: number;
  readonly intercept: number;
}

export interface ChannelReading {
  readonly budget: Budget;
  readonly onProgress: ProgressListener;
  /** Windows of channels whose file has none: those of the part that is read first, so that the whole is as bright. */
  readonly windows: Map<number, readonly [number, number]>;
  /** What a device holds of one byte for each voxel. */
  readonly limits: DeviceLimits;
  /** Channels that each chunk of the file has. */
  readonly inChunk: number;
  /** Whether the image is one slice: it is a picture then, as microscopes show it, and no volume that glows. */
  readonly isSlice: boolean;
}

/** What a device holds of several channels: how much less than of one. @param stored - bytes of a sample */
export function limitsOfChannels(limits: DeviceLimits, count: number, stored: number): DeviceLimits {
  return { ...limits, maxBytes: limits.maxBytes / Math.max(mixedBytes, count * stored) };
}

/**
 * Reads several channels of a box, one after the other or those of one chunk together, and mixes their light.
 * @param read - some of them, in the same order
 */
export async function readChannels(
  box: { readonly dimensions: Vector3; readonly indexToWorld: Matrix4 },
  list: readonly OmeChannel[],
  read: (indices: readonly number[], onProgress: ProgressListener) => Promise<readonly ChannelSamples[]>,
  { budget, onProgress, windows, limits, inChunk, isSlice }: ChannelReading,
): Promise<
  Pick<DecodedCartesianVolume, 'samples' | 'slope' | 'intercept' | 'channels' | 'window' | 'transferFunction'> &
    typeof box
> {
  const factors = chooseReduction({ ...box, samples: new Uint8Array(0) }, limits);
  const isSmaller = factors.some((factor) => factor > 1);
  const channels: Channel[] = [];
  let fitted = box;
  let done = 0;
  for (const group of groupByChunk(list, inChunk)) {
    const before = done;
    const found = await read(
      group.map(({ index }) => index),
      (loaded, total) => onProgress((before * total) / group.length + loaded, (list.length * total) / group.length),
    );
    done += group.length;
    for (const [i, { index, name, color, window }] of group.entries()) {
      const { samples: all, slope, intercept } = found[i];
      const { samples, ...own } = isSmaller
        ? reduceVolume({ ...box, samples: all }, factors)
        : { ...box, samples: all };
      fitted = own;
      const shown = window ?? windows.get(index) ?? chooseWindow({ samples, slope, intercept }, isSlice);
      windows.set(index, shown);
      channels.push({ number: index + 1, name, color, window: shown, samples, slope, intercept });
    }
  }
  // In the order of the address.
  const order = list.map(({ index }) => index + 1);
  channels.sort((one, other) => order.indexOf(one.number) - order.indexOf(other.number));
  budget.take(mixedBytes * channels[0].samples.length, 'the colours of the channels');
  const { samples, slope, ...mixed } = mixChannels(channels, isSlice);
  return {
    ...fitted,
    samples,
    slope,
    intercept: 0,
    channels: mixed,
    window: [0, list.length],
    transferFunction: isSlice ? colorSliceStops : opacities(list.length),
  };
}

/** The window of a channel whose file has none. @param isSlice - whether its light is a picture */
export function chooseWindow(
  { samples, slope, intercept }: ChannelSamples,
  isSlice: boolean,
): readonly [number, number] {
  const { histogram } = summarize(samples, slope, intercept);
  const { low, high } = histogram;
  // A channel of one value shows nothing: it has no light.
  if (!(high > low)) return [low, spanAround(low)[1]];
  return isSlice ? pictureWindow(sortValues(samples, slope, intercept)) : windowFromHistogram(histogram);
}

/** Channels of the same chunks, together. */
export function groupByChunk(list: readonly OmeChannel[], inChunk: number): readonly (readonly OmeChannel[])[] {
  const groups = new Map<number, OmeChannel[]>();
  for (const channel of list) {
    const chunk = Math.floor(channel.index / inChunk);
    const known = groups.get(chunk);
    if (known) known.push(channel);
    else groups.set(chunk, [channel]);
  }
  return [...groups.values()];
}

/** A function of brightness: white, and as opaque as so many media together, whose extinctions add. */
function opacities(count: number): string {
  const stepsPerChannel = 4;
  return Array.from({ length: stepsPerChannel * count + 1 }, (_, step) => {
    const brightness = step / stepsPerChannel;
    return `${brightness} white ${Number((1 - (1 - fullOpacity) ** brightness).toPrecision(6))}`;
  }).join(', ');
}
