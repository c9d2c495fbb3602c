// What is known of the values along a ray that shows its largest value, or its smallest: what is shown, and what may be hidden.
import { levelWithoutBrick } from './detail-field.ts';
import { maxSteps } from './detail-scene.ts';
import type { DetailRay, DetailScene, ExtremeLook } from './detail-scene.ts';
import { boxesOf, spreadAt } from './hidden-means.ts';
import type { HiddenSpread } from './hidden-means.ts';
import { alongOfNoise, voxelsTogether } from './hidden-values.ts';

/** Samples that a step takes at most, where its level has several voxels in it. */
const mostSamples = 4;

/**
 * Half of what is hidden are single voxels as far off as the largest residual. So many of them does a ray meet in a voxel's length, times the square of the root mean square over
 * that residual: 4 of each, as interpolation spreads one over 2 x 2 voxels across, and (2/3)^3 of its square is left between voxels. Such a peak has more than the share t of its
 * height with the probability 1 - t + t ln t: the area in which (1 - x) (1 - y) > t.
 */
const peaksOfVariance = (4 * 0.5) / (2 / 3) ** 3;

/** What a value may be, times the sign: the largest counts. Anything within `width` of the center, or a peak up to `max` above it. */
export interface Spread {
  readonly center: number;
  readonly low: number;
  readonly high: number;
  readonly max: number;
  readonly width: number;
  /** How likely a peak is. */
  readonly peaks: number;
  /** How many such values there are in a step, independent of each other. */
  readonly draws: number;
  /** How many peaks there may be in a step: one in each voxel of the finest level that counts. */
  readonly peakDraws: number;
}

/** A step of a ray. */
export interface Step {
  readonly cell: number;
  readonly level: number;
  readonly block: number;
  readonly due: number;
  /** What is shown there, times the sign; -Infinity for no data. */
  readonly value: number;
  /** What may be there; null where it is known. */
  readonly now: Spread | null;
  /** The same if the brick were not there. */
  readonly without: Spread | null;
}

/** What a picture looks like where the largest value is known: four channels, on what is behind. */
export type Look = (value: number) => readonly number[];

/** What is expected of a ray. */
export interface Found {
  readonly energy: number;
  readonly cover: number;
  /** By cell: the part of the energy that goes with it, and how much more it would be without its brick. */
  readonly cells: readonly { readonly steps: readonly Step[]; readonly energy: number; readonly loss: number }[];
}

/** Walks a ray through what is resident. */
export function walker(
  { field, hidden, isAway, finestAt = () => 0, voxels = 1, extreme }: DetailScene,
  isLossAsked: boolean,
): (ray: DetailRay) => Step[] {
  const { sign } = extreme as ExtremeLook;
  const levelWithout = levelWithoutBrick(field, isLossAsked);
  const spreadOf = (block: number, at: Parameters<typeof spreadAt>[2]): Spread | null => {
    const spread = spreadAt(hidden, block, at);
    if (!spread) return null;
    const together = Math.max(1, hidden.correlation?.(at.level) ?? 1);
    // Peaks are single voxels of the finest level, except in what is smooth.
    const smooth = Math.max(1, together / 2 ** (at.level - 1) / voxelsTogether(alongOfNoise));
    return signed(spread, sign, [voxels / together, voxels / 2 ** at.due / smooth]);
  };
  return ({ point, direction, entry, exit, dt }) => {
    const steps: Step[] = [];
    const count = Math.min(maxSteps, Math.ceil((exit - entry) / dt));
    for (let n = 0; n < count; n++) {
      const placeAt = (share: number): [number, number, number] => {
        const t = Math.min(exit, entry + (n + share) * dt);
        return [point[0] + t * direction[0], point[1] + t * direction[1], point[2] + t * direction[2]];
      };
      const middle = placeAt(0.5);
      if (isAway?.(...middle)) continue;
      const cell = field.cellAt(...middle);
      const level = field.levelOf(cell);
      const samples = Math.min(mostSamples, Math.max(1, Math.ceil(voxels / 2 ** level)));
      let value = -Infinity;
      for (let i = 0; i < samples; i++) {
        const one = sign * field.valueAt(...(samples === 1 ? middle : placeAt((i + 0.5) / samples)));
        if (one > value) value = one;
      }
      const due = finestAt(entry + (n + 0.5) * dt);
      const block = hidden.blockAt(...middle);
      const known = value === -Infinity ? NaN : sign * value;
      const now = spreadOf(block, { value: known, due, level });
      const other = levelWithout(cell, level);
      const without = other === level ? now : spreadOf(block, { value: known, due, level: other });
      if (value > -Infinity || now || without) steps.push({ cell, level, block, due, value, now, without });
    }
    return steps;
  };
}

function signed(
  { center, rms, max, low, high }: HiddenSpread,
  sign: 1 | -1,
  [draws, peakDraws]: readonly [number, number],
): Spread {
  const [ends, middle] = [[sign * low, sign * high], sign * center];
  const [least, most] = [Math.min(...ends), Math.max(...ends)];
  const [up, down] = [Math.min(max, most - middle), Math.min(max, middle - least)];
  return {
    center: middle,
    low: least,
    high: most,
    max,
    width: boxesOf(rms, max).width,
    peaks: up > 0 ? Math.min(0.5, (peaksOfVariance * (rms / max) ** 2 * up) / (up + Math.max(0, down))) : 0,
    draws,
    peakDraws,
  };
}
