// `npm run accuracy -- lit`: whether what is said of errors is true in scenes with light, surfaces, X3D's styles, value and
// gradient, and of radars. ROWS=1 prints each.
import { formatTable, printTable } from '../bench/table.mjs';
import { measureTables } from './measure-tables.mjs';
import { groupByKind, isKept, nameLargest, spread, sumUp, withinTwo } from './sum-up-stated.mjs';

/** @typedef {import('./lit-page.ts').LitResult} LitResult */

/** @param {{ quick: boolean }} options */
export const run = ({ quick }) =>
  measureTables({ quick }, async ({ page }) => {
    const results = await page.evaluate(
      async ({ from, isShort }) => {
        const { measureLit } = /** @type {typeof import('./lit-page.ts')} */ (await import(from));
        return measureLit(isShort, (what) => /** @type {any} */ (window).sayProgress(what));
      },
      { from: '/test/accuracy/lit-page.ts', isShort: quick },
    );
    if (process.env.ROWS === '1') printTable('Scenes', results.map(describeResult));
    const missed = results.filter((one) => !isKept(one) || !one.stats.keepsMaxError);
    return {
      'stated-lit': formatTable(
        groupByKind(results).map(([name, group]) => ({ scenes: name, ...describeGroup(group) })),
      ),
      'missed-lit': missed.length > 0 ? formatTable(missed.map(describeMissed)) : 'None.',
    };
  });

/** @param {LitResult[]} group */
function describeGroup(group) {
  const coarse = group.map(({ coarse: { stated, error } }) => stated.rms / error.rms);
  const { 'E kept': kept, 'RMSE stated within a factor of two': within, ...rest } = sumUp(group);
  return {
    count: group.length,
    'coarse: RMSE stated within a factor of two': withinTwo(coarse),
    'stated / true, coarse': spread(coarse),
    'at rest: within a factor of two': within,
    'stated / true': rest['stated / true'],
    'E kept': kept,
    'said not to be kept, is not': group.filter((one) => !one.stats.keepsMaxError && !isKept(one)).length,
    'said to be kept, is not': rest['said to be kept, is not'],
    'stated maximum exceeded': rest['stated maximum exceeded'],
    'stated / true maximum, median': rest['stated / true maximum, median'],
  };
}

/** What does not keep `max-error`, or is said not to. @param {LitResult} result */
function describeMissed(result) {
  const { kind, name, stats, error, level, uncertain } = result;
  return {
    scene: `${kind}: ${name}`,
    'samples a voxel × substeps': `${level.samplesAVoxel.toFixed(0)} × ${level.substeps}`,
    E: error.e.toFixed(2),
    'RMSE stated': stats.error.rms.toFixed(2),
    true: error.rms.toFixed(2),
    'says that it is kept': stats.keepsMaxError ? 'yes' : 'no',
    'full rays, to half the steps': uncertain.toFixed(2),
  };
}

/** @param {LitResult} result */
function describeResult(result) {
  const { coarse, stats, error } = result;
  return {
    ...describeMissed(result),
    'coarse RMSE stated': coarse.stated.rms.toFixed(2),
    'coarse true': coarse.error.rms.toFixed(2),
    'maximum stated': nameLargest(stats.error.max),
    'maximum true': error.max.toFixed(1),
    kept: isKept(result) ? 'yes' : 'NO',
  };
}
