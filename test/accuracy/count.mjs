// `npm run accuracy -- count`: how many pixels of a picture at rest need a ray, by the pixels of a voxel and `max-error`, and what is lost where the
// others are interpolated; then, how many of the samples on its rays are needed. SCENES=mri,tips takes the scenes with these words in their names; SIZES=2,7
// other pixels of a voxel than 8, ERRORS=1,8 other values of `max-error` than 1.
import { formatTable } from '../bench/table.mjs';
import { chooseScenes } from './choose-scenes.mjs';
import { measureTables } from './measure-tables.mjs';

const numbersOf = (/** @type {string} */ list) => list.split(',').map(Number);

/** Pixels of a voxel, and `max-error`. */
const { SIZES = '8', ERRORS = '1' } = process.env;

/** Values of `max-error` for which samples are counted. */
const errorsOfSamples = [16, 8, 4, 2, 1, 0.5];

/** Of a short run every so manieth scene is taken. */
const few = 4;

/** A thing is lost where less of it is kept. */
const lost = 0.25;

/** @param {{ quick: boolean }} options */
export const run = ({ quick }) =>
  measureTables({ quick }, async ({ page }) => {
    const from = '/test/accuracy/count-page.ts';
    const all = await page.evaluate(async (name) => /** @type {string[]} */ ((await import(name)).listCounted()), from);
    const rows = [];
    const taken = [];
    for (const name of chooseScenes(all, quick && few)) {
      const results = await page.evaluate(
        async ({ module, scene, sizes, errors }) => {
          const { countRays } = /** @type {typeof import('./count-page.ts')} */ (await import(module));
          /** @type {any} */ (window).sayProgress(scene);
          return countRays(scene, sizes, errors);
        },
        { module: from, scene: name, sizes: numbersOf(SIZES), errors: numbersOf(ERRORS) },
      );
      rows.push(...results.map(describe));
      const samples = await page.evaluate(
        async ({ module, scene, errors }) => {
          const { countTaken } = /** @type {typeof import('./count-page.ts')} */ (await import(module));
          return countTaken(scene, errors);
        },
        { module: from, scene: name, errors: errorsOfSamples },
      );
      taken.push(...samples.map(describeSamples));
      if (process.env.ROWS === '1')
        for (const row of rows.slice(-results.length)) console.log(Object.values(row).join(' | '));
    }
    return { 'counted-rays': formatTable(rows), 'counted-samples': formatTable(taken) };
  });

/** @param {import('./count-samples.ts').SamplesResult} result */
function describeSamples({
  name,
  maxError,
  byLargeCells,
  byLargeCellsAndLight,
  bySmallCells,
  bySmallCellsAndLight,
  needed,
}) {
  const percent = (/** @type {number} */ share) => `${(100 * share).toFixed(0)} %`;
  return {
    scene: name,
    'max-error': maxError,
    'by cells of 8': percent(byLargeCells),
    'of 8 and light': percent(byLargeCellsAndLight),
    'by cells of 4': percent(bySmallCells),
    'of 4 and light': percent(bySmallCellsAndLight),
    needed: needed === null ? 'more' : percent(needed),
  };
}

/** @param {import('./count-page.ts').CountResult} result */
function describe({ name, pixelsPerVoxel, maxError, share, e, max, things }) {
  return {
    scene: name,
    'pixels a voxel': pixelsPerVoxel,
    'max-error': maxError,
    rays: `${(100 * share).toFixed(0)} %`,
    E: e.toFixed(2),
    'largest error': max.toFixed(0),
    'things lost': things.length > 0 ? `${things.filter(({ kept }) => kept < lost).length} of ${things.length}` : '',
  };
}
