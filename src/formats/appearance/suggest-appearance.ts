import { windowFromHistogram } from '../../optics/transfer/window.ts';
import type { Samples } from '../../volume/samples.ts';
import type { Histogram } from '../../volume/histogram.ts';
import type { DecodedCartesianVolume } from '../base/decoded-volume.ts';
import { loadReader } from '../base/load-reader.ts';
import { presetOfUnit } from './suggested-appearance.ts';
import type { SuggestedAppearance } from './suggested-appearance.ts';

/** In a volume of labels most values between the smallest and the largest one are missing. */
const fewBins = 128;

/**
 * Where fewer than this share of the values lies above an eighth of their range, rules for unusual values are tried
 * too.
 */
const fewHigh = 0.05;

/** The number of samples that are searched for runs. */
const lookedAt = 2 ** 16;

/** Whether two changes of the value seldom follow each other directly. In a scan the value changes nearly everywhere. */
function hasRuns(samples: Samples): boolean {
  let [changes, next] = [0, 0];
  for (
    let i = (samples.length >> 1) - (lookedAt >> 1), changed = false;
    i < (samples.length >> 1) + (lookedAt >> 1);
    i++
  ) {
    const isOther = samples[i] !== samples[i - 1];
    if (isOther) changes++;
    if (isOther && changed) next++;
    changed = isOther;
  }
  return next < 0.3 * changes;
}

/**
 * The appearance that the values suggest, for files and manifests that give none. The code for everything except plain
 * pictures is loaded only when it may be needed.
 */
export async function suggestAppearance(
  decoded: DecodedCartesianVolume,
  histogram: Histogram,
): Promise<SuggestedAppearance> {
  const { window, transferFunction, unit } = decoded;
  const { low, counts } = histogram;
  const high = counts.subarray(counts.length / 8).reduce((sum, count) => sum + count);
  const isUnusual =
    !decoded.channels &&
    (unit === '' || decoded.isUptake) &&
    (decoded.isLabels ||
      decoded.intent ||
      decoded.indexed ||
      low < 0 ||
      hasRuns(decoded.samples) ||
      counts.filter(Boolean).length < fewBins ||
      high < fewHigh * decoded.samples.length);
  let found = isUnusual
    ? (await loadReader(() => import('./unusual-appearance.ts'))).findUnusualAppearance(decoded, histogram)
    : null;
  if (decoded.grid.dimensions.includes(1))
    found = (await loadReader(() => import('#rare/formats/appearance/slice-appearance.ts'))).sliceAppearance(
      decoded,
      histogram,
      found,
    );
  return {
    ...found,
    window:
      (decoded.intent && found?.transferFunction === 'diverging' ? null : window) ??
      found?.window ??
      windowFromHistogram(histogram),
    transferFunction: transferFunction ?? found?.transferFunction ?? presetOfUnit(unit),
  };
}
