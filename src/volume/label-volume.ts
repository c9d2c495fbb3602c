import { histogramBins } from './histogram.ts';
import type { Histogram } from './histogram.ts';
import { indexNumbers } from './index-numbers.ts';
import type { IndexedSamples } from './index-numbers.ts';
import { buildMacrocells } from './macrocells.ts';
import { noLabel, tolerance } from './resample-labels.ts';
import type { Samples } from './samples.ts';
import { isPolar } from './volume.ts';
import type { Volume } from './volume.ts';

/** A volume's values as indices into a list of labels; null if they are not labels. */
export function indexLabels({
  samples,
  slope,
  intercept,
  indexed,
}: {
  readonly samples: Samples;
  readonly slope: number;
  readonly intercept: number;
  readonly indexed?: IndexedSamples;
}): IndexedSamples | null {
  if (indexed) return indexed;
  return indexNumbers<number>(samples, (stored) => {
    const value = Number.isFinite(stored) ? slope * stored + intercept : noLabel;
    return Math.abs(value - Math.round(value)) <= tolerance ? Math.round(value) : NaN;
  });
}

/** Range and histogram of labels, by their ids. */
export function summarizeLabels(
  samples: IndexedSamples['samples'],
  ids: readonly number[],
): { histogram: Histogram; range: [number, number]; hasNoData: boolean } {
  const [low, high] = [ids[0], ids[ids.length - 1]];
  const counts = new Uint32Array(histogramBins);
  const bins = ids.map((id) =>
    Math.min(histogramBins - 1, Math.floor(((id - low) / (high - low || 1)) * histogramBins)),
  );
  for (const place of samples) counts[bins[place]]++;
  return { histogram: { low, high, counts }, range: [low, high], hasNoData: false };
}

/** Converts a volume that was read as intensities to one of labels. */
export function asLabels(volume: Volume): Volume {
  const found = volume.ids || isPolar(volume) ? null : indexLabels(volume);
  if (!found) return { ...volume, isDiscrete: true };
  const { samples, ids } = found;
  const [low, high] = [ids[0], ids[ids.length - 1]];
  return {
    ...volume,
    ids,
    samples,
    ...summarizeLabels(samples, ids),
    slope: 1,
    intercept: 0,
    isDiscrete: true,
    indexed: undefined,
    window: [low, Math.max(high, low + 1)],
    transferFunction: undefined,
    macrocells: buildMacrocells(samples, volume.grid.dimensions),
  };
}

/** Labels as plain values, for code that does not read lists of ids. */
export function withoutIds(volume: Volume): Volume {
  const { ids, samples, ...rest } = volume;
  if (!ids) return volume;
  const values = Float32Array.from(samples, (place) => ids[place]);
  return { ...rest, samples: values, macrocells: buildMacrocells(values, volume.grid.dimensions) };
}
