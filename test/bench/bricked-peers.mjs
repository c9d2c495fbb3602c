// `npm run bench -- bricked-peers`: the stone of demos/large, as a pyramid on a server of this program, in bricks and in vole-core, which shows one level
// as a whole: time, what is read, memory of the GPU, and how far the finished pictures are off. vole-core is not the project's: see peers/README.md.
// VIEWS=whole leaves the other view out; SHIFT=3 has half as many voxels along each edge; PICTURES=folder writes the pictures.
import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { measurePackage, nameMachine } from '../helpers/measure-in-browser.mjs';
import { countGpuBytes } from './count-gpu-bytes.mjs';
import { buildVole } from './peers/build.mjs';
import { startStone } from './start-stone.mjs';
import { formatMegabytes, printTable } from './table.mjs';

/** Levels of the stone that are left out: with 2 the finest one has 1024 x 768 x 640 voxels. */
const shift = Number(process.env.SHIFT ?? 2);

/** The level that vole-core shows by default, of 256 x 192 x 160 voxels, and the next finer one, which it can be made to show. */
const coarse = 4;
const finer = { shift: coarse - 1, maxAtlasEdge: 8192 };

/** Edges of the box around the stone; the longest one is 1. */
const edges = [1, 0.75, 0.625];

const direction = { theta: 30, phi: 68 };

/** Radius of the camera's orbit. @type {Record<string, string>} */
const radii = { whole: '72%', near: '40%' };
const views = process.env.VIEWS?.split(',') ?? Object.keys(radii);

/** Longest time for one picture, s. */
const patience = 300;

/**
 * Colours from value to value. vole-core makes the opacity of a colour's luminance and interpolates colours, not values: so they are about proportional to the
 * values up to those of the stone, and the opacity is that of vole-core for both.
 * @type {[value: number, color: [red: number, green: number, blue: number]][]}
 */
const colors = [
  [0, [0, 0, 0]],
  [130, [0.588, 0.439, 0.282]],
  [200, [0.871, 0.753, 0.573]],
  [255, [1, 0.965, 0.886]],
];

/** Of vole-core: its opacity is so much of the luminance. */
const density = 0.4;

/** Rays beside the middle of the picture are shorter, which makes vole-core denser: with so much more extinction our pictures of a level are nearest to its. */
const denser = 1.3;

/**
 * @typedef {object} Shown
 * @property {number} first - ms until the first picture
 * @property {number} final - ms until the last one
 * @property {string} level - what is seen of the pyramid
 * @property {string} steps
 * @property {number} [stated] - the error that it states
 * @property {number} gpuBytes
 * @property {string} picture - PNG, base64
 * @property {{ chunks: number, bytes: number }} read
 */

/** @typedef {{ eye: number[], up: number[], degrees: number }} PlainCamera - where the volume's longest edge is 1 and its middle is the origin */

/** @param {number} value @returns {number[]} red, green, blue, 0 to 1 */
function colorAt(value) {
  const next = Math.max(
    1,
    Math.min(
      colors.length - 1,
      colors.findIndex(([stop]) => stop >= value),
    ),
  );
  const [[from, start], [to, end]] = [colors[next - 1], colors[next]];
  const share = Math.max(0, Math.min(1, (value - from) / (to - from)));
  return start.map((c, i) => c + share * (end[i] - c));
}

/**
 * The opacity of vole-core grows with the number of steps of a ray, 256 of them wherever it is as long as the box: its extinction is that of our opacity,
 * which holds for a hundredth of the longest edge, on the ray through the middle of the picture, times `denser`.
 */
function makeTransferFunction() {
  const [theta, phi] = [direction.theta, direction.phi].map((degrees) => (degrees * Math.PI) / 180);
  const ray = [Math.sin(phi) * Math.sin(theta), Math.sin(phi) * Math.cos(theta), Math.cos(phi)];
  const length = Math.min(...ray.map((d, i) => edges[i] / Math.abs(d)));
  return Array.from({ length: 86 }, (_, i) => {
    const color = colorAt(3 * i);
    const luminance = 0.2125 * color[0] + 0.7154 * color[1] + 0.0721 * color[2];
    const opacity = 1 - (1 - density * luminance) ** ((denser * 256) / 100 / length);
    const hex = color
      .map((c) =>
        Math.round(255 * c)
          .toString(16)
          .padStart(2, '0'),
      )
      .join('');
    return `${3 * i} #${hex} ${(100 * opacity).toFixed(3)}%`;
  }).join(', ');
}

/**
 * In the page.
 * @param {{ base: string, attributes: Record<string, string>, patience: number }} asked
 */
async function showOurs({ base, attributes, patience: seconds }) {
  await import(`${base}dist/volume-view.js`);
  document.body.style.cssText = 'margin: 0; background: black';
  const view = document.createElement('volume-view');
  for (const [name, value] of Object.entries({ alt: 'A stone', loading: 'eager', ...attributes }))
    view.setAttribute(name, value);
  view.style.cssText = 'display: block; width: 320px; height: 240px; background: black';
  const began = performance.now();
  let first = 0;
  view.addEventListener('render', () => (first ||= performance.now() - began));
  document.body.append(view);
  const late = new Promise((_, reject) => setTimeout(() => reject(new Error('no final picture')), 1000 * seconds));
  await Promise.race([view.whenRendered(), late]);
  const final = performance.now() - began;
  const { eye, target, up, fieldOfView } = /** @type {any} */ (view.camera);
  // The x and y of an OME-Zarr point the other way in our world; a reference length is a hundredth of the longest edge.
  const plain = (/** @type {number[]} */ [x, y, z]) => [-x, -y, z];
  const edge = 100 * /** @type {any} */ (view.optics).referenceLength;
  const camera = {
    eye: plain(eye.map((/** @type {number} */ x, /** @type {number} */ i) => (x - target[i]) / edge)),
    up: plain(up),
    degrees: (fieldOfView * 180) / Math.PI,
  };
  const { steps, bricks, error } = /** @type {any} */ (view.renderStats);
  const level = bricks ? `${bricks.count} bricks` : /** @type {any} */ (view.volume).dimensions.join(' × ');
  const { textures } = /** @type {any} */ (window).gpuBytes();
  return { first, final, camera, level, steps: String(steps), stated: error?.rms, gpuBytes: textures };
}

/**
 * In the page.
 * @param {{ base: string, url: string, camera: PlainCamera, colors: number[][], density: number, maxAtlasEdge?: number }} asked - colors: of the values 0 to 255
 */
async function showVole({ base, url, camera, colors: table, density: share, maxAtlasEdge }) {
  const { show } = await import(`${base}test/bench/peers/dist/vole.js`);
  document.body.style.cssText = 'margin: 0; background: black';
  const host = document.createElement('div');
  host.style.cssText = 'width: 320px; height: 240px; overflow: hidden';
  document.body.append(host);
  const began = performance.now();
  const mix = (/** @type {number} */ value) => {
    const low = Math.min(254, Math.floor(value));
    return table[low].map((c, i) => c + (value - low) * (table[low + 1][i] - c));
  };
  const { first, final, size, draws } = await show(host, { url, colorAt: mix, density: share, camera, maxAtlasEdge });
  const { textures } = /** @type {any} */ (window).gpuBytes();
  return {
    first: first - began,
    final: final - began,
    level: size.join(' × '),
    steps: `${draws} draws`,
    gpuBytes: textures,
  };
}

/**
 * In the page: root mean square of the differences of two pictures over the pixels that show something in one of them, 1/255.
 * @param {[string, string]} pictures
 */
async function comparePictures(pictures) {
  const [a, b] = await Promise.all(
    pictures.map(async (picture) => {
      const image = new Image();
      image.src = `data:image/png;base64,${picture}`;
      await image.decode();
      const canvas = new OffscreenCanvas(image.width, image.height);
      const context = /** @type {OffscreenCanvasRenderingContext2D} */ (canvas.getContext('2d'));
      context.drawImage(image, 0, 0);
      return context.getImageData(0, 0, image.width, image.height).data;
    }),
  );
  let sum = 0;
  let count = 0;
  for (let i = 0; i < a.length; i += 4) {
    if (Math.max(a[i], a[i + 1], a[i + 2], b[i], b[i + 1], b[i + 2]) === 0) continue;
    count += 3;
    for (let c = 0; c < 3; c++) sum += (a[i + c] - b[i + c]) ** 2;
  }
  return Math.sqrt(sum / count);
}

export async function run() {
  if (!(await buildVole())) return;
  const stone = await startStone();
  try {
    await measurePackage(async ({ url: base, openPage, machine }) => {
      const transferFunction = makeTransferFunction();
      const table = Array.from({ length: 256 }, (_, value) => colorAt(value));

      /**
       * Twice: the server has all chunks the second time, which counts.
       * @template T
       * @param {(asked: T) => Promise<Omit<Shown, 'picture' | 'read'> & { camera?: PlainCamera }>} show @param {T} asked @param {number} [times]
       */
      const measure = async (show, asked, times = 2) => {
        for (let turn = 1; ; turn++) {
          const page = await openPage('test/bench/empty.html', { before: countGpuBytes });
          stone.counts.chunks = stone.counts.bytes = 0;
          const shown = await page.evaluate(/** @type {any} */ (show), asked);
          const picture = await page.screenshot({ clip: { x: 0, y: 0, width: 320, height: 240 } });
          await page.close();
          console.error(JSON.stringify(shown), JSON.stringify(stone.counts));
          if (turn === times)
            return /** @type {Shown & { camera: PlainCamera }} */ ({
              ...shown,
              picture: picture.toString('base64'),
              read: { ...stone.counts },
            });
        }
      };

      for (const name of views) {
        const ours = (/** @type {number} */ leftOut, /** @type {Record<string, string>} */ more, times = 2) =>
          measure(
            showOurs,
            {
              base,
              patience,
              attributes: {
                src: `${stone.url}/${leftOut}/stone.ome.zarr/`,
                'transfer-function': transferFunction,
                'camera-orbit': `${direction.theta}deg ${direction.phi}deg ${radii[name]}`,
                ...more,
              },
            },
            times,
          );
        const bricks = await ours(shift, { 'max-error': '2', 'max-gpu-bytes': '64e6' });
        const vole = (/** @type {number | undefined} */ maxAtlasEdge) =>
          measure(showVole, {
            base,
            url: `${stone.url}/${shift}/stone.ome.zarr`,
            camera: bricks.camera,
            colors: table,
            density,
            maxAtlasEdge,
          });
        const whole = { 'max-error': '0.5', 'max-bytes': '100e6' };
        const shown = {
          'volume-view in bricks': bricks,
          'vole-core': await vole(undefined),
          'vole-core, made to show a finer level': await vole(finer.maxAtlasEdge),
          'volume-view, that level of vole-core': await ours(coarse, whole, 1),
          'volume-view, that finer level': await ours(finer.shift, whole, 1),
        };
        // It shows all of the finest level, if it is not larger than that.
        const truth = await ours(shift, { 'max-error': '0.5', 'max-gpu-bytes': '1000e6' }, 1);
        const page = await openPage('test/bench/empty.html');
        const compare = async (/** @type {Shown} */ a, /** @type {Shown} */ b) =>
          (await page.evaluate(comparePictures, /** @type {[string, string]} */ ([a.picture, b.picture]))).toFixed(2);
        const rows = [];
        for (const [what, one] of Object.entries(shown))
          rows.push({
            what,
            shows: one.level,
            'first picture, s': (one.first / 1000).toFixed(1),
            'finished, s': (one.final / 1000).toFixed(1),
            chunks: one.read.chunks,
            'read, MB': formatMegabytes(one.read.bytes),
            'textures, MB': formatMegabytes(one.gpuBytes),
            'from our exact picture': await compare(one, truth),
            'from vole-core, finer level': await compare(one, shown['vole-core, made to show a finer level']),
          });
        printTable(
          `A stone, ${name}, 320 x 240 pixels (${nameMachine(machine)}). In bricks: max-error 2, 64 MB on the GPU. Exact: ${truth.level} voxels, max-error 0.5, stated ${truth.stated?.toFixed(2)}. Errors: RMS over pixels that show something, 1/255`,
          rows,
        );
        printTable('How far two pictures are apart that show the same data, RMS, 1/255: the optics', [
          {
            'level in both': shown['vole-core'].level,
            error: await compare(shown['vole-core'], shown['volume-view, that level of vole-core']),
          },
          {
            'level in both': shown['vole-core, made to show a finer level'].level,
            error: await compare(
              shown['vole-core, made to show a finer level'],
              shown['volume-view, that finer level'],
            ),
          },
        ]);
        await page.close();
        if (process.env.PICTURES) writePictures({ ...shown, truth }, join(process.env.PICTURES, name));
      }
    });
  } finally {
    stone.close();
  }
}

/** @param {Record<string, Shown>} shown @param {string} start - of the files' paths */
function writePictures(shown, start) {
  mkdirSync(process.env.PICTURES ?? '', { recursive: true });
  for (const [what, { picture }] of Object.entries(shown))
    writeFileSync(`${start}-${what.replaceAll(/[^a-z]+/g, '-')}.png`, Buffer.from(picture, 'base64'));
}
