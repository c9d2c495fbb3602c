import type { Vector3 } from '../../volume/matrix.ts';
import type { Budget } from '../base/budget.ts';
import { millimetresOf } from '../base/length-units.ts';
import { guessedDistance, nameRest } from './layout.ts';
import type { TiffLayout } from './layout.ts';
import { readOmePixels } from './ome-pixels.ts';
import type { OmePixels } from './ome-pixels.ts';

/**
 * Finds the pages of the first channel of the first image.
 * @param xml - the description of the first page
 * @param pages - of the file
 * @throws {VolumeViewError} `format/corrupt`, `format/unsupported`, `format/too-large`
 */
export function layOutOme(xml: string, pages: number, budget: Budget): TiffLayout {
  budget.step(xml.length, 'the OME-XML');
  const pixels = readOmePixels(xml);
  const { sizes, images } = pixels;
  const { places, isCut } = listPages(pixels, pages, budget);
  const planes = sizes.Z * sizes.T;
  // An acquisition that was stopped names only the planes that it has.
  const mayLack = !isCut && planes <= places.size * maxLack;
  const lacking = planes - places.size;
  const { spacing, isGuessed } = readSpacing(pixels);
  return {
    format: 'OME-TIFF',
    slices: sizes.Z,
    times: sizes.T,
    pageOf: (slice, time) => places.get(time * sizes.Z + slice) ?? null,
    spacing,
    timeStep: readStep(pixels),
    mayLack,
    left: [
      mayLack && lacking > 0
        ? `${lacking.toLocaleString('en')} of ${planes.toLocaleString('en')} slices, which the file does not hold: they are shown as 0`
        : null,
      nameRest('channel', pixels.samples.length > 0 ? pixels.samples.length : sizes.C),
      nameRest('image', images),
      isGuessed && sizes.Z > 1 ? guessedDistance : null,
    ].filter((one) => one !== null),
  };
}

/** For each slice that the file holds, so many may be missing: what is made of a small file stays small. */
const maxLack = 1024;

interface Places {
  /** The page of each slice of the first channel, by time * slices + slice. */
  readonly places: ReadonlyMap<number, number>;
  /** Whether pages are named, or have to be there, that the file does not have. */
  readonly isCut: boolean;
}

function listPages({ sizes, order, samples, parts }: OmePixels, pages: number, budget: Budget): Places {
  // A page holds all numbers of a channel.
  const perPage = Math.max(1, samples[0] ?? 1);
  const counts = { ...sizes, C: Math.max(1, Math.round(sizes.C / perPage)) };
  const axes = order.slice(2).split('') as ('C' | 'Z' | 'T')[];
  const places = new Map<number, number>();
  let [next, isCut] = [0, parts.every(({ count }) => count === undefined) && isWhole(parts)];
  for (const part of parts.length > 0 ? parts : [{ page: 0, c: 0, z: 0, t: 0, count: undefined }]) {
    const first = part.page ?? next;
    if (!(first + (part.count ?? 1) <= pages)) isCut = true;
    // One page where it is named; else all that follow.
    const count = Math.min(
      part.count ?? (part.page === undefined || parts.length === 0 || isWhole(parts) ? pages : 1),
      pages - first,
    );
    if (!(Number.isSafeInteger(first) && first >= 0 && count >= 1)) continue;
    budget.step(count, 'the pages of the OME-TIFF');
    const at = { C: Math.floor(part.c / perPage), Z: part.z, T: part.t };
    for (let i = 0; i < count; i++) {
      if (at.C === 0 && at.Z < counts.Z && at.T < counts.T) places.set(at.T * counts.Z + at.Z, first + i);
      for (const axis of axes) {
        if (++at[axis] < counts[axis]) break;
        at[axis] = 0;
      }
    }
    next = first + count;
  }
  return { places, isCut };
}

/** Whether one element without a count stands for all pages, or none does. */
const isWhole = (parts: OmePixels['parts']): boolean => parts.length <= 1;

/** Where all units are none of length, such as pixels, lengths stay as they are: so the shape of voxels is right. */
function readSpacing({ lengths }: OmePixels): { spacing: Vector3 | null; isGuessed: boolean } {
  const other = lengths.some(([length, unit]) => length > 0 && millimetresOf(unit) !== undefined) ? NaN : 1;
  const [x, y, z] = lengths.map(([length, unit]) => {
    const millimetres = length * (millimetresOf(unit) ?? other);
    return millimetres > 0 && Number.isFinite(millimetres) ? millimetres : null;
  });
  if (x === null || y === null) return { spacing: null, isGuessed: false };
  return { spacing: [x, y, z ?? x], isGuessed: z === null };
}

/** Seconds of a unit of time. Source: OME schema 2016-06, UnitsTime */
const seconds: ReadonlyMap<string, number> = new Map([
  ['ns', 1e-9],
  ['\u00b5s', 1e-6],
  ['ms', 1e-3],
  ['s', 1],
  ['min', 60],
  ['h', 3600],
  ['d', 86_400],
]);

function readStep({ increment: [time, unit] }: OmePixels): number | null {
  const step = time * (seconds.get(unit) ?? NaN);
  return step > 0 && Number.isFinite(step) ? step : null;
}
