// What a pyramid hides whose maker says nothing of it: learnt from the levels that are resident.
import type { Vector3 } from '../volume/matrix.ts';
import type { HiddenValues } from './hidden-values.ts';
import { halve } from './pyramid.ts';
import type { Pyramid } from './pyramid.ts';
import { blockFinder } from './resident-field.ts';
import { measureResiduals } from './residuals.ts';

/** How far a level is from the next coarser one, by cell, in stored values. */
export interface Octave {
  readonly rms: Float32Array;
  readonly max: Float32Array;
}

/** Further levels that are made of the coarsest one, so that something is known as soon as it has come. */
const madeLevels = 2;

/** An octave has at least this share and at most so many times the detail of the next coarser one. */
const limits = [0.25, 3] as const;

/**
 * The octaves of a pyramid, from the finest on, with two more below its coarsest level. A cell (brick of level 0) knows those from its resident level on.
 */
export function measureOctaves({ levels, side }: Pyramid): Octave[] {
  const all = [...levels];
  for (let n = 0; n < madeLevels; n++) all.push(halve(all[all.length - 1]));
  return all.slice(0, -1).map((level, n) => {
    const { levels: found } = measureResiduals({ levels: [level, all[n + 1]] }, side / 2 ** n);
    return found[1];
  });
}

/** Learns what is hidden; `update` it when bricks have come. */
export interface LearntDetail extends HiddenValues {
  update(levelOf: Uint8Array): void;
}

/**
 * Each octave that is not known of a cell has so many times the detail of the next coarser one as the same octave has elsewhere; or, where it is
 * known nowhere, as the last known one has.
 * @param octaves - as `measureOctaves` finds them; only those that a cell knows are read
 * @param dimensions - of level 0
 * @param range - smallest and largest stored value that may be there
 */
export function learnDetail(
  { side, levels }: Pick<Pyramid, 'side' | 'levels'>,
  octaves: readonly Octave[],
  dimensions: Vector3,
  range: readonly [number, number],
): LearntDetail {
  const cells = octaves[0].rms.length;
  const hidden = levels.map(() => ({ rms: new Float32Array(cells), max: new Float32Array(cells) }));
  const growth = new Float64Array(octaves.length);
  const learn = (levelOf: Uint8Array): void => {
    for (let n = octaves.length - 2; n >= 0; n--) {
      let [fine, coarse] = [0, 0];
      for (let cell = 0; cell < cells; cell++) {
        if (levelOf[cell] > n) continue;
        fine += octaves[n].rms[cell] ** 2;
        coarse += octaves[n + 1].rms[cell] ** 2;
      }
      const before = n + 2 < octaves.length ? growth[n + 1] : 1;
      growth[n] = coarse > 0 ? Math.min(limits[1], Math.max(limits[0], Math.sqrt(fine / coarse))) : before;
    }
  };
  return {
    update: (levelOf) => {
      learn(levelOf);
      for (let cell = 0; cell < cells; cell++) {
        const present = levelOf[cell];
        const rms = new Float64Array(present);
        for (let n = present - 1, last = octaves[present].rms[cell]; n >= 0; n--) rms[n] = last *= growth[n];
        const peak = octaves[present].max[cell] / Math.max(octaves[present].rms[cell], 1e-30);
        for (let level = 1, square = 0; level <= present; level++) {
          square += rms[level - 1] ** 2;
          hidden[level].rms[cell] = Math.sqrt(square);
          // Few values are far off where few were in the octave that is known.
          hidden[level].max[cell] = Math.max(2, peak) * hidden[level].rms[cell];
        }
      }
    },
    blockAt: blockFinder(dimensions, side),
    rms: (block, level) => hidden[level].rms[block],
    max: (block, level) => hidden[level].max[block],
    low: () => range[0],
    high: () => range[1],
  };
}
