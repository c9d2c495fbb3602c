import type { Histogram } from '../../volume/histogram.ts';
import { mostLabels } from '../../volume/index-numbers.ts';
import type { DecodedCartesianVolume } from '../base/decoded-volume.ts';
import { labelLook } from './label-look.ts';
import { longTailLook } from './long-tail-look.ts';
import { presetOfUnit } from './suggested-look.ts';
import type { SuggestedLook } from './suggested-look.ts';

/** The look of Hounsfield units, of labels, of a mask, of values on both sides of 0, and of few that are far above all others; null for anything else. */
export function findUnusualLook(decoded: DecodedCartesianVolume, histogram: Histogram): SuggestedLook | null {
  if (isCt(histogram)) return { transferFunction: presetOfUnit('HU') };
  if (statistics.includes(decoded.intent ?? 0)) return statisticLook(decoded, histogram);
  return decoded.isLabels || areLabels(decoded) ? labelLook(decoded) : signedLook(histogram) ?? longTailLook(decoded, histogram);
}

/**
 * NIfTI's codes for maps in which 0 is no effect: correlation, t, F, z, chi squared, and logarithms of p. In one of p itself 0 is the
 * strongest. Source: nifti1.h, NIFTI_INTENT
 */
const statistics: readonly number[] = [2, 3, 4, 5, 6, 23, 24];

/** Of a map that says that it is one of statistics: 0 is clear, whichever signs there are; both ends are as far from it. A window in the file, from a threshold on as a rule, says how far. */
function statisticLook({ window }: DecodedCartesianVolume, { low, high }: Histogram): SuggestedLook {
  const farthest = Math.max(...(window ?? [low, high]).map(Math.abs)) || 1;
  return { window: [-farthest, farthest], transferFunction: 'diverging' };
}

/**
 * Whether values are Hounsfield units: some air, about -1000, some soft tissue or water, about 0, fewer between them, and next to
 * nothing below the air but one value that stands for what was not scanned.
 */
function isCt({ low, high, counts }: Histogram): boolean {
  if (low > -900 || high < 150) return false;
  const width = (high - low) / counts.length;
  const total = counts.reduce((sum, count) => sum + count, 0);
  /** Share of the values from one to another, for each 100 units. */
  const density = (from: number, to: number): number => {
    const bins = counts.subarray(Math.max(0, Math.round((from - low) / width)), Math.max(0, Math.round((to - low) / width)));
    return (bins.reduce((sum, count) => sum + count, 0) / total) * (100 / (to - from));
  };
  const [air, tissue, between] = [density(-1100, -700), density(-200, 200), density(-600, -300)];
  return air > 0.01 && tissue > 0.01 && Math.min(air, tissue) > 2 * between && density(low + width, -1150) < 0.05;
}

/** Rows of voxels that are looked at to find out whether these are labels. */
const rowsLookedAt = 2048;

/** Values of labels that are not said to be labels are no more spread than this, where few. */
const mostSpread = 32;

/** Of more values than this, those next to each other in size seldom meet where they are labels; a smooth scan has few other changes. */
const fewLabels = 8;

/** Of more values than this, the same ones meet again and again where they are labels: each thing has few neighbours. */
const manyLabels = 256;

/** Whether whole numbers lie in patches: next to where one ends, another seldom ends, and it may be any that begins. */
function areLabels({ samples: all, slope, intercept, indexed, grid: { dimensions: [nx, ny, nz] } }: DecodedCartesianVolume): boolean {
  const samples = indexed?.samples ?? all;
  const values = new Map<number, number>(); // Each with its number, in the order of being met.
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
        if (to === mostLabels) return false;
        values.set(value, to);
        if (from >= 0) {
          const pair = from * mostLabels + to;
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
  const count = (from: number, to: number): number => changes.get(from * mostLabels + to) ?? 0;
  const near = numbers.slice(1).reduce((sum, number, i) => sum + count(numbers[i], number) + count(number, numbers[i]), 0);
  const arePatches = steps < 0.3 * met && (values.size <= fewLabels || near < 0.5 * met);
  if (!arePatches) return false;
  if (values.size > manyLabels) return changes.size < 0.5 * met;
  return values.size > fewLabels || indexed !== undefined || rising[rising.length - 1] <= mostSpread * values.size;
}

/** Of a map of both signs, such as a t statistic: 0 has no colour, and both ends are as far from it. A window in the file, from a threshold on as a rule, says how far. */
function signedLook({ low, high, counts }: Histogram): SuggestedLook | null {
  const least = Math.min(-low, high);
  const farthest = Math.max(-low, high);
  if (!(least > 0.1 * farthest)) return null;
  const zero = Math.floor((-low / (high - low)) * counts.length);
  // Around 0 there are more than elsewhere: nothing there, or noise.
  const around = counts.subarray(Math.max(0, zero - 8), zero + 9).reduce((sum, count) => sum + count, 0);
  const total = counts.reduce((sum, count) => sum + count, 0);
  return around > (2 * 17 / counts.length) * total ? { window: [-farthest, farthest], transferFunction: 'diverging' } : null;
}
