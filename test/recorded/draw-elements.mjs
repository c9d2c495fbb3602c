// Draws scenes of `<volume-view>` elements with the built package, each in a page of its own.
import { measurePackage } from '../helpers/measure-in-browser.mjs';
import { cartesianScenes } from './element-scenes.mjs';
import { readPng } from './picture.mjs';
import { radarScenes } from './radar-scenes.mjs';

/** @typedef {import('./element-scenes.mjs').ElementScene} ElementScene */

/** All elements' scenes, by name. @type {readonly ElementScene[]} */
export const elementScenes = [...cartesianScenes, ...radarScenes];

const familyOf = (/** @type {string} */ name) => name.replace(', WebGL 1', '');

/** In the page, before all else: a browser without WebGL 2. */
export function withoutWebGl2() {
  const original = HTMLCanvasElement.prototype.getContext;
  // @ts-expect-error -- the overloads of getContext
  HTMLCanvasElement.prototype.getContext = function (/** @type {string} */ type, ...rest) {
    return type === 'webgl2' ? null : Reflect.apply(original, this, [type, ...rest]);
  };
}

/** Steps of scenes that say nothing of it: the picture must not depend on times. */
const steps = '90';

/**
 * In the page: put the element in and get its picture.
 * @param {{ attributes: Record<string, string>, children: string, width: number, height: number, ownSize: boolean }} scene
 * @returns {Promise<string>} a data URL of a PNG
 */
async function drawInPage({ attributes, children, width, height, ownSize }) {
  await customElements.whenDefined('volume-view');
  const element = /** @type {any} */ (document.createElement('volume-view'));
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  element.style.cssText = `display: block; width: ${width}px; height: ${height}px; max-height: none; aspect-ratio: auto`;
  element.innerHTML = children;
  document.body.append(element);
  await (element.whenRendered ? element.whenRendered() : element.whenRendered());
  const blob = await element.toBlob({ type: 'image/png', ...(ownSize ? {} : { width, height }) });
  return new Promise((resolve, reject) => {
    const reader = new FileReader();
    reader.addEventListener('load', () => resolve(/** @type {string} */ (reader.result)));
    reader.addEventListener('error', () => reject(reader.error));
    reader.readAsDataURL(blob);
  });
}

/**
 * @param {import('@playwright/test').Browser} browser
 * @param {string} url - of the checkout, with a slash at its end
 * @param {ElementScene} scene
 * @returns {Promise<import('./picture.mjs').Picture>}
 */
async function drawScene(
  browser,
  url,
  { name, attributes, children = '', width = 200, height = 150, pixelRatio, webgl1 },
) {
  const page = await browser.newPage({ viewport: { width: 640, height: 480 }, deviceScaleFactor: pixelRatio ?? 1 });
  try {
    if (webgl1) await page.addInitScript(withoutWebGl2);
    await page.goto(`${url}test/recorded/page.html`);
    await page.addScriptTag({ type: 'module', url: `${url}${pageScript}` });
    const ownSize = pixelRatio !== undefined;
    const dataUrl = await page.evaluate(drawInPage, {
      attributes: { steps, ...attributes },
      children,
      width,
      height,
      ownSize,
    });
    const picture = readPng(Buffer.from(dataUrl.split(',')[1], 'base64'));
    const expected = [width, height].map((side) => side * (pixelRatio ?? 1)).join(' x ');
    if (`${picture.width} x ${picture.height}` !== expected)
      throw new Error(`the picture got ${picture.width} x ${picture.height} pixels; expected ${expected}`);
    return { name, family: familyOf(name), kind: 'bytes', ...picture };
  } finally {
    await page.close();
  }
}

/** Where the script for pages lies; that for bundlers names packages, which a page does not know. */
const pageScript = 'dist/volume-view.js';

/**
 * @param {(name: string) => boolean} wanted
 * @param {(picture: import('./picture.mjs').Picture | { name: string, failure: string }) => void} drawn
 * @returns {Promise<import('../helpers/measure-in-browser.mjs').Machine>}
 */
export function drawElements(wanted, drawn) {
  return measurePackage(async ({ browser, url, machine }) => {
    for (const scene of elementScenes.filter(({ name }) => wanted(name))) {
      drawn(await drawScene(browser, url, scene).catch((error) => ({ name: scene.name, failure: String(error) })));
    }
    return machine;
  });
}
