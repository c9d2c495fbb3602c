// `npm run bench -- choices`: whether what was tuned on one renderer is right on others: the same frames in the engines that this
// machine has. `ENGINES=Firefox` runs one of them; `STEPS=64` takes so many, as in motion.
import { setTimeout as sleep } from 'node:timers/promises';
import { engine as chromium } from '../engines/chromium.mjs';
import { engine as firefox } from '../engines/firefox.mjs';
import { engine as webkit } from '../engines/webkit.mjs';
import { measureSource } from '../helpers/measure-in-browser.mjs';
import { readSizes, repeats } from './knobs.mjs';
import { printTable } from './table.mjs';

/** What an engine may take for all scenes. */
const limitMs = 9 * 60_000;

export async function run() {
  const [size] = readSizes([384]);
  const steps = Number(process.env.STEPS ?? 0);
  const asked = process.env.ENGINES?.split(',');
  await measureSource(async ({ url }) => {
    for (const engine of [chromium, firefox, webkit]) {
      if (asked && !asked.includes(engine.name)) continue;
      const path = await engine.find();
      if (!path) {
        console.log(`left out: ${engine.name} is not installed`);
        continue;
      }
      const page = await engine.open(
        `${url}test/bench/choices.html?size=${size}&turns=${repeats}&steps=${steps}`,
        path,
      );
      try {
        const { rows, error } = await waitForRows(page);
        if (error) console.log(`${engine.name}: ${error}`);
        else
          printTable(
            `${engine.name}, ${page.version}, ${size} x ${size} pixels, ${steps || 'one'} ${steps ? 'steps' : 'step a voxel'}, medians of ${repeats} turns: time over that of the plain frame beside it`,
            rows.map(({ scene, ms, ratios, share, spared }) => ({
              scene,
              'plain frame, ms': ms.toFixed(0),
              ...Object.fromEntries(Object.entries(ratios).map(([what, ratio]) => [what, ratio.toFixed(2)])),
              'share of adaptive rays': share.toFixed(2),
              'rays spared: share, cost': spared
                .map(({ share, cost }) => `${share.toFixed(2)}, ${cost?.toFixed(2) ?? '-'}`)
                .join('; '),
            })),
          );
      } finally {
        await page.close();
      }
    }
  });
}

/**
 * @param {import('../engines/run.mjs').OpenPage} page
 * @returns {Promise<{ rows: import('./choices-page.ts').ChoicesRow[], error?: string }>}
 */
async function waitForRows(page) {
  for (const end = Date.now() + limitMs; Date.now() < end; await sleep(500)) {
    const found = JSON.parse(await page.evaluate('JSON.stringify(window.choices ?? {})'));
    if (found.done) return found;
  }
  return { rows: [], error: `took longer than ${limitMs / 60_000} minutes` };
}
