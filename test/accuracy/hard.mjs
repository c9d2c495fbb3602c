// `npm run accuracy -- hard`: whether what is said of errors is true in scenes that were made to break it. SCENES=edge,comb takes those with these
// words in their names; ROWS=1 prints each.
import { formatTable } from '../bench/table.mjs';
import { chooseScenes } from './choose-scenes.mjs';
import { measureTables } from './measure-tables.mjs';
import { groupByKind, isKept, misleading, nameLargest, sumUp } from './sum-up-stated.mjs';

/** @typedef {import('./hard-page.ts').HardResult} HardResult */

/** Of a short run every so manieth scene is taken. */
const few = 5;

/** Less than this, 1/255, is what rounding to 8 bits makes of any picture: understating it misleads nobody. */
const reported = 0.5;

/** @param {{ quick: boolean }} options */
export const run = ({ quick }) =>
  measureTables({ quick }, async ({ page }) => {
    const from = '/test/accuracy/hard-page.ts';
    const all = await page.evaluate(async (name) => /** @type {string[]} */ ((await import(name)).listHard()), from);
    const wanted = chooseScenes(all, quick && few);
    /** @type {HardResult[]} */
    const results = [];
    for (const [i, name] of wanted.entries()) {
      results.push(
        await page.evaluate(
          async ({ module, scene, progress }) => {
            const { measureHard } = /** @type {typeof import('./hard-page.ts')} */ (await import(module));
            /** @type {any} */ (window).sayProgress(progress);
            return measureHard(scene);
          },
          { module: from, scene: name, progress: `scene ${i + 1} of ${wanted.length}: ${name}` },
        ),
      );
      if (process.env.ROWS === '1') console.log(Object.values(describeResult(results[i])).join(' | '));
    }
    const broken = results.filter((one) => listFaults(one).length > 0 || !isKept(one));
    return {
      'stated-hard': formatTable(
        groupByKind(results).map(([name, group]) => ({ scenes: name, ...describeGroup(group) })),
      ),
      'missed-hard': broken.length > 0 ? formatTable(broken.map(describeResult)) : 'None.',
    };
  });

/** @param {HardResult[]} group */
function describeGroup(group) {
  const { 'said to be kept, is not': kept, 'understated by more than 3': _, ...rest } = sumUp(group);
  return {
    ...rest,
    'said to be kept, is not': kept,
    'a statement does not hold': group.filter((one) => listFaults(one).length > 0).length,
  };
}

/** What is said of a scene and does not hold. @param {HardResult} result */
export function listFaults(result) {
  const {
    error,
    stats: { error: stated, keepsMaxError },
  } = result;
  const faults = [];
  if (![stated.rms, stated.p99, stated.max ?? 0, stated.probed].every(Number.isFinite)) faults.push('is no number');
  if (keepsMaxError && !isKept(result)) faults.push('said to be kept, is not');
  if (stated.max !== null && error.max > stated.max + 0.5) faults.push('maximum exceeded');
  if (error.rms > reported && stated.rms < error.rms / misleading) faults.push('RMSE understated');
  if (keepsMaxError && stated.rms > result.maxError) faults.push('contradicts itself');
  if (result.isOutOfSight && stated.max !== 0) faults.push('counts what is out of sight');
  if (!result.isOutOfSight && stated.max !== null && stated.max < reported) faults.push('zero is believed');
  return faults;
}

/** @param {HardResult} result */
function describeResult(result) {
  const { kind, name, stats, error, level } = result;
  return {
    scene: `${kind}: ${name}`,
    'pixels covered': error.covered,
    'samples a voxel × substeps': `${level.samplesAVoxel.toFixed(0)} × ${level.substeps}`,
    E: error.e.toFixed(2),
    'says that it is kept': stats.keepsMaxError ? 'yes' : 'no',
    'RMSE stated': stats.error.rms.toFixed(2),
    true: error.rms.toFixed(2),
    'maximum stated': nameLargest(stats.error.max),
    'maximum true': error.max.toFixed(1),
    'does not hold': listFaults(result).join(', '),
  };
}
