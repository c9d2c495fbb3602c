// `npm run accuracy -- small`: what is left of small things in the element's pictures at rest, whether what it says of their
// errors is true, and whether a view has one final picture. SCENES=plate,wires takes the scenes with these words in their
// names; ANGLES=5 so many angles of each; MAX_ERROR=4 another `max-error`, where things count that stand out by 8 times as much.
import { formatTable } from '../bench/table.mjs';
import { measureTables } from './measure-tables.mjs';
import { sumUpErrors, sumUpLevels, sumUpThings } from './sum-up-small.mjs';

/** Angles, a degree apart. */
const usualAngles = { full: 20, quick: 2 };

/** Angles of a real volume, whose pictures take longest. */
const realAngles = 5;

/** @param {{ quick: boolean }} options */
export const run = ({ quick }) =>
  measureTables({ quick }, async ({ page, machine }) => {
    const angles = Number(process.env.ANGLES ?? (quick ? usualAngles.quick : usualAngles.full));
    const words = process.env.SCENES?.toLowerCase().split(',') ?? [''];
    const module = '/test/accuracy/small-page.ts';
    const scenes = await page.evaluate(async (name) => (await import(name)).listScenes(), module);
    /** @type {import('./small-page.ts').SmallResult[]} */
    const results = [];
    for (const { name, hasThings } of scenes) {
      if (!words.some((word) => name.toLowerCase().includes(word))) continue;
      results.push(
        await page.evaluate(
          async ({ from, scene, count, maxError }) => {
            const { measureScene } = /** @type {typeof import('./small-page.ts')} */ (await import(from));
            return measureScene(scene, {
              angles: count,
              maxError,
              notify: (what) => /** @type {any} */ (window).sayProgress(what),
            });
          },
          {
            from: module,
            scene: name,
            count: hasThings ? angles : Math.min(angles, realAngles),
            maxError: Number(process.env.MAX_ERROR ?? 1),
          },
        ),
      );
    }
    const finals = await page.evaluate(
      async ({ from, count }) => {
        const { compareFinals } = /** @type {typeof import('./final-page.ts')} */ (await import(from));
        return compareFinals(count, (what) => /** @type {any} */ (window).sayProgress(what));
      },
      { from: '/test/accuracy/final-page.ts', count: quick ? 1 : 4 },
    );
    return {
      'small-where': `${angles} angles of each scene, real volumes ${Math.min(angles, realAngles)}; ${machine.browser}, ${machine.renderer}.`,
      'small-things': formatTable(results.filter(({ minContrast }) => minContrast > 0).map(sumUpThings)),
      'stated-errors': formatTable(results.map(sumUpErrors)),
      'small-levels': formatTable(results.map(sumUpLevels)),
      'one-picture': formatTable(finals),
    };
  });
