// `npm run accuracy -- stated`: whether what the element says of its errors is true, in random scenes of all kinds.
// COUNT=25 takes so many scenes; ROWS=1 prints each; DETAIL=free lets small things go, see `detail`.
import { formatTable, printTable } from '../bench/table.mjs';
import { measureTables } from './measure-tables.mjs';
import { isKept, sumUp } from './sum-up-stated.mjs';

const { DETAIL: detail = 'keep' } = process.env;

/** Scenes of a run. */
const usual = { full: 100, quick: 20 };

/** @typedef {import('./stated-page.ts').StatedResult} StatedResult */

/** @param {{ quick: boolean }} options */
export const run = ({ quick }) =>
  measureTables({ quick }, async ({ page }) => {
    const results = await page.evaluate(
      async ({ from, count, detail }) => {
        const { measureStated } = /** @type {typeof import('./stated-page.ts')} */ (await import(from));
        return measureStated({ count, detail }, (what) => /** @type {any} */ (window).sayProgress(what));
      },
      {
        from: '/test/accuracy/stated-page.ts',
        count: Number(process.env.COUNT ?? (quick ? usual.quick : usual.full)),
        detail,
      },
    );
    if (process.env.ROWS === '1') printTable('Scenes', results.map(describeResult));
    return {
      [detail === 'keep' ? 'stated-random' : `stated-random-${detail}`]: formatTable(
        groupsOf(results).map(([name, group]) => ({ scenes: name, ...sumUp(group) })),
      ),
    };
  });

/** @param {StatedResult} result */
function describeResult(result) {
  const {
    name,
    maxError,
    stats: { steps, substeps, error: stated, keepsMaxError },
    error,
    coverage,
    uncertain,
  } = result;
  return {
    scene: name,
    'max-error': maxError,
    'steps × substeps': `${steps} × ${substeps}`,
    covered: `${(100 * coverage).toFixed(1)} %`,
    'RMSE stated': stated?.rms.toFixed(2) ?? 'no',
    true: error.rms.toFixed(2),
    'P99 stated': stated?.p99.toFixed(2) ?? 'no',
    'P99 true': error.p99.toFixed(2),
    'maximum stated': stated?.max?.toFixed(2) ?? 'no',
    'maximum true': error.max.toFixed(2),
    'P99.9 true': error.p999.toFixed(2),
    E: error.e.toFixed(2),
    kept: isKept(result) ? 'yes' : 'NO',
    'says so': String(keepsMaxError),
    'full rays differ by': uncertain.toFixed(2),
  };
}

/** All, and by what they have in common. @param {StatedResult[]} results @returns {[string, StatedResult[]][]} */
function groupsOf(results) {
  const values = (/** @type {(one: StatedResult) => string} */ of) =>
    [...new Set(results.map(of))].map(
      (value) => /** @type {[string, StatedResult[]]} */ ([value, results.filter((one) => of(one) === value)]),
    );
  return [
    ['all', results],
    ...values(({ name }) => name.split(', ')[0]),
    ...values(({ name }) => name.split(', ')[1]),
    ...values(({ maxError }) => `max-error ${maxError}`),
    ...values(({ coverage }) => (coverage < 0.1 ? 'covers less than 10 %' : 'covers more')),
  ];
}
