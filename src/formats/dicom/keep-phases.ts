// The volumes of several times, all decoded when the files are opened: those whose files can not be read again alone.
import type { DecodedCartesianVolume, DecodeSettings } from '../base/decoded-volume.ts';
import type { ReadContext } from '../base/format.ts';
import { hostIsLittleEndian, numberTypes } from '../base/number-types.ts';
import { placeVolume } from '../base/place-volume.ts';
import type { SeriesInfo } from '../base/scan-data.ts';
import { countKept } from '../series/keep-volumes.ts';
import { openSeries } from '../series/open-series.ts';
import { arrayOf } from './decode-frame.ts';
import { floatOf, gatherSamples } from './gather-samples.ts';
import type { StoredType } from './picture.ts';
import type { Stack } from './stack-frames.ts';

/** The numbers of one time. */
interface Kept {
  readonly type: StoredType;
  readonly blob: Blob;
  readonly slope: number;
  readonly intercept: number;
}

export interface StackedPhases {
  /** Of each time its slices, all on one grid. */
  readonly stacks: readonly Stack[];
  readonly times: readonly (string | null)[];
  /** What is said of all, with what of their slices is not there, in words. */
  readonly describe: (lost: readonly string[]) => SeriesInfo;
}

/**
 * Decodes the volumes of all times, and reads the one that is wanted.
 * @returns null where they take more memory than a page keeps
 * @throws {VolumeViewError} as gatherSamples says
 */
export async function keepPhases(
  { stacks, times, describe }: StackedPhases,
  settings: DecodeSettings,
  context: ReadContext,
): Promise<DecodedCartesianVolume | null> {
  const [nx, ny, nz] = describe([]).grid.dimensions;
  const bytes = nx * ny * nz * numberTypes.float32.bytesPerSample;
  if (countKept({ bytes, count: stacks.length }, context.budget) < stacks.length) return null;
  const kept: Kept[] = [];
  const lost = new Set<string>();
  for (const [i, stack] of stacks.entries()) {
    const onProgress = (done: number, total: number): void =>
      context.onProgress(i * total + done, stacks.length * total);
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
  const series = {
    info: describe([...lost]),
    volumes,
    count: volumes.length,
    type,
    littleEndian: hostIsLittleEndian,
    scaleOf: (index: number) => ({ slope: kept[index].slope, intercept: kept[index].intercept }),
    timeOf: (index: number) => times[index],
  };
  return placeVolume(await openSeries(series, settings, context), settings);
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
