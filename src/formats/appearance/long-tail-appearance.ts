import type { Histogram } from '../../volume/histogram.ts';
import { otsuBin } from '../../optics/transfer/window.ts';
import type { DecodedCartesianVolume } from '../base/decoded-volume.ts';
import type { SuggestedAppearance } from './suggested-appearance.ts';

/** The number of bins, and the bins for each doubling of the value. The bins are logarithmic. */
const [logBins, perDoubling] = [96, 8];

/** Values that glow are at most this share of all values, and at least so many times as bright as the body around them. */
const glowing = { share: 0.02, times: 8 };

/** The body has at least so many times as many voxels as the parts that glow in it. */
const bodyTimes = 10;

/** The colours end where only this share of the voxels of body and glow lies above. */
const beyond = 0.005;

/**
 * Dark and thin where the body takes up little, so that the hot spots inside stay visible. The colours are hot iron,
 * the usual ones of nuclear medicine.
 */
const hotIron =
  '0% #160b39 0, 4% #2a115c 0.4%, 12% #5f187f 1.2%, 30% #b1325a 4%, 52% #ec6824 10%, 78% #f9b931 22%, 100% #fdf9c8 40%';

/**
 * The appearance of values with a long tail, such as the uptake of a tracer in PET: a few places glow many times as
 * bright as the body. A window around these alone would show nothing else. Null for any other values.
 */
export function longTailAppearance(
  { samples, slope, intercept }: DecodedCartesianVolume,
  { low, high, counts }: Histogram,
): SuggestedAppearance | null {
  const firstBin = otsuBin(counts);
  if (!(high > low) || low < -0.02 * high || sum(counts.subarray(firstBin)) > glowing.share * samples.length)
    return null;
  const glowFrom = low + (firstBin / counts.length) * (high - low);
  /** Counts of values by how many doublings they lie below the highest one. */
  const logs = new Uint32Array(logBins);
  for (const stored of samples) {
    const value = slope * stored + intercept;
    const bin = value > 0 ? logBins - 1 - Math.floor(perDoubling * Math.log2(high / value)) : -1;
    if (bin >= 0) logs[bin]++;
  }
  const valueAt = (bin: number): number => high * 2 ** ((bin - logBins + 1) / perDoubling);
  const glowBin = Math.max(0, Math.floor(logBins - 1 + perDoubling * Math.log2(glowFrom / high)));
  const glow = logs.subarray(glowBin);
  // Values darker than the body are noise around it.
  const bodyBin = otsuBin(logs.subarray(0, glowBin));
  const body = logs.subarray(bodyBin, glowBin);
  if (sum(body) < bodyTimes * sum(glow)) return null;
  if (valueAt(glowBin + quantile(glow, 0.5)) < glowing.times * valueAt(bodyBin + quantile(body, 0.5))) return null;
  return {
    window: [0, valueAt(bodyBin + quantile(logs.subarray(bodyBin), 1 - beyond) + 1)],
    transferFunction: hotIron,
  };
}

function sum(counts: Uint32Array): number {
  return counts.reduce((total, count) => total + count, 0);
}

/** The bin at which a share of all counts is reached. */
function quantile(counts: Uint32Array, share: number): number {
  const wanted = share * sum(counts);
  let reached = 0;
  const bin = counts.findIndex((count) => (reached += count) >= wanted);
  return Math.max(0, bin);
}
