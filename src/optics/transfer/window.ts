import type { Histogram } from '../../volume/histogram.ts';
import { spanAround } from './span-around.ts';

/** The subject's median lies at this share of the window or above. So if a few voxels are far brighter than the rest, they are white. */
const usualShare = 0.5;

/**
 * The data range in which a volume's subject lies, from its histogram. It begins where the background (air, nothing)
 * ends, and it ends above all but a few bright voxels.
 *
 * Otsu's threshold separates the background from the subject: the value that splits the histogram into the two
 * classes that differ the most. The window begins a little below it, so that it includes the subject's skin.
 * @returns [low, high] in data units, low < high
 * Source: Otsu, *A threshold selection method from gray-level histograms*, 1979
 */
export function windowFromHistogram(histogram: Histogram): [number, number] {
  const { low, high, counts } = histogram;
  if (!(high > low)) return spanAround(low);
  // Divide first: the width times a bin may be larger than any float.
  const toValue = (bin: number) => low + (high - low) * (bin / counts.length);
  const threshold = otsuBin(counts);
  const subject = counts.subarray(threshold);
  const start = threshold * 0.8;
  const usual = threshold + percentileBin(subject, 0.5) + 1;
  const top = Math.min(threshold + percentileBin(subject, 0.995) + 1, start + (usual - start) / usualShare);
  return [toValue(start), toValue(Math.max(top, threshold + 1))];
}

/** The first bin of the upper class by Otsu's threshold. */
export function otsuBin(counts: Uint32Array): number {
  let total = 0;
  let moment = 0;
  for (let i = 0; i < counts.length; i++) {
    total += counts[i];
    moment += i * counts[i];
  }
  let below = 0;
  let momentBelow = 0;
  let best = 0;
  let bestSpread = -1;
  for (let i = 0; i < counts.length - 1; i++) {
    below += counts[i];
    momentBelow += i * counts[i];
    const above = total - below;
    if (below === 0 || above === 0) continue;
    const spread = below * above * (momentBelow / below - (moment - momentBelow) / above) ** 2;
    if (spread > bestSpread) {
      bestSpread = spread;
      best = i + 1;
    }
  }
  return best;
}

/** The bin at which the sum of counts reaches a share of all. */
function percentileBin(counts: Uint32Array, share: number): number {
  let total = 0;
  for (const count of counts) total += count;
  let sum = 0;
  for (let i = 0; i < counts.length; i++) {
    sum += counts[i];
    if (sum >= share * total) return i;
  }
  return counts.length - 1;
}
