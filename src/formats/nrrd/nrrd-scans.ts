import { countSampleBytes } from '../base/count-sample-bytes.ts';
import type { DecodedCartesianVolume, DecodeSettings } from '../base/decoded-volume.ts';
import type { ReadContext } from '../base/format.ts';
import { mayKeepAll, openInArray } from '../grid-files/open-in-array.ts';
import { areScans } from '../series/open-volumes.ts';
import type { VolumesOfFile } from '../series/open-volumes.ts';
import { timeAt } from '../series/scan-times.ts';
import type { TimeSteps } from '../series/scan-times.ts';
import { listVolumes } from './nrrd-axes.ts';
import type { NrrdAxis, NrrdLayout } from './nrrd-axes.ts';
import { what } from './nrrd-header.ts';

/** Names of units of time, and how many of them are a second. */
const timeUnits: readonly (readonly [RegExp, number])[] = [
  [/^s(ec(onds?)?)?$/i, 1],
  [/^(ms(ec)?|milliseconds?)$/i, 1e3],
  [/^(us|µs|microseconds?)$/i, 1e6],
];

/** The array of a file, as its header describes it. */
export interface NrrdArray {
  readonly all: readonly NrrdAxis[];
  readonly layout: NrrdLayout;
  /** Reads so many of its first samples. */
  read(samples: number): Promise<Uint8Array<ArrayBuffer>>;
}

/**
 * Opens the volumes of a file as scans.
 * @returns null where there is one, where a page wants no scans, and where there are more than a page keeps
 */
export async function openNrrdScans(
  { all, layout, read }: NrrdArray,
  volumes: VolumesOfFile,
  settings: DecodeSettings,
  context: ReadContext,
): Promise<DecodedCartesianVolume | null> {
  const samples = all.reduce((product, { size }) => product * size, 1);
  const { dimensions, strides, volumes: count } = layout;
  if (!areScans(count, volumes.type, settings, context)) return null;
  if (!mayKeepAll(count, countSampleBytes(what, [samples], volumes.type), context)) return null;
  const steps = readSteps(all, layout);
  return openInArray(
    { bytes: await read(samples), dimensions, strides, starts: listVolumes(all, layout) },
    { ...volumes, timeOf: (index) => timeAt(index, steps) },
    settings,
    context,
  );
}

/** Null where the volumes lie along several axes, or along one without a unit of time. */
function readSteps(all: readonly NrrdAxis[], { axes }: NrrdLayout): TimeSteps | null {
  const others = all.filter((axis) => !axes.includes(axis) && axis.size > 1);
  if (others.length !== 1) return null;
  const [{ unit, spacing, isSpaced, first }] = others;
  const [, per] = timeUnits.find(([name]) => name.test(unit)) ?? [];
  return per && isSpaced && spacing > 0 ? { first: first / per, step: spacing / per, unit: 's' } : null;
}
