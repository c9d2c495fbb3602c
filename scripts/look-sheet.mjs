// Shows the effect of each word of `look` on real and synthetic data, next to the picture of the tag without it:
// node scripts/look-sheet.mjs [--size 240x200] [--only TEXT] [--keep FOLDER].
// It writes docs/images/looks.webp from the files whose licence allows it; with --keep it writes all pictures to a folder. Without
// ../shared/data it uses only the files of the demos, and says so.
import { existsSync, mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { parseArgs } from 'node:util';
import { chromium } from '@playwright/test';
import { createServer } from 'vite';
import { findBrowser, listLaunchArgs } from './find-browser.mjs';
import { paintSheet } from './paint-sheet.mjs';
import { projectRoot, sharedDataFolder } from './shared-data.mjs';

const { values: options } = parseArgs({
  options: {
    size: { type: 'string', default: '240x200' },
    only: { type: 'string', default: '' },
    keep: { type: 'string' },
  },
});
const [width, height] = options.size.split('x').map(Number);
const sheetFile = 'docs/images/looks.webp';

/** Words in the order of the columns; an empty word is the tag without `look`. */
const scans = ['flat', 'textbook', 'skin', 'xray', 'mip'];
const ct = ['flat', 'bone', 'skin', 'xray', 'mip'];
const others = ['', 'textbook', 'flat', 'mip'];

/** @type {readonly { src: string, name: string, words: readonly string[], attributes?: string, isPrivate?: true }[]} - `isPrivate`: pictures stay out of the docs */
const subjects = [
  { src: '/shared-data/medical/ch2_mricron/ch2.nii.gz', name: 'MRI, head', words: scans },
  {
    src: '/shared-data/medical/mni152_nilearn/mni_icbm152_t1_tal_nlin_sym_09a_converted.nii.gz',
    name: 'MRI, brain',
    words: scans,
  },
  { src: '/demos/data/ct-phantom.nii.gz', name: 'CT, synthetic', words: ct },
  {
    src: '/shared-data/medical/cranium_ct/cranium_ct.nii.gz',
    name: 'CT, head',
    words: [...ct, 'vessels'],
    isPrivate: true,
  },
  { src: '/demos/data/motor-synthetic.nii.gz', name: 'Statistics', words: others },
  { src: '/demos/data/storm-radar-1510.json', name: 'Radar, synthetic', words: others, attributes: 'rings="none"' },
];

async function main() {
  const drawn = subjects.filter(
    ({ src, name, isPrivate }) =>
      name.includes(options.only) &&
      (options.keep || !isPrivate) &&
      (!src.startsWith('/shared-data/') || existsSync(sharedDataFolder)),
  );
  if (drawn.length < subjects.filter(({ isPrivate }) => !isPrivate).length) console.log('some volumes are left out');
  const server = await createServer({
    root: projectRoot,
    logLevel: 'error',
    server: { port: 0, open: false, hmr: false, watch: null },
  });
  await server.listen();
  const browser = await chromium.launch({ executablePath: await findBrowser(), args: listLaunchArgs() });
  try {
    const page = await browser.newPage({ viewport: { width: Math.max(400, width), height: Math.max(300, height) } });
    await page.goto(`${server.resolvedUrls?.local[0]}demos/index.html`);
    await page.setContent(
      '<!doctype html><title>Looks</title><style>body { margin: 0 }</style><script type="module" src="/src/index.ts"></script>',
    );
    await page.evaluate(() => customElements.whenDefined('volume-view').then(() => undefined));
    for (const { src, name, words, attributes = '' } of drawn) {
      const cells = [];
      for (const word of words) {
        const tag = `<volume-view src="${src}" ${word && `look="${word}"`} ${attributes} style="width: ${width}px; height: ${height}px"></volume-view>`;
        await page.evaluate((html) => {
          document.body.innerHTML = html;
        }, tag);
        await page.evaluate(() =>
          /** @type {any} */ (document.querySelector('volume-view')).whenRendered().catch(() => {}),
        );
        const picture = await page.locator('volume-view').screenshot();
        cells.push({ picture: picture.toString('base64'), name: `${name}: ${word || 'no look'}` });
        console.log(`${name}: ${word || 'no look'}`);
      }
      rows.push(...cells);
      while (rows.length % columns > 0) rows.push({ picture: '', name: '' });
      if (options.keep) await write(page, join(options.keep, `${name.replace(/\W+/g, '-')}.webp`), cells);
    }
    if (!options.keep && options.only === '') await write(page, join(projectRoot, sheetFile), rows);
  } finally {
    await browser.close();
    await server.close();
  }
}

const columns = 5;
/** @type {{ picture: string, name: string }[]} */
const rows = [];

/** @param {import('@playwright/test').Page} page @param {string} file @param {readonly { picture: string, name: string }[]} cells */
async function write(page, file, cells) {
  const url = await page.evaluate(paintSheet, {
    cells,
    columns,
    cell: /** @type {[number, number]} */ ([width, height]),
  });
  mkdirSync(join(file, '..'), { recursive: true });
  writeFileSync(file, Buffer.from(url.slice(url.indexOf(',') + 1), 'base64'));
}

await main();
