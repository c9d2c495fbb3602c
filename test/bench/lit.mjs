// `npm run bench -- lit`: what light, surfaces alone, a second field and labels cost: frames of the same size and steps, in turns with plain ones.
// SCENES=mri,mri-surface,ct,ct-skin,radar names some of the scenes, WITH=lit,layer some of what is in them; OVER=lit
// compares with lit frames instead of plain ones.
import { readSizes, repeats } from './knobs.mjs';
import { measureTurns } from './turns.mjs';

const steps = 200;

export const run = () =>
  measureTurns(
    { sizes: readSizes([256]), what: `${steps} steps, all pixels have rays, medians of ${repeats} turns` },
    async (page, size) => {
      const rows = await page.evaluate(
        async ({ module, asked }) => {
          const { compareLit } = /** @type {typeof import('./lit-page.ts')} */ (await import(module));
          return compareLit(asked);
        },
        {
          module: '/test/bench/lit-page.ts',
          asked: {
            size,
            steps,
            turns: repeats,
            scenes: process.env.SCENES?.split(',') ?? [],
            variants: process.env.WITH?.split(',') ?? [],
            overLit: process.env.OVER === 'lit',
          },
        },
      );
      return rows.map(({ scene, variant, plain, shown, ratio, clock }) => ({
        scene,
        with: variant,
        'plain, processor, ms': plain.toFixed(0),
        'so, processor, ms': shown.toFixed(0),
        ratio: ratio.toFixed(2),
        'by the clock': clock.toFixed(2),
      }));
    },
  );
