// Rows of tables from the measurements of a scene of small things.
import { median } from '../bench/table.mjs';

/** Kept shares of the contrast: below the first a thing is lost, below the second dimmed, above the third too bright. */
const limits = { lost: 0.25, dimmed: 0.75, bright: 1.25 };

/** A thing blinks where its kept share changes by more from one angle to the next. */
const steady = 0.25;

/** The default of `max-error`. */
const maxError = 1;

/**
 * What became of things, counted over several angles.
 * @typedef {{ shown: number, lost: number, dimmed: number, bright: number, minKept: number | null, blinks: number, pairs: number }} ThingCounts
 */

/**
 * @param {readonly (readonly (import('./compare-shown.ts').KeptThing | null)[])[]} pictures - by thing; null where a view does not hold it
 * @param {number} minContrast - things with less do not count, 1/255
 * @returns {ThingCounts}
 */
export function countThings(pictures, minContrast) {
  const shown = pictures.map((things) =>
    things.map((thing) => (thing && thing.contrast >= minContrast ? thing.kept : null)),
  );
  const kept = shown.flat().filter((share) => share !== null);
  const pairs = shown
    .slice(1)
    .flatMap((shares, i) =>
      shares.map((share, n) => (share === null || shown[i][n] === null ? null : Math.abs(share - shown[i][n]))),
    );
  const compared = pairs.filter((change) => change !== null);
  return {
    shown: kept.length,
    lost: kept.filter((share) => share < limits.lost).length,
    dimmed: kept.filter((share) => share >= limits.lost && share < limits.dimmed).length,
    bright: kept.filter((share) => share > limits.bright).length,
    minKept: kept.length > 0 ? Math.min(...kept) : null,
    blinks: compared.filter((change) => change > steady).length,
    pairs: compared.length,
  };
}

/** @param {number | null} share */
const percentOf = (share) => (share === null ? '' : `${(100 * share).toFixed(0)} %`);

/**
 * What became of a scene's things, counted over all its angles.
 * @param {Pick<import('./small-page.ts').SmallResult, 'name' | 'pixelsPerVoxel' | 'ratio' | 'minContrast'> & { pictures: readonly Pick<import('./small-page.ts').SmallPicture, 'things'>[] }} result
 */
export function sumUpThings({ name, pixelsPerVoxel, ratio, minContrast, pictures }) {
  const { shown, lost, dimmed, bright, minKept, blinks, pairs } = countThings(
    pictures.map(({ things }) => things),
    minContrast,
  );
  return {
    scene: name,
    'pixels a voxel': pixelsPerVoxel,
    'device pixel ratio': ratio,
    shown,
    lost,
    dimmed,
    'too bright': bright,
    'least kept': percentOf(minKept),
    'blinks, of pairs': `${blinks} of ${pairs}`,
  };
}

/**
 * What became of a scene's things in motion, by what a frame has time for: of all that are shown the share that is lost or dimmed, and of all pairs the share that blinks.
 * @param {import('./moving-page.ts').MovingResult} result
 */
export function sumUpMotion({ name, pixels, budgets }) {
  const percent = (/** @type {number} */ part, /** @type {number} */ whole) => percentOf(part / Math.max(1, whole));
  return {
    scene: name,
    ...Object.fromEntries(
      budgets.map(({ share, scale, steps, counts: { shown, lost, dimmed, blinks, pairs } }) => [
        share === 1 ? 'all of it' : `1/${Math.round(1 / share)}`,
        `${percent(lost + dimmed, shown)}, ${percent(blinks, pairs)}${share === 1 ? '' : ` (${Math.round(scale * pixels)}², ${steps})`}`,
      ]),
    ),
  };
}

/**
 * What the element says of its errors, and what they are.
 * @param {import('./small-page.ts').SmallResult} result
 */
export function sumUpErrors({ name, pictures, uncertain }) {
  const errors = pictures.map(({ error }) => error);
  const reported = pictures.flatMap(({ stats: { error: stated }, error }) => (stated ? [{ stated, error }] : []));
  const ratios = reported.map(({ stated, error }) => stated.rms / error.rms);
  const largest = (/** @type {(error: import('../helpers/covered-error.ts').CoveredError) => number} */ of) =>
    Math.max(...errors.map(of)).toFixed(2);
  return {
    scene: name,
    'steps × substeps': [...new Set(pictures.map(({ stats: { steps, substeps } }) => `${steps} × ${substeps}`))].join(
      ', ',
    ),
    covered: `${(100 * median(pictures.map(({ coverage }) => coverage))).toFixed(0)} %`,
    'RMSE, median': median(errors.map(({ rms }) => rms)).toFixed(2),
    worst: largest(({ rms }) => rms),
    'worst P99': largest(({ p99 }) => p99),
    'worst P99.9': largest(({ p999 }) => p999),
    largest: largest(({ max }) => max),
    'E kept': `${errors.filter(({ e }) => e <= maxError).length} of ${errors.length}`,
    'said to be kept, is not': pictures.filter(({ stats, error }) => stats.keepsMaxError === true && error.e > maxError)
      .length,
    'stated / true RMSE':
      ratios.length > 0 ? `${Math.min(...ratios).toFixed(2)} … ${Math.max(...ratios).toFixed(2)}` : 'not stated',
    'stated maximum, median':
      reported.length > 0 ? median(reported.map(({ stated }) => stated.max ?? Infinity)).toFixed(1) : '',
    exceeded: reported.filter(({ stated, error }) => stated.max !== null && error.max > stated.max).length,
    'full rays: to twice the steps, to float64': `${uncertain.ofSteps.toFixed(2)}, ${uncertain.ofFloats.toFixed(2)}`,
  };
}

/**
 * The error E of each level at the first angle, and in brackets how many things it dims or loses.
 * @param {import('./small-page.ts').SmallResult} result
 */
export function sumUpLevels({ name, minContrast, levels }) {
  return {
    scene: name,
    ...Object.fromEntries(
      levels.map(({ stepsPerVoxel, substeps, e, things }) => {
        const dimmed = things.filter(
          (thing) => thing && thing.contrast >= minContrast && thing.kept < limits.dimmed,
        ).length;
        return [`${stepsPerVoxel} × ${substeps}`, `${e.toFixed(2)}${minContrast > 0 ? ` (${dimmed})` : ''}`];
      }),
    ),
  };
}
