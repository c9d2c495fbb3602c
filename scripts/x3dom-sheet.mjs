// Compares scenes like X3DOM's own examples, drawn by X3DOM and by the element:
// npm run x3dom-sheet -- --x3dom FILE [--only TEXT] [--keep FOLDER].
// FILE is X3DOM's x3dom-full.js, as the package of npm has no volume nodes. It writes docs/images/x3dom-beside.webp, and prints the visible
// share of each picture. Without that file it says so and does not change the sheet.
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { parseArgs } from 'node:util';
import { chromium } from '@playwright/test';
import { decode, encode } from 'fast-png';
import { createServer } from 'vite';
import { paintTorso } from './demo-torso.mjs';
import { findBrowser, listLaunchArgs } from './find-browser.mjs';
import { projectRoot } from './shared-data.mjs';
import { exampleScenes } from './x3dom-scenes.mjs';

const { values: options } = parseArgs({
  options: { x3dom: { type: 'string' }, only: { type: 'string', default: '' }, keep: { type: 'string' } },
});
const sheetFile = 'docs/images/x3dom-beside.webp';
const folder = '/x3dom-sheet';
const [side, shown, pairsAcross] = [320, 150, 4];

/** The slices of a torso from back to front, as seen from the front. @param {(hu: number) => number} byteOf */
function tileTorso(byteOf) {
  const {
    dimensions: [nx, ny, nz],
    values,
  } = torso;
  const [across, down] = [torsoAtlas.across, torsoAtlas.down];
  const width = nx * across;
  const data = new Uint8Array(width * nz * down);
  for (let j = 0; j < ny; j++) {
    for (let k = 0; k < nz; k++) {
      const row = (Math.floor(j / across) * nz + nz - 1 - k) * width + (j % across) * nx;
      for (let i = 0; i < nx; i++) data[row + nx - 1 - i] = byteOf(values[i + nx * (j + ny * k)]);
    }
  }
  return encode({ width, height: nz * down, data, channels: 1, depth: 8 });
}

/** Maps a range of values to 0 to 255. @type {(low: number, high: number) => (hu: number) => number} */
const span = (low, high) => (hu) => Math.max(0, Math.min(255, Math.round((255 * (hu - low)) / (high - low))));

const torso = paintTorso();
const torsoAtlas = { slices: torso.dimensions[1], across: 8, down: Math.ceil(torso.dimensions[1] / 8) };
const brain = { url: '/demos/data/mni152-t1.png', slices: 189, across: 16, down: 12 };

/** 0 in the left half of each tile of the brain, 1 in the right. */
function tileHalves() {
  const { width, height } = decode(readFileSync(join(projectRoot, brain.url)));
  const tile = width / brain.across;
  return encode({
    width,
    height,
    data: Uint8Array.from({ length: width * height }, (_, i) => Number((i % width) % tile >= tile / 2)),
    channels: 1,
    depth: 8,
  });
}

/** Skin translucent, vessels and organs red, bones white: a byte, then red, green, blue and opacity. */
const stops = [
  [0, 230, 150, 110, 0],
  [70, 230, 150, 110, 0],
  [85, 235, 160, 130, 40],
  [110, 200, 60, 50, 70],
  [150, 240, 210, 160, 150],
  [255, 255, 250, 240, 255],
];

function paintColors() {
  const data = new Uint8Array(256 * 4);
  for (let i = 0; i < 256; i++) {
    const next = Math.max(
      1,
      stops.findIndex(([byte]) => byte >= i),
    );
    const [[from, ...low], [to, ...high]] = [stops[next - 1], stops[next]];
    low.forEach((x, c) => (data[4 * i + c] = x + ((high[c] - x) * (i - from)) / (to - from)));
  }
  return encode({ width: 256, height: 1, data, channels: 4, depth: 8 });
}

const files = /** @type {Record<string, () => Uint8Array | Buffer>} */ ({
  'body.png': () => tileTorso(span(-300, 760)),
  'inside.png': () => tileTorso(span(80, 480)),
  'halves.png': tileHalves,
  'colors.png': paintColors,
  'x3dom-full.js': () => readFileSync(options.x3dom ?? ''),
});
const data = {
  brain,
  body: { ...torsoAtlas, url: `${folder}/body.png` },
  inside: { ...torsoAtlas, url: `${folder}/inside.png` },
  halves: { ...brain, url: `${folder}/halves.png` },
  colors: `${folder}/colors.png`,
};

/** @type {import('vite').Plugin} */
const serveFiles = {
  name: 'x3dom-sheet',
  configureServer({ middlewares }) {
    const made = new Map();
    middlewares.use(folder, (request, response, next) => {
      const name = (request.url ?? '').slice(1);
      if (!files[name]) return next();
      if (!made.has(name)) made.set(name, files[name]());
      response.setHeader('content-type', name.endsWith('.js') ? 'text/javascript' : 'image/png').end(made.get(name));
    });
  },
};

const style = `<style>body { margin: 0 } x3d, volume-view { display: block; width: ${side}px; height: ${side}px; border: 0 !important } volume-view::part(error) { display: none }</style>`;

/** X3DOM checks the size of a texture once per second. */
const timeOfX3dom = 3500;

/** @param {import('@playwright/test').Page} page @param {string} html */
async function drawByX3dom(page, html) {
  await page.setContent(
    `<!doctype html><title>X3DOM</title>${style}<script src="${folder}/x3dom-full.js"></script><x3d width="${side}px" height="${side}px" showStat="false" showLog="false">${html}</x3d>`,
  );
  await page.waitForTimeout(timeOfX3dom);
}

/** @param {import('@playwright/test').Page} page @param {string} html */
async function drawByElement(page, html) {
  await page.setContent(
    `<!doctype html><title>volume-view</title>${style}<volume-view alt="An example"><x3d>${html}</x3d></volume-view><script type="module" src="/src/index.ts"></script>`,
  );
  await page.evaluate(() =>
    customElements
      .whenDefined('volume-view')
      .then(() => /** @type {any} */ (document.querySelector('volume-view')).whenRendered().catch(() => {})),
  );
}

/** The part of a picture that is not background: per cent, and the mean of its strongest tenth. @param {Uint8Array} png */
function measure(png) {
  const { data: pixels, channels, width, height } = decode(png);
  const differences = Array.from({ length: width * height }, (_, i) =>
    Math.max(...[0, 1, 2].map((c) => Math.abs(pixels[channels * i + c] - pixels[c]))),
  ).filter((x) => x > 3);
  differences.sort((a, b) => b - a);
  const max = differences.slice(0, Math.ceil(differences.length / 10));
  return `${((100 * differences.length) / (width * height)).toFixed(0)} | ${max.length > 0 ? (max.reduce((sum, x) => sum + x, 0) / max.length).toFixed(0) : 0}`;
}

/**
 * Runs in a page: paints pairs of pictures with their titles.
 * @param {{ pairs: readonly { title: string, pictures: readonly string[] }[], across: number, size: number }} sheet
 */
async function paintSheet({ pairs, across, size }) {
  const [caption, gap] = [20, 14];
  const canvas = Object.assign(document.createElement('canvas'), {
    width: across * (2 * size + gap) - gap,
    height: Math.ceil(pairs.length / across) * (size + caption + 6),
  });
  const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d'));
  context.fillStyle = '#fff';
  context.fillRect(0, 0, canvas.width, canvas.height);
  context.font = '13px system-ui, sans-serif';
  for (const [i, { title, pictures }] of pairs.entries()) {
    const [x, y] = [(i % across) * (2 * size + gap), Math.floor(i / across) * (size + caption + 6)];
    for (const [k, picture] of pictures.entries()) {
      const image = new Image();
      image.src = `data:image/png;base64,${picture}`;
      await image.decode();
      context.drawImage(image, x + k * size, y, size, size);
      context.strokeStyle = '#ccc';
      context.strokeRect(x + k * size + 0.5, y + 0.5, size - 1, size - 1);
    }
    context.fillStyle = '#222';
    context.fillText(`${i + 1}  ${title}`, x + 2, y + size + 15);
  }
  return canvas.toDataURL('image/webp', 0.8);
}

async function main() {
  if (!options.x3dom || !existsSync(options.x3dom)) {
    console.log(
      `no scene was drawn: there is no ${options.x3dom ?? 'x3dom-full.js'}; name X3DOM's file with volume nodes, --x3dom FILE`,
    );
    return;
  }
  const server = await createServer({
    root: projectRoot,
    logLevel: 'error',
    plugins: [serveFiles],
    server: { port: 0, open: false, hmr: false, watch: null },
  });
  await server.listen();
  const browser = await chromium.launch({ executablePath: await findBrowser(), args: listLaunchArgs() });
  try {
    const pairs = [];
    console.log(
      '| scene | X3DOM: seen % | strongest | volume-view: seen % | strongest |\n| --- | --- | --- | --- | --- |',
    );
    for (const [i, { title, html }] of exampleScenes.entries()) {
      if (!title.includes(options.only)) continue;
      const pictures = [];
      for (const draw of [drawByX3dom, drawByElement]) {
        const page = await browser.newPage({ viewport: { width: side, height: side } });
        await page.goto(`${server.resolvedUrls?.local[0]}demos/index.html`);
        await draw(page, html(data));
        pictures.push(await page.screenshot());
        await page.close();
      }
      console.log(`| ${i + 1} ${title} | ${pictures.map(measure).join(' | ')} |`);
      pairs.push({ title, pictures: pictures.map((png) => png.toString('base64')) });
    }
    const page = await browser.newPage();
    const url = await page.evaluate(paintSheet, { pairs, across: pairsAcross, size: shown });
    const sheet = Buffer.from(url.slice(url.indexOf(',') + 1), 'base64');
    if (options.keep) {
      mkdirSync(options.keep, { recursive: true });
      pairs.forEach(({ title, pictures }) =>
        pictures.forEach((picture, k) =>
          writeFileSync(
            join(/** @type {string} */ (options.keep), `${title}-${'xo'[k]}.png`),
            Buffer.from(picture, 'base64'),
          ),
        ),
      );
    }
    if (options.only !== '') return;
    writeFileSync(join(projectRoot, sheetFile), sheet);
    console.log(`${sheetFile}: ${sheet.length} bytes`);
  } finally {
    await browser.close();
    await server.close();
  }
}

await main();
