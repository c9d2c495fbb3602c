// `npm run accuracy -- moving`: what is left of small things while the camera turns, by how much of a picture at rest a frame has time for.
// SCENES=plate,wires takes the scenes with these words in their names; ANGLES=5 so many angles of each.
import { formatTable } from '../bench/table.mjs';
import { measureTables } from './measure-tables.mjs';
import { sumUpMotion } from './sum-up-small.mjs';

const usualAngles = { full: 10, quick: 3 };

/** @param {{ quick: boolean }} options */
export const run = ({ quick }) =>
  measureTables({ quick }, async ({ page, machine }) => {
    const angles = Number(process.env.ANGLES ?? (quick ? usualAngles.quick : usualAngles.full));
    const words = process.env.SCENES?.toLowerCase().split(',') ?? [''];
    const scenes = await page.evaluate(
      async (name) => (await import(name)).listScenes(),
      '/test/accuracy/small-page.ts',
    );
    /** @type {import('./moving-page.ts').MovingResult[]} */
    const results = [];
    for (const { name, hasThings } of scenes) {
      if (!hasThings || !words.some((word) => name.toLowerCase().includes(word))) continue;
      results.push(
        await page.evaluate(
          async ({ from, scene, count }) => {
            const { measureMotion } = /** @type {typeof import('./moving-page.ts')} */ (await import(from));
            return measureMotion(scene, count, (what) => /** @type {any} */ (window).sayProgress(what));
          },
          { from: '/test/accuracy/moving-page.ts', scene: name, count: angles },
        ),
      );
    }
    return {
      'moving-where': `${angles} angles of each scene; ${machine.browser}, ${machine.renderer}.`,
      'moving-things': formatTable(results.map(sumUpMotion)),
      'moving-all': formatTable(sumUpBudgets(results)),
    };
  });

/**
 * All scenes together, by budget.
 * @param {import('./moving-page.ts').MovingResult[]} results
 */
function sumUpBudgets(results) {
  return (results[0]?.budgets ?? []).map(({ share }, n) => {
    const all = results.map(({ minContrast, budgets }) => ({ minContrast, ...budgets[n] }));
    const sum = (/** @type {(one: import('./sum-up-small.mjs').ThingCounts) => number} */ of) =>
      all.reduce((total, { counts }) => total + of(counts), 0);
    const shown = sum((one) => one.shown);
    const pairs = sum((one) => one.pairs);
    const percent = (/** @type {number} */ part, /** @type {number} */ whole) =>
      `${((100 * part) / Math.max(1, whole)).toFixed(1)} %`;
    return {
      'time for, of a picture at rest': share === 1 ? 'all of it' : `1/${Math.round(1 / share)}`,
      shown,
      lost: percent(
        sum((one) => one.lost),
        shown,
      ),
      dimmed: percent(
        sum((one) => one.dimmed),
        shown,
      ),
      'too bright': percent(
        sum((one) => one.bright),
        shown,
      ),
      'blinks, of pairs': percent(
        sum((one) => one.blinks),
        pairs,
      ),
    };
  });
}
