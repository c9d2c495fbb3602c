// Draws scenes with the source's own parts, served by vite, in WebGL 2 and 1.
import { measureSource } from '../helpers/measure-in-browser.mjs';
import { withoutWebGl2 } from './draw-elements.mjs';

const module = '/test/recorded/inner-page.ts';

/** @param {string} name @param {boolean} webgl2 */
const nameOf = (name, webgl2) => `scene: ${name}${webgl2 ? '' : ', WebGL 1'}`;

/**
 * In the page.
 * @param {{ module: string, name: string, webgl2: boolean }} what
 * @returns {Promise<import('./inner-page.ts').DrawnInside>}
 */
async function drawInPage({ module: path, name, webgl2 }) {
  return (await import(path)).drawInside(name, webgl2);
}

/**
 * @param {import('@playwright/test').Page} page
 * @param {string} name
 * @param {boolean} webgl2
 * @returns {Promise<import('./picture.mjs').Picture>}
 */
async function drawScene(page, name, webgl2) {
  const { family, width, height, kind, data: url } = await page.evaluate(drawInPage, { module, name, webgl2 });
  const data = Uint8Array.from(Buffer.from(url.split(',')[1], 'base64'));
  return { name: nameOf(name, webgl2), family: `scene: ${family}`, width, height, kind, data };
}

/**
 * @param {(name: string) => boolean} wanted
 * @param {(picture: import('./picture.mjs').Picture | { name: string, failure: string }) => void} drawn
 * @returns {Promise<import('../helpers/measure-in-browser.mjs').Machine>}
 */
export function drawInner(wanted, drawn) {
  return measureSource(async ({ machine, openPage }) => {
    for (const webgl2 of [true, false]) {
      const page = await openPage('test/recorded/page.html', webgl2 ? {} : { before: withoutWebGl2 });
      /** @type {string[]} */
      const names = await page.evaluate(async (path) => (await import(path)).listNames(), module);
      for (const name of names.filter((one) => wanted(nameOf(one, webgl2)))) {
        drawn(
          await drawScene(page, name, webgl2).catch((error) => ({
            name: nameOf(name, webgl2),
            failure: String(error),
          })),
        );
      }
      await page.close();
    }
    return machine;
  });
}
