// `npm run bench -- shapes`: what shapes and lines among a volume, and labels of it, cost in motion: frames of the same size, steps and limit of
// curvature with them and without, in turns.
import { readSizes, repeats } from './knobs.mjs';
import { measureTurns } from './turns.mjs';

const [steps, maxCurvature] = [64, 24];

/** Frames of each kind: the machine may do other things meanwhile. */
const turns = 2 * repeats;

export const run = () =>
  measureTurns(
    {
      sizes: readSizes([512]),
      what: `${steps} steps, curvature of at most ${maxCurvature}/255 between rays, medians of ${turns} turns with 4 frames of each`,
    },
    async (page, size) => {
      const rows = await page.evaluate(
        async ({ module, asked }) => {
          const { compareShapes } = /** @type {typeof import('./shapes-page.ts')} */ (await import(module));
          return compareShapes(asked);
        },
        { module: '/test/bench/shapes-page.ts', asked: { size, steps, maxCurvature, turns } },
      );
      return rows.map(({ scene, shapes, ms, ratio, work, workRatio, allRays, share }) => ({
        scene,
        shapes,
        ms: ms.toFixed(0),
        'over none': ratio.toFixed(2),
        'processor, ms': work.toFixed(0),
        'over none ': workRatio.toFixed(3),
        'with all rays': allRays.toFixed(0),
        'quads with rays for shapes': `${(100 * share).toFixed(1)} %`,
      }));
    },
  );
