// `npm run accuracy -- projected`: whether what is said of projections' errors is true, in scenes that were made to break it: all of their rays are
// cast in float64 beside them, which miss nothing. SCENES=wires,max takes those with these words in their names; ROWS=1 prints each.
import { formatTable } from '../bench/table.mjs';
import { listFaults } from './hard.mjs';
import { chooseScenes } from './choose-scenes.mjs';
import { measureTables } from './measure-tables.mjs';
import { groupByKind, isKept, nameLargest, sumUp } from './sum-up-stated.mjs';

/** @typedef {import('./hard-page.ts').HardResult} HardResult */

/** Of a short run every so manieth scene is taken: of each volume and each projection some. */
const few = 7;

/** @param {{ quick: boolean }} options */
export const run = ({ quick }) =>
  measureTables({ quick }, async ({ page }) => {
    const from = '/test/accuracy/projected-page.ts';
    const all = await page.evaluate(
      async (name) => /** @type {string[]} */ ((await import(name)).listProjected()),
      from,
    );
    const wanted = chooseScenes(all, quick && few);
    /** @type {HardResult[]} */
    const results = [];
    for (const [i, name] of wanted.entries()) {
      results.push(
        await page.evaluate(
          async ({ module, scene, progress }) => {
            const { measureProjected } = /** @type {typeof import('./projected-page.ts')} */ (await import(module));
            /** @type {any} */ (window).sayProgress(progress);
            return measureProjected(scene);
          },
          { module: from, scene: name, progress: `scene ${i + 1} of ${wanted.length}: ${name}` },
        ),
      );
      if (process.env.ROWS === '1') console.log(Object.values(describeResult(results[i])).join(' | '));
    }
    const broken = results.filter((one) => listFaults(one).length > 0 || !isKept(one));
    return {
      'stated-projected': formatTable(
        groupByKind(results).map(([name, group]) => {
          const {
            'said to be kept, is not': kept,
            'understated by more than 3': _,
            'RMSE stated within a factor of two': __,
            ...rest
          } = sumUp(group);
          return {
            projections: name,
            ...rest,
            'largest true error': Math.max(...group.map(({ error }) => error.max)).toFixed(2),
            'said to be kept, is not': kept,
            'a statement does not hold': group.filter((one) => listFaults(one).length > 0).length,
          };
        }),
      ),
      'missed-projected': broken.length > 0 ? formatTable(broken.map(describeResult)) : 'None.',
    };
  });

/** @param {HardResult} result */
function describeResult(result) {
  const { kind, name, stats, error } = result;
  return {
    scene: `${kind}: ${name}`,
    'maximum stated': nameLargest(stats.error.max),
    true: error.max.toFixed(2),
    'RMSE stated': stats.error.rms.toFixed(2),
    'RMSE true': error.rms.toFixed(2),
    E: error.e.toFixed(2),
    'says it is kept': String(stats.keepsMaxError),
    faults: listFaults(result).join(', ') || 'none',
  };
}
