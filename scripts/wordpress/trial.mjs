// What all parts of the trial use: a person in the browser, and waiting for the picture.
import assert from 'node:assert/strict';

/** @typedef {import('@playwright/test').Page} Page */
/** @typedef {Awaited<ReturnType<typeof import('./start-site.mjs').startSite>>} Site */
/**
 * @typedef {object} Trial
 * @property {Site} site
 * @property {import('@playwright/test').Browser} browser
 * @property {(page: Page, name: string) => Promise<void>} look - takes a picture of the page
 * @property {string} data - the folder of the demos' data
 */

/** A person who has logged in. @param {Trial} trial @param {string} name @returns {Promise<Page>} */
export async function enter({ site, browser }, name) {
  const page = await (await browser.newContext({ viewport: { width: 1300, height: 900 } })).newPage();
  await page.goto(`${site.url}/wp-login.php`);
  await page.fill('#user_login', name);
  await page.fill('#user_pass', 'trial');
  await page.click('#wp-submit');
  await page.waitForURL(/wp-admin/);
  return page;
}

/** Opens the editor, without the welcome that hides it. @param {Page} page @param {string} url */
export async function openEditor(page, url) {
  await page.goto(url);
  const isReady = () => Boolean(/** @type {any} */ (window).wp?.data?.select('core/editor')?.getCurrentPostId?.());
  await page.waitForFunction(isReady, null, { timeout: 60_000 });
  await page.evaluate(() => {
    const preferences = /** @type {any} */ (window).wp.data.dispatch('core/preferences');
    for (const scope of ['core', 'core/edit-post']) preferences.set(scope, 'welcomeGuide', false);
    preferences.set('core', 'enableChoosePatternModal', false);
  });
  await page.waitForTimeout(1500);
}

/** Where the blocks are: newer editors have a frame for them. @param {Page} page */
export const findCanvas = (page) => page.frame({ name: 'editor-canvas' }) ?? page.mainFrame();

/** Waits for the final picture. @param {Page | import('@playwright/test').Frame} page @returns {Promise<string>} the format of the file */
export const waitForPicture = (page) =>
  page.evaluate(async () => {
    await customElements.whenDefined('volume-view');
    const view = /** @type {any} */ (document.querySelector('volume-view'));
    await view.whenRendered();
    return view.volume.format;
  });

/** The pixels of the only view of a page. @param {Page} page @returns {Promise<string>} */
export const readPixels = (page) =>
  page.evaluate(async () => {
    const view = /** @type {any} */ (document.querySelector('volume-view'));
    await view.whenRendered();
    const blob = await view.toBlob({ width: 400, height: 300 });
    const bytes = new Uint8Array(await blob.arrayBuffer());
    return [...new Uint8Array(await crypto.subtle.digest('SHA-256', bytes))].join();
  });

/** Saves the post of the editor as published. @param {Page} page @param {string} title @returns {Promise<number>} its number */
export async function publish(page, title) {
  const id = await page.evaluate(async (title) => {
    const { dispatch, select } = /** @type {any} */ (window).wp.data;
    await dispatch('core/editor').editPost({ title, status: 'publish' });
    await dispatch('core/editor').savePost();
    return select('core/editor').getCurrentPostId();
  }, title);
  assert.ok(id > 0);
  return id;
}

/** A reader without a login. @param {Trial} trial @param {number} id - of a post @param {string} [more] - of the address */
export async function read({ site, browser }, id, more = '') {
  const page = await (await browser.newContext({ viewport: { width: 1300, height: 900 } })).newPage();
  /** @type {string[]} */
  const asked = [];
  page.on('request', (request) => asked.push(request.url()));
  await page.goto(`${site.url}/?p=${id}${more}`);
  return { page, asked };
}
