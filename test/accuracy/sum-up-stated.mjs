// What groups of scenes have in common, of which something was stated and is known.
import { median } from '../bench/table.mjs';

/** A root mean square error that is said to be this much smaller than it is, is misleading. */
export const misleading = 3;

/**
 * @typedef {object} Stated
 * @property {number} maxError - that was asked for
 * @property {Pick<import('../../src/viewer/model/render-stats.ts').RenderStats, 'error' | 'keepsMaxError'>} stats - as the element says it
 * @property {import('../helpers/covered-error.ts').CoveredError} error - as it is
 */

/** @param {readonly unknown[]} part @param {readonly unknown[]} whole */
const share = (part, whole) => (whole.length > 0 ? `${((100 * part.length) / whole.length).toFixed(0)} %` : '');

/** @param {Stated} one */
export const isKept = ({ error, maxError }) => error.e <= maxError;

/**
 * All results, and those of each kind.
 * @template {{ readonly kind: string }} Result
 * @param {Result[]} results
 * @returns {[string, Result[]][]}
 */
export function groupByKind(results) {
  const kinds = [...new Set(results.map(({ kind }) => kind))];
  return [
    ['all', results],
    ...kinds.map((kind) => /** @type {[string, Result[]]} */ ([kind, results.filter((one) => one.kind === kind)])),
  ];
}

/** @param {readonly Stated[]} group */
export function sumUp(group) {
  const reported = group.flatMap(({ stats: { error: stated }, error }) =>
    stated && error.rms > 0 ? [{ stated, error, ratio: stated.rms / error.rms }] : [],
  );
  const bounded = reported.flatMap(({ stated: { max }, error }) => (max === null ? [] : [{ max, error }]));
  const ratios = reported.map(({ ratio }) => ratio);
  return {
    count: group.length,
    'E kept': share(group.filter(isKept), group),
    'said to be kept, is not': group.filter((one) => one.stats.keepsMaxError === true && !isKept(one)).length,
    'RMSE stated within a factor of two': withinTwo(ratios),
    'understated by more than 3': ratios.filter((ratio) => ratio < 1 / misleading).length,
    'stated / true': spread(ratios),
    'stated maximum exceeded': `${bounded.filter(({ max, error }) => error.max > max).length} of ${bounded.length}`,
    'stated / true maximum, median':
      bounded.length > 0 ? median(bounded.map(({ max, error }) => max / error.max)).toFixed(2) : '',
  };
}

/** A largest error as it is stated. @param {number | null} max */
export const nameLargest = (max) => max?.toFixed(1) ?? 'no bound';

/** @param {readonly number[]} ratios - of what is stated to what is true */
export function withinTwo(ratios) {
  return share(
    ratios.filter((ratio) => ratio >= 0.5 && ratio <= 2),
    ratios,
  );
}

/** @param {readonly number[]} ratios */
export function spread(ratios) {
  return ratios.length > 0
    ? `${Math.min(...ratios).toFixed(2)} … ${median([...ratios]).toFixed(2)} … ${Math.max(...ratios).toFixed(2)}`
    : '';
}
