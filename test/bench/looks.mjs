// `npm run bench -- looks`: no numbers, but a sheet of real volumes to look at: ours unlit, lit and as surfaces beside other renderers
// with their light, from the same side, with the same transfer function. It is written to the folder PICTURES, by default
// test-results/looks; SCENES=skull,brain draws some. demo-brain, demo-head and demo-torso are in docs/images/lit-beside*.webp; the
// others are not for the docs: the licences of most of these data do not allow that.
import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { measureSource } from '../helpers/measure-in-browser.mjs';
import { preparePeers } from './peers/build.mjs';

const folder = process.env.PICTURES ?? 'test-results/looks';

export async function run() {
  const peers = (await preparePeers()) ? ['vtk', 'niivue'] : [];
  const size = Number(process.env.SIZES ?? 384);
  mkdirSync(folder, { recursive: true });
  await measureSource(async ({ openPage }) => {
    const page = await openPage('test/accuracy/page.html');
    const sheets = await page.evaluate(
      async ({ module, asked }) => {
        const { drawLooks } = /** @type {typeof import('./looks-page.ts')} */ (await import(module));
        return drawLooks(asked, (what) => /** @type {any} */ (window).sayProgress(what));
      },
      {
        module: '/test/bench/looks-page.ts',
        asked: {
          size,
          scenes: process.env.SCENES?.split(',') ?? [],
          modules: Object.fromEntries(peers.map((name) => [name, `/test/bench/peers/dist/${name}.js`])),
        },
      },
    );
    for (const { name, sheet } of sheets) {
      const file = join(folder, `${name}.png`);
      writeFileSync(file, Buffer.from(sheet.split(',')[1], 'base64'));
      console.log(file);
    }
  });
}
