// Shows the picture of a tag without options for every real file in ../shared/data, and the share of the picture that is filled:
// npm run contact-sheet [-- --size 320x240] [--only TEXT] [--keep FOLDER].
// It writes docs/images/contact-sheet.webp from the files whose licence allows it, and prints the shares. Without these data it says so and
// does not change the sheet.
import { existsSync, mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { parseArgs } from 'node:util';
import { chromium } from '@playwright/test';
import { createServer } from 'vite';
import { listSubjects } from './contact-sheet-files.mjs';
import { measureShare } from './measure-share.mjs';
import { paintSheet } from './paint-sheet.mjs';
import { findBrowser, listLaunchArgs } from './find-browser.mjs';
import { projectRoot, sharedDataFolder } from './shared-data.mjs';

const { values: options } = parseArgs({
  options: {
    size: { type: 'string', default: '320x240' },
    only: { type: 'string', default: '' },
    keep: { type: 'string' },
  },
});
const [width, height] = options.size.split('x').map(Number);
const sheetFile = 'docs/images/contact-sheet.webp';
const columns = 5;

/** @typedef {import('./contact-sheet-files.mjs').Subject} Subject */

/** @param {Subject} subject */
const tagOf = ({ src, attributes = '' }) =>
  `<volume-view src="/shared-data/${src}" ${attributes} style="width: ${width}px; height: ${height}px"></volume-view>`;

/** A page with one element, as a reader sees it. @param {import('@playwright/test').Page} page @param {Subject} subject */
async function photograph(page, subject) {
  await page.evaluate((tag) => {
    document.body.innerHTML = tag;
  }, tagOf(subject));
  await page.evaluate(() => /** @type {any} */ (document.querySelector('volume-view')).whenRendered().catch(() => {}));
  const picture = await page.locator('volume-view').screenshot();
  /** @type {{ alpha: string, error: string }} */
  const seen = await page.evaluate(async () => {
    const view = /** @type {any} */ (document.querySelector('volume-view'));
    try {
      view.setAttribute('rings', 'none'); // Rings may be outside the framed part.
      await view.whenRendered();
      const image = await createImageBitmap(await view.toBlob());
      const canvas = new OffscreenCanvas(image.width, image.height);
      const context = /** @type {OffscreenCanvasRenderingContext2D} */ (canvas.getContext('2d'));
      context.drawImage(image, 0, 0);
      const { data } = context.getImageData(0, 0, image.width, image.height);
      let alpha = '';
      for (let i = 3; i < data.length; i += 4) alpha += String.fromCharCode(data[i]);
      return { alpha: btoa(alpha), error: '' };
    } catch (error) {
      return { alpha: '', error: String(error) };
    }
  });
  return { ...seen, picture: picture.toString('base64') };
}

/** @param {string} url - data: */
const bytesOf = (url) => Buffer.from(url.slice(url.indexOf(',') + 1), 'base64');

async function main() {
  const subjects = listSubjects(sharedDataFolder).filter(({ src }) => src.includes(options.only));
  if (subjects.length === 0) {
    console.log(
      `no file was drawn: ${existsSync(sharedDataFolder) ? `nothing in ${sharedDataFolder} matches` : `there is no ${sharedDataFolder}; set VOLUME_VIEW_DATA to the folder with the real data`}`,
    );
    return;
  }
  const server = await createServer({
    root: projectRoot,
    logLevel: 'error',
    server: { port: 0, open: false, hmr: false, watch: null },
  });
  await server.listen();
  const browser = await chromium.launch({ executablePath: await findBrowser(), args: listLaunchArgs() });
  try {
    const page = await browser.newPage({ viewport: { width: Math.max(400, width), height: Math.max(300, height) } });
    page.on(
      'console',
      (line) => /^\[?volume-view|^volume-view/.test(line.text()) && console.log(`  console: ${line.text()}`),
    );
    await page.goto(`${server.resolvedUrls?.local[0]}demos/index.html`);
    await page.setContent(
      '<!doctype html><title>Contact sheet</title><style>body { margin: 0 }</style><script type="module" src="/src/index.ts"></script>',
    );
    await page.evaluate(() => customElements.whenDefined('volume-view').then(() => undefined));
    const drawn = [];
    console.log(`| file | width % | height % | share of the side it fits % |\n| --- | --- | --- | --- |`);
    for (const subject of subjects) {
      const { picture, alpha, error } = await photograph(page, subject);
      if (options.keep) {
        mkdirSync(options.keep, { recursive: true });
        writeFileSync(join(options.keep, `${subject.src.replaceAll('/', '__')}.png`), Buffer.from(picture, 'base64'));
      }
      const share = measureShare(Buffer.from(alpha, 'base64'), [width, height]);
      const percent = (/** @type {number} */ x) => String(Math.round(100 * x));
      console.log(
        `| ${subject.src} | ${error || (share ? `${percent(share.width)} | ${percent(share.height)} | ${percent(share.fits)}${share.isCut ? ', cut' : ''}` : 'nothing | is | seen')} |`,
      );
      drawn.push({ subject, picture });
    }
    const cells = drawn
      .filter(({ subject }) => subject.mayBeShown || options.keep)
      .map(({ subject, picture }) => ({ picture, name: subject.name }));
    const sheet = bytesOf(
      await page.evaluate(paintSheet, { cells, columns, cell: /** @type {[number, number]} */ ([width, height]) }),
    );
    if (options.keep) writeFileSync(join(options.keep, 'sheet.webp'), sheet);
    if (options.keep || options.only !== '') return;
    writeFileSync(join(projectRoot, sheetFile), sheet);
    console.log(`${sheetFile}: ${sheet.length} bytes`);
  } finally {
    await browser.close();
    await server.close();
  }
}

await main();
