// The error that x3dom is missing names an address: with the file put there, the volume is in the picture.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { projectRoot } from '../../scripts/shared-data.mjs';
import { openApp } from './open-app.mjs';

const x3dom = readFileSync(join(projectRoot, 'dist/x3dom.js'), 'utf8');

/**
 * Without x3dom's file, and with a policy that forbids to run its text.
 * @param {string} folder - what is served
 */
export async function checkMessage(folder) {
  let isThere = false;
  let reported = '';
  await openApp(
    folder,
    async ({ page }) => {
      const view = page.locator('volume-view').first();
      await page.waitForFunction(() => customElements.get('volume-view'));
      const { code, message } = await view.evaluate((/** @type {any} */ element) =>
        element.whenRendered().then(
          () => ({ code: 'none', message: '' }),
          (/** @type {any} */ error) => ({ code: error.code, message: error.message }),
        ),
      );
      assert.equal(code, 'x3dom/unavailable', message);
      reported = /could not be loaded from (\S+)\. Put volume-view's x3dom\.js there/.exec(message)?.[1] ?? '';
      assert.ok(reported, message);
      isThere = true;
      await view.evaluate((/** @type {any} */ element) => {
        element.reload();
        return element.whenRendered();
      });
    },
    async (page) => {
      await page.route(
        (url) => url.pathname.endsWith('/'),
        async (route) => {
          const response = await route.fetch();
          await route.fulfill({
            response,
            headers: { ...response.headers(), 'content-security-policy': "script-src 'self' 'unsafe-inline'" },
          });
        },
      );
      await page.route(/x3dom/, (route) => {
        // Chunks of a bundle may be called so, too; x3dom's file is where the message says.
        if (isThere && new URL(reported, page.url()).href === route.request().url())
          return route.fulfill({ body: x3dom, contentType: 'text/javascript' });
        return /text/.test(route.request().url()) ? route.continue() : route.abort();
      });
    },
  );
}
