import { windowFromHistogram } from '../../optics/transfer/window.ts';
import { mixChannels } from '../../volume/channels.ts';
import type { Channel } from '../../volume/channels.ts';
import { summarize } from '../../volume/histogram.ts';
import type { Matrix4, Vector3 } from '../../volume/matrix.ts';
import { chooseReduction, reduceVolume } from '../../volume/reduce.ts';
import type { DeviceLimits } from '../../volume/reduce.ts';
import type { Samples } from '../../volume/samples.ts';
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
}

/** What a device holds of several channels: how much less than of one. @param stored - bytes of a sample */
export function limitsOfChannels(limits: DeviceLimits, count: number, stored: number): DeviceLimits {
  return { ...limits, maxBytes: limits.maxBytes / Math.max(mixedBytes, count * stored) };
}

/**
 * Reads several channels of a box, one after the other, and mixes their light.
 * @param read - one of them
 */
export async function readChannels(
  box: { readonly dimensions: Vector3; readonly indexToWorld: Matrix4 },
  list: readonly OmeChannel[],
  read: (index: number, onProgress: ProgressListener) => Promise<ChannelSamples>,
  { budget, onProgress, windows, limits }: ChannelReading,
): Promise<
  Pick<DecodedCartesianVolume, 'samples' | 'slope' | 'intercept' | 'channels' | 'window' | 'transferFunction'> &
    typeof box
> {
  const factors = chooseReduction({ ...box, samples: new Uint8Array(0) }, limits);
  const isSmaller = factors.some((factor) => factor > 1);
  const channels: Channel[] = [];
  let fitted = box;
  for (const [i, { index, name, color, window }] of list.entries()) {
    const {
      samples: all,
      slope,
      intercept,
    } = await read(index, (loaded, total) => onProgress(i * total + loaded, list.length * total));
    const { samples, ...own } = isSmaller ? reduceVolume({ ...box, samples: all }, factors) : { ...box, samples: all };
    fitted = own;
    const found = window ?? windows.get(index) ?? windowFromHistogram(summarize(samples, slope, intercept).histogram);
    windows.set(index, found);
    channels.push({ number: index + 1, name, color, window: found, samples, slope, intercept });
  }
  budget.take(mixedBytes * channels[0].samples.length, 'the colours of the channels');
  const { samples, slope, ...mixed } = mixChannels(channels);
  return {
    ...fitted,
    samples,
    slope,
    intercept: 0,
    channels: mixed,
    window: [0, list.length],
    transferFunction: opacities(list.length),
  };
}

/** A function of brightness: white, and as opaque as so many media together, whose extinctions add. */
function opacities(count: number): string {
  const stepsPerChannel = 4;
  return Array.from({ length: stepsPerChannel * count + 1 }, (_, step) => {
    const brightness = step / stepsPerChannel;
    return `${brightness} white ${Number((1 - (1 - fullOpacity) ** brightness).toPrecision(6))}`;
  }).join(', ');
}
