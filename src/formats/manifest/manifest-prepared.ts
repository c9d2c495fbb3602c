import type { DecodedCartesianVolume, DecodedVolume } from '../base/decoded-volume.ts';
import type { Budget } from '../base/budget.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import type { NamedLabel } from '../../volume/labels.ts';
import { count, Expected, isFinite, maxList, shortText } from './manifest-checks.ts';
import type { Check } from './manifest-checks.ts';
import { readFields } from './manifest-radar.ts';

// The fields of a manifest that keep what an image can't say of a volume, as volume-view-prepare writes them.

/** How the volume was changed before it became an image. */
export interface Prepared {
  /** Voxels along i, j and k before it was made smaller; absent if it was not. */
  readonly from?: Vector3;
  /** Largest and root mean square difference from the original's values, in data values. */
  readonly maxError?: number;
  readonly rmsError?: number;
  /** Of labels: the share of the original's voxels that have another label, 0..1. */
  readonly changedLabels?: number;
}

const size: Check<number> = (value) => {
  if (!isFinite(value) || value < 0) throw new Expected('a number from 0');
  return value;
};

const share: Check<number> = (value) => {
  if (!isFinite(value) || value < 0 || value > 1) throw new Expected('a number from 0 to 1');
  return value;
};

const dimensions: Check<Vector3> = (value) => {
  if (!Array.isArray(value) || value.length !== 3) throw new Expected('three whole numbers from 1');
  return value.map((one: unknown) => count(one)) as unknown as Vector3;
};

export const prepared: Check<Prepared> = (value) =>
  readFields<Prepared>(value, { from: dimensions, maxError: size, rmsError: size, changedLabels: share });

export const yes: Check<boolean> = (value) => {
  if (typeof value !== 'boolean') throw new Expected('true or false');
  return value;
};

export const pixel: Check<number> = (value) => {
  if (!Number.isSafeInteger(value) || (value as number) < 0 || (value as number) > 65_535)
    throw new Expected('a whole number from 0 to 65535');
  return value as number;
};

const id: Check<number> = (value) => {
  if (!Number.isSafeInteger(value)) throw new Expected('a whole number');
  return value as number;
};

const color: Check<string> = (value) => {
  if (typeof value !== 'string' || !/^#[0-9a-f]{6}$/i.test(value)) throw new Expected('a colour as "#rrggbb"');
  return value;
};

export const labels: Check<readonly NamedLabel[]> = (value) => {
  if (!Array.isArray(value) || value.length > maxList)
    throw new Expected(`a list of up to ${maxList.toLocaleString('en')} objects { "id": …, "name": … }`);
  return value.map((one: unknown, i) => {
    const read = readFields<{ id?: number; name?: string; color?: string }>(one, { id, name: shortText, color });
    if (read.id === undefined) throw new Expected(`"id" at place ${i + 1}`);
    return { id: read.id, name: read.name ?? '', color: read.color === undefined ? null : parse(read.color) };
  });
};

const parse = (text: string): [number, number, number] =>
  [1, 3, 5].map((at) => Number.parseInt(text.slice(at, at + 2), 16) / 255) as [number, number, number];

/** What the fields say of an image's volume. */
export interface PreparedFields {
  readonly labels?: readonly NamedLabel[];
  readonly noData?: number;
  /** Of a video: pixels below this number have no data, as a lossy codec makes other numbers near 0 of 0. */
  readonly noDataBelow?: number;
  readonly anatomical?: boolean;
  readonly prepared?: Prepared;
}

/** From this share of the window on, a difference of values is said. */
const notedShare = 1 / 500;

/** Adds what an image can't say. A radar's mosaic has a place, and a pixel for no data, of its own. */
export function applyPrepared(
  volume: DecodedVolume,
  { labels, noData, anatomical, prepared }: PreparedFields,
  budget: Budget,
): DecodedVolume {
  if (volume.grid.kind === 'polar') return volume;
  const cartesian = volume as DecodedCartesianVolume;
  const note = prepared && describe(prepared, cartesian);
  return {
    ...cartesian,
    ...(noData !== undefined && { samples: markNoData(cartesian.samples, noData, budget) }),
    ...(labels && { isLabels: true, named: labels }),
    ...(anatomical !== undefined && { anatomical }),
    ...(note && { left: [...(cartesian.left ?? []), note] }),
  };
}

function markNoData(
  samples: DecodedCartesianVolume['samples'],
  noData: number,
  budget: Budget,
): Float32Array<ArrayBuffer> {
  budget.take(4 * samples.length, 'the mosaic with places without data');
  const marked = new Float32Array(samples.length);
  for (let i = 0; i < samples.length; i++) marked[i] = samples[i] === noData ? NaN : samples[i];
  budget.giveBack(samples.byteLength);
  return marked;
}

function describe(
  { from, maxError = 0, rmsError = 0, changedLabels }: Prepared,
  { window, grid, unit }: DecodedCartesianVolume,
): string | null {
  const isNoted = window && maxError > notedShare * (window[1] - window[0]);
  if (!from && !isNoted) return null;
  const made = from
    ? ` it was made smaller before it came here, from ${from.join(' x ')} voxels to ${grid.dimensions.join(' x ')}, and`
    : '';
  if (changedLabels !== undefined)
    return `details:${made} ${Number((100 * changedLabels).toPrecision(2))} % of the voxels have another label than in the original`;
  const say = (value: number): string => `${Number(value.toPrecision(3))}${unit ? ` ${unit}` : ''}`;
  return `details:${made} values differ from those of the original by ${say(rmsError)} (root mean square), at most by ${say(maxError)}`;
}
