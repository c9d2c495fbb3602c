// `npm run accuracy -- trade`: what pictures at rest cost and what they show, by `max-error` and `detail`. SCENES=mri,wires takes the scenes with
// these words in their names; ERRORS=1,8 other values of `max-error`; DETAILS=free one of both; TIMES=1 adds times, which only a quiet machine gives.
import { formatTable, median } from '../bench/table.mjs';
import { chooseScenes } from './choose-scenes.mjs';
import { measureTables } from './measure-tables.mjs';

const { ERRORS = '16,8,4,2,1,0.5', DETAILS = 'keep,free' } = process.env;
const isTimed = process.env.TIMES === '1';

/** Of a short run every so manieth scene is taken. */
const few = 4;

/** A thing is lost where less of it is kept. */
const lost = 0.25;

/** @typedef {import('./trade-page.ts').TradeResult} TradeResult */
/** @typedef {{ name: string, result: TradeResult, work: number, ms: number }} Row */

/** @param {{ quick: boolean }} options */
export const run = ({ quick }) =>
  measureTables({ quick }, async ({ page }) => {
    const from = '/test/accuracy/trade-page.ts';
    const all = await page.evaluate(async (name) => /** @type {string[]} */ ((await import(name)).listTraded()), from);
    /** @type {Row[]} */
    const rows = [];
    for (const name of chooseScenes(all, quick && few)) {
      const results = await page.evaluate(
        async ({ module, scene, details, errors }) => {
          const { measureTrade } = /** @type {typeof import('./trade-page.ts')} */ (await import(module));
          return measureTrade(scene, { details, errors }, (what) => /** @type {any} */ (window).sayProgress(what));
        },
        {
          module: from,
          scene: name,
          details: /** @type {('keep' | 'free')[]} */ (DETAILS.split(',')),
          errors: ERRORS.split(',').map(Number),
        },
      );
      const usual = results.find(({ detail, maxError }) => detail === 'keep' && maxError === 1) ?? results[0];
      const of = (/** @type {TradeResult} */ result, /** @type {'samples' | 'frameMs'} */ what) =>
        result.stats[what] / usual.stats[what];
      rows.push(...results.map((result) => ({ name, result, work: of(result, 'samples'), ms: of(result, 'frameMs') })));
      if (process.env.ROWS === '1')
        for (const row of rows.slice(-results.length)) console.log(Object.values(describe(row)).join(' | '));
    }
    return { trade: formatTable(sumUp(rows)), 'trade-scenes': formatTable(rows.map(describe)) };
  });

/** @param {Row} row */
function describe({ name, result: { detail, maxError, stats, ms: toRest, e, max, things }, work, ms }) {
  return {
    scene: name,
    detail,
    'max-error': maxError,
    'steps × substeps': `${stats.steps} × ${stats.substeps}`,
    rays: `${(100 * stats.rays).toFixed(0)} %`,
    'steps of all rays': work.toFixed(2),
    ...(isTimed ? { 'time of the picture': ms.toFixed(2), 'time to it, ms': toRest.toFixed(0) } : {}),
    E: e.toFixed(2),
    'RMSE stated': stats.error ? stats.error.rms.toFixed(2) : 'no',
    'said to be kept': stats.keepsMaxError ? 'yes' : 'no',
    'largest error': max.toFixed(0),
    'things lost': things.length > 0 ? `${things.filter(({ kept }) => kept < lost).length} of ${things.length}` : '',
  };
}

/** @param {Row[]} rows */
function sumUp(rows) {
  const kinds = [...new Set(rows.map(({ result: { detail, maxError } }) => `${detail} ${maxError}`))];
  return kinds.map((kind) => {
    const group = rows.filter(({ result: { detail, maxError } }) => `${detail} ${maxError}` === kind);
    const { detail, maxError } = group[0].result;
    const things = group.flatMap(({ result }) => result.things);
    return {
      detail,
      'max-error': maxError,
      'rays, median': `${(100 * median(group.map(({ result }) => result.stats.rays))).toFixed(0)} %`,
      'steps of all rays, median': median(group.map(({ work }) => work)).toFixed(2),
      ...(isTimed ? { 'time, median': median(group.map(({ ms }) => ms)).toFixed(2) } : {}),
      'E kept': `${group.filter(({ result }) => result.e <= maxError).length} of ${group.length}`,
      'said to be kept, is not': group.filter(({ result }) => result.stats.keepsMaxError && result.e > 1.1 * maxError)
        .length,
      'things lost': `${things.filter(({ kept }) => kept < lost).length} of ${things.length}`,
    };
  });
}
