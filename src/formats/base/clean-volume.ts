// Hides what touches nothing of a scan, as a head rest: loaded with the first volume that is to be cleaned.
import { defaultPreset } from '../../optics/transfer/default-preset.ts';
import { resolveTransferFunction } from '../../optics/transfer/resolve-transfer-function.ts';
import { invalidAttribute } from '../../core/errors.ts';
import { findSmallParts, maxRuns } from '../../volume/connected-parts.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import type { Samples, Volume } from '../../volume/volume.ts';

/** A value from which on voxels belong to something, or the one from which on the volume shows something where nothing else is said of its colours. */
export type Cleaning = number | 'auto';

/** What of a volume says where something begins. */
type Cleaned = Pick<Volume, 'slope' | 'intercept' | 'range' | 'window' | 'transferFunction' | 'isDiscrete'>;

/**
 * Set voxels of parts that touch nothing to the value at which things begin, in place, so that they are what is next to things: nothing that shows.
 * All that reads the volume later, as picks and slices, then has them so too.
 * @param samples - change
 * @returns in words, what is hidden; null where nothing is
 * @throws {VolumeViewError} `attribute/invalid` for labels, and where it does not follow from the volume at which value things begin
 */
export async function cleanVolume(
  cleaning: Cleaning,
  volume: Cleaned,
  { samples, dimensions }: { readonly samples: Samples; readonly dimensions: Vector3 },
): Promise<string | null> {
  if (volume.isDiscrete)
    throw refuseCleaning(cleaning, 'a volume of measured values: to hide a label, write <volume-label hidden>');
  const from = cleaning === 'auto' ? await findBegin(volume) : cleaning;
  const { slope, intercept } = volume;
  const found = findSmallParts(dimensions, (voxel) => slope * samples[voxel] + intercept > from);
  if (!found)
    return `clean hides nothing: above ${from} there are more than ${maxRuns.toLocaleString('en')} rows of voxels, as in noise; a higher value, as in clean="${writeHigher(volume, from)}", may help`;
  if (found.parts === 0) return null;
  const hidden = storedUpTo(from, volume, samples);
  found.visit((first, end) => void samples.fill(hidden, first, end));
  return `clean hides ${found.parts === 1 ? 'one part that touches' : `${found.parts.toLocaleString('en')} parts that touch`} nothing larger: ${found.voxels.toLocaleString('en')} voxels above ${from}`;
}

/** For a radar's scan, which has no voxels. */
export const refuseRadar = (cleaning: Cleaning): Error =>
  refuseCleaning(cleaning, 'a CT, an MRI or another volume of voxels, and not a radar scan');

/** @param expected - in words */
function refuseCleaning(cleaning: Cleaning, expected: string): Error {
  return invalidAttribute('clean', cleaning === 'auto' ? '' : String(cleaning), expected);
}

/** The value up to which the volume shows nothing. */
async function findBegin({ transferFunction, window, range }: Cleaned): Promise<number> {
  const stops = await resolveTransferFunction(transferFunction ?? defaultPreset, window ?? range);
  const first = stops.findIndex(({ opacity }) => opacity > 0);
  if (first < 1)
    throw refuseCleaning(
      'auto',
      'the value from which on something is shown, like clean="150": the lowest values of this volume show, too',
    );
  return stops[first - 1].value;
}

/** The stored number of which the value is the largest up to one. */
function storedUpTo(value: number, { slope, intercept }: Cleaned, samples: Samples): number {
  const stored = (value - intercept) / slope;
  if (samples instanceof Float32Array) return stored;
  return slope > 0 ? Math.floor(stored) : Math.ceil(stored);
}

function writeHigher({ range: [low, high] }: Cleaned, from: number): string {
  return String(Number((Math.max(low, from) + 0.25 * (high - Math.max(low, from))).toPrecision(2)));
}
