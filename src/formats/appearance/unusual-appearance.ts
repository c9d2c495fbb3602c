import type { Histogram } from '../../volume/histogram.ts';
import { maxLabels } from '../../volume/index-numbers.ts';
import type { DecodedCartesianVolume } from '../base/decoded-volume.ts';
import { labelAppearance } from './label-appearance.ts';
import { longTailAppearance } from './long-tail-appearance.ts';
import { presetOfUnit } from './suggested-appearance.ts';
import type { SuggestedAppearance } from './suggested-appearance.ts';

/**
 * The appearance of Hounsfield units, of labels, of a mask, of values on both sides of 0, and of a few values far above
 * all others; null for anything else.
 */
export function findUnusualAppearance(
  decoded: DecodedCartesianVolume,
  histogram: Histogram,
): SuggestedAppearance | null {
  if (decoded.isUptake) return longTailAppearance(decoded, histogram);
  if (isCt(histogram)) return { transferFunction: presetOfUnit('HU') };
  if (statistics.includes(decoded.intent ?? 0)) return statisticAppearance(decoded, histogram);
  return decoded.isLabels || areLabels(decoded)
    ? labelAppearance(decoded)
    : (signedAppearance(histogram) ?? longTailAppearance(decoded, histogram));
}

/**
 * NIfTI's codes for maps in which 0 means no effect: correlation, t, F, z, chi squared, and logarithms of p. Maps of p
 * itself are not listed: there 0 is the strongest effect. Source: nifti1.h, NIFTI_INTENT
 */
const statistics: readonly number[] = [2, 3, 4, 5, 6, 23, 24];

/**
 * The appearance of a map that its file calls a statistic: 0 is transparent, whichever signs occur, and both ends are
 * equally far from 0. The file's window, which mostly starts at a threshold, gives that distance.
 */
function statisticAppearance({ window }: DecodedCartesianVolume, { low, high }: Histogram): SuggestedAppearance {
  const farthest = Math.max(...(window ?? [low, high]).map(Math.abs)) || 1;
  return { window: [-farthest, farthest], transferFunction: 'diverging' };
}

/**
 * Whether values are Hounsfield units: some air, about -1000; some soft tissue or water, about 0; fewer values between
 * them; and almost nothing below the air except one value that marks what was not scanned.
 */
function isCt({ low, high, counts }: Histogram): boolean {
  if (low > -900 || high < 150) return false;
  const width = (high - low) / counts.length;
  const total = counts.reduce((sum, count) => sum + count, 0);
  /** Share of the values between two numbers, for each 100 units. */
  const density = (from: number, to: number): number => {
    const bins = counts.subarray(
      Math.max(0, Math.round((from - low) / width)),
      Math.max(0, Math.round((to - low) / width)),
    );
    return (bins.reduce((sum, count) => sum + count, 0) / total) * (100 / (to - from));
  };
  const [air, tissue, between] = [density(-1100, -700), density(-200, 200), density(-600, -300)];
  return air > 0.01 && tissue > 0.01 && Math.min(air, tissue) > 2 * between && density(low + width, -1150) < 0.05;
}

/** The number of rows of voxels that are examined to find out whether these are labels. */
const rowsLookedAt = 2048;

/**
 * If the file does not call a few different values labels: as labels, the largest value is at most this times their
 * number.
 */
const maxSpread = 32;

/**
 * If a volume has more values than this: in labels, neighbours in space seldom have values that are next to each other
 * in size. In a smooth scan most changes are of that kind.
 */
const fewLabels = 8;

/**
 * In a volume of labels with more values than this, the same values meet again and again: each thing has few
 * neighbours.
 */
const manyLabels = 256;

/**
 * Whether whole numbers lie in patches along the rows: two changes of the value seldom follow each other directly, and
 * any value may follow any other.
 */
function areLabels({
  samples: all,
  slope,
  intercept,
  indexed,
  grid: {
    dimensions: [nx, ny, nz],
  },
}: DecodedCartesianVolume): boolean {
  const samples = indexed?.samples ?? all;
  const values = new Map<number, number>(); // Value to its number, in the order in which they were found.
  const changes = new Map<number, number>();
  let [met, steps] = [0, 0];
  const apart = Math.ceil((ny * nz) / rowsLookedAt);
  for (let row = 0; row < ny * nz; row += apart) {
    let [last, from] = [NaN, -1];
    let changed = false;
    for (const stored of samples.subarray(row * nx, (row + 1) * nx)) {
      const isOther = stored !== last;
      if (isOther) {
        const value = indexed ? indexed.ids[stored] : slope * stored + intercept;
        if (!Number.isSafeInteger(value) || value < 0) return false;
        const to = values.get(value) ?? values.size;
        if (to === maxLabels) return false;
        values.set(value, to);
        if (from >= 0) {
          const pair = from * maxLabels + to;
          changes.set(pair, (changes.get(pair) ?? 0) + 1);
          met++;
        }
        if (changed) steps++;
        from = to;
      }
      changed = isOther && last === last;
      last = stored;
    }
  }
  if (values.size <= 2) return values.size === 2;
  const rising = [...values.keys()];
  rising.sort((a, b) => a - b);
  const numbers = rising.map((value) => values.get(value)!);
  const count = (from: number, to: number): number => changes.get(from * maxLabels + to) ?? 0;
  const near = numbers
    .slice(1)
    .reduce((sum, number, i) => sum + count(numbers[i], number) + count(number, numbers[i]), 0);
  const arePatches = steps < 0.3 * met && (values.size <= fewLabels || near < 0.5 * met);
  if (!arePatches) return false;
  if (values.size > manyLabels) return changes.size < 0.5 * met;
  return values.size > fewLabels || indexed !== undefined || rising[rising.length - 1] <= maxSpread * values.size;
}

/**
 * The appearance of a map of both signs, such as a t statistic: 0 has no colour, and both ends are equally far from it.
 * The file's window, which mostly starts at a threshold, gives that distance.
 */
function signedAppearance({ low, high, counts }: Histogram): SuggestedAppearance | null {
  const smaller = Math.min(-low, high);
  const farthest = Math.max(-low, high);
  if (!(smaller > 0.1 * farthest)) return null;
  const zero = Math.floor((-low / (high - low)) * counts.length);
  // Values around 0 are more frequent than elsewhere: they are background or noise.
  const around = counts.subarray(Math.max(0, zero - 8), zero + 9).reduce((sum, count) => sum + count, 0);
  const total = counts.reduce((sum, count) => sum + count, 0);
  return around > ((2 * 17) / counts.length) * total
    ? { window: [-farthest, farthest], transferFunction: 'diverging' }
    : null;
}
