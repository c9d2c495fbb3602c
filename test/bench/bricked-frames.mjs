// `npm run bench -- bricked-frames`: what a frame of bricks takes, all of them of the finest level, against one of the same volume as a whole: in turns, with
// the same steps. SCENES=mri,ct names some of the scenes, WITH=plain,lit some of the looks.
import { readSizes, repeats } from './knobs.mjs';
import { measureTurns } from './turns.mjs';

const steps = 200;

export const run = () =>
  measureTurns(
    { sizes: readSizes([256]), what: `${steps} steps, all pixels have rays, medians of ${repeats} turns` },
    async (page, size) => {
      const rows = await page.evaluate(
        async ({ module, asked }) => {
          const { compareBricked } = /** @type {typeof import('./bricked-frames-page.ts')} */ (await import(module));
          return compareBricked(asked);
        },
        {
          module: '/test/bench/bricked-frames-page.ts',
          asked: {
            size,
            steps,
            turns: repeats,
            scenes: process.env.SCENES?.split(',') ?? [],
            looks: process.env.WITH?.split(',') ?? [],
          },
        },
      );
      return rows.map(({ scene, look, way, whole, bricks, ratio, clock, difference }) => ({
        scene,
        look,
        bricks: way,
        'whole, processor, ms': whole.toFixed(0),
        'in bricks, processor, ms': bricks.toFixed(0),
        ratio: ratio.toFixed(2),
        'by the clock': clock.toFixed(2),
        difference: difference.toFixed(2),
      }));
    },
  );
