// `npm run bench -- edges`: what smooth edges of surfaces cost at rest: pictures in turns with the same ones with one ray a pixel.
import { readSizes, repeats } from './knobs.mjs';
import { measureTurns } from './turns.mjs';

export const run = () =>
  measureTurns(
    { sizes: readSizes([512]), what: `steps of a voxel, medians of ${repeats} turns` },
    async (page, size) => {
      const rows = await page.evaluate(
        async ({ module, asked }) => {
          const { compareEdges } = /** @type {typeof import('./edges-page.ts')} */ (await import(module));
          return compareEdges(...asked);
        },
        {
          module: '/test/bench/edges-page.ts',
          asked: /** @type {[number, number, string[]]} */ ([size, repeats, process.env.SCENES?.split(',') ?? []]),
        },
      );
      return rows.map(({ scene, edges, ofSeen, plain, ratio, clock }) => ({
        scene,
        'pixels with edges': `${(100 * edges).toFixed(1)} %`,
        'of those seen': `${(100 * ofSeen).toFixed(0)} %`,
        'one ray, processor, ms': plain.toFixed(0),
        ratio: ratio.toFixed(2),
        'by the clock': clock.toFixed(2),
      }));
    },
  );
