import { cartesianGrid } from '../../volume/grid.ts';
import { summarize } from '../../volume/histogram.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import { suggestAppearance } from '../appearance/suggest-appearance.ts';
import type { SuggestedAppearance } from '../appearance/suggested-appearance.ts';
import type { Budget } from '../base/budget.ts';
import type { ProgressListener } from '../base/decoded-volume.ts';
import { chooseLookedAt, joinValues } from '../series/suggest-for-all.ts';
import { countVoxels, worldOfBox } from './choose-level.ts';
import type { LevelBox } from './choose-level.ts';
import type { describeImage } from './describe-image.ts';
import type { OmeAxes } from './ome-axes.ts';
import type { ShownChannels } from './ome-channels.ts';
import type { OmeLevel } from './ome-levels.ts';
import { chooseWindow, groupByChunk } from './read-channels.ts';
import type { ChannelSamples } from './read-channels.ts';

/** A level of at most so many voxels and chunks is looked at as a whole; of a larger one so many voxels along each axis, in its middle. */
const [maxWhole, maxChunks, longest] = [2 ** 18, 64, 64];

/** What all times have in common. */
export interface ForTimes {
  /** Windows of channels whose file has none, by their index. */
  readonly windows: ReadonlyMap<number, readonly [number, number]>;
  /** Of a single channel. */
  readonly appearance?: Partial<SuggestedAppearance>;
}

interface TimesImage {
  readonly shown: ShownChannels;
  readonly times: number;
  /** The coarsest one. */
  readonly level: OmeLevel;
  readonly axes: OmeAxes;
  readonly describe: ReturnType<typeof describeImage>;
  /** Whether each time is one slice. */
  readonly isSlice: boolean;
}

type ReadSamples = (
  box: LevelBox,
  channels: readonly number[],
  onProgress: ProgressListener,
  time: number,
) => Promise<readonly ChannelSamples[]>;

/**
 * One window for all times, and one set of colours, from some values of the first, the last and some other times: which one is shown first does not
 * matter, and the brightness of one can be compared with that of another. What the file itself says stays.
 */
export async function suggestForTimes(
  { shown, times, level, axes, describe, isSlice }: TimesImage,
  budget: Budget,
  read: ReadSamples,
): Promise<ForTimes> {
  const box = middleOf(level, axes);
  const sample = async (channels: readonly number[]): Promise<readonly Float32Array<ArrayBuffer>[]> => {
    const all: Float32Array[][] = channels.map(() => []);
    for (const time of chooseLookedAt(times)) {
      const found = await read(box, channels, () => undefined, time);
      for (const [i, { samples, slope, intercept }] of found.entries()) {
        all[i].push(Float32Array.from(samples, (one) => slope * one + intercept));
        budget.giveBack(samples.byteLength);
      }
    }
    return all.map(joinValues);
  };
  if (shown.kind === 'values') {
    if (describe.window) return { windows: new Map() };
    const [values] = await sample([shown.index]);
    // Grays of a screen are known by their type.
    const samples = level.array.type.name === 'uint8' ? Uint8Array.from(values) : values;
    const { histogram } = summarize(samples, 1, 0);
    const [nx, ny, nz] = box.dimensions;
    const grid = cartesianGrid([nx, ny * chooseLookedAt(times).length, nz], worldOfBox(box, axes));
    const { isDiscrete, window, transferFunction } = await suggestAppearance(
      { ...describe, grid, samples, slope: 1, intercept: 0 },
      histogram,
    );
    // Of labels, and of nothing but one value, the whole knows more.
    const isKnown = !isDiscrete && histogram.high > histogram.low;
    return { windows: new Map(), ...(isKnown && { appearance: { window, transferFunction } }) };
  }
  const windows = new Map<number, readonly [number, number]>();
  const inChunk = axes.channel === null ? 1 : level.array.chunk[axes.channel];
  const lacking = shown.list.filter(({ window }) => !window);
  for (const group of groupByChunk(lacking, inChunk)) {
    const all = await sample(group.map(({ index }) => index));
    for (const [i, { index }] of group.entries()) {
      const { histogram } = summarize(all[i], 1, 0);
      if (histogram.high > histogram.low)
        windows.set(index, chooseWindow({ samples: all[i], slope: 1, intercept: 0 }, isSlice));
    }
  }
  return { windows };
}

/** A level, or of a large one what is in the chunk in its middle. */
function middleOf(level: OmeLevel, { space }: OmeAxes): LevelBox {
  const { dimensions, array } = level;
  const chunk = space.map((axis) => (axis === null ? 1 : array.chunk[axis]));
  const chunks = dimensions.reduce((product, n, i) => product * Math.ceil(n / chunk[i]), 1);
  if (countVoxels(level) <= maxWhole && chunks <= maxChunks) return { level, first: [0, 0, 0], dimensions };
  const first = dimensions.map((n, i) => Math.floor((n >> 1) / chunk[i]) * chunk[i]);
  return {
    level,
    first: first as unknown as Vector3,
    dimensions: dimensions.map((n, i) => Math.min(chunk[i], n - first[i], longest)) as unknown as Vector3,
  };
}
