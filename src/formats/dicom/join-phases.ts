// The volumes of several times, each of which is kept until it is shown.
import { cartesianGrid } from '../../volume/grid.ts';
import type { CartesianGrid } from '../../volume/grid.ts';
import type { DecodedCartesianVolume, DecodeSettings } from '../base/decoded-volume.ts';
import type { ReadContext } from '../base/format.ts';
import { hostIsLittleEndian, numberTypes } from '../base/number-types.ts';
import { placeVolume } from '../base/place-volume.ts';
import type { SeriesInfo } from '../base/scan-data.ts';
import { countKept } from '../series/keep-volumes.ts';
import { openSeries } from '../series/open-series.ts';
import { arrayOf } from './decode-frame.ts';
import type { Phases } from './find-phases.ts';
import { floatOf, gatherSamples } from './gather-samples.ts';
import type { ChosenFrames } from './group-frames.ts';
import type { StoredType } from './picture.ts';
import { stackFrames } from './stack-frames.ts';
import type { Stack } from './stack-frames.ts';

type DescribeFiles = (files: ChosenFrames, anatomical: boolean, grid: CartesianGrid) => SeriesInfo;

/** The numbers of one time. */
interface Kept {
  readonly type: StoredType;
  readonly blob: Blob;
  readonly slope: number;
  readonly intercept: number;
}

/**
 * Decodes the volumes of all times, and reads the one that is wanted.
 * @returns null where they have different grids, or take more memory than a page keeps
 * @throws {VolumeViewError} as gatherSamples says
 */
export async function joinPhases(
  { frames: phases, times, left }: Phases & { readonly left: readonly string[] },
  settings: DecodeSettings,
  context: ReadContext,
  describe: DescribeFiles,
): Promise<DecodedCartesianVolume | null> {
  const stacks = phases.map((frames) => stackFrames(frames));
  const [first] = stacks;
  const slices = countSlices(first);
  if (!stacks.every((stack) => isAlike(stack, first))) return null;
  const [{ columns, rows }] = phases[0];
  const bytes = columns * rows * slices * numberTypes.float32.bytesPerSample;
  if (countKept({ bytes, count: phases.length }, context.budget) < phases.length) return null;
  const kept: Kept[] = [];
  const lost = new Set<string>();
  for (const [i, stack] of stacks.entries()) {
    const onProgress = (done: number, total: number): void =>
      context.onProgress(i * total + done, phases.length * total);
    const gathered = await gatherSamples(
      stack,
      { ...context, onProgress },
      { first: [], onFirst: () => Promise.resolve() },
    );
    const { type, numbers, slope, intercept } = gathered;
    kept.push({ type, blob: new Blob([numbers.buffer as ArrayBuffer]), slope, intercept });
    for (const words of gathered.left) lost.add(words);
  }
  const type = commonType(kept.map((one) => one.type));
  const volumes: Blob[] = [];
  for (const one of kept) volumes.push(await convert(one, type));
  const words = [...left, ...first.left, ...lost];
  const grid = cartesianGrid([columns, rows, slices], first.indexToWorld);
  const series = {
    info: describe({ frames: phases.flat(), left: words }, first.anatomical, grid),
    volumes,
    count: volumes.length,
    type,
    littleEndian: hostIsLittleEndian,
    scaleOf: (index: number) => ({ slope: kept[index].slope, intercept: kept[index].intercept }),
    timeOf: (index: number) => times[index],
  };
  return placeVolume(await openSeries(series, settings, context), settings);
}

const countSlices = ({ resample, slices }: Stack): number => resample?.length ?? slices.length;

/** Whether two stacks have the same grid: times of one scan differ in nothing but their values. */
function isAlike(a: Stack, b: Stack): boolean {
  const isNear = (value: number, i: number): boolean => Math.abs(value - b.indexToWorld[i]) <= 1e-3;
  return countSlices(a) === countSlices(b) && a.indexToWorld.every(isNear);
}

/** Places without data make floats of the numbers of a time: then all are floats. */
function commonType(types: readonly StoredType[]): StoredType {
  const [first] = types;
  if (types.every((type) => type === first)) return first;
  const floats = new Set(types.map((type) => floatOf(type)));
  return floats.has('float64') ? 'float64' : 'float32';
}

async function convert({ blob, type }: Kept, wanted: StoredType): Promise<Blob> {
  if (type === wanted) return blob;
  const numbers = new arrayOf[type](await blob.arrayBuffer());
  return new Blob([new arrayOf[wanted](Array.from(numbers))]);
}
