import { chromium } from '@playwright/test';
import { findBrowser, listLaunchArgs } from '../../scripts/find-browser.mjs';

// A remark of the GL driver on the cost of a readPixels, which tests need and pages do not make.
const DRIVER_HINT = /GL Driver Message \(OpenGL, Performance/;

/** @type {import('./run.mjs').Engine} */
export const engine = {
  name: 'Chromium',
  packages: [], // findBrowser installs it
  find: findBrowser,
  async open(url, executablePath) {
    const browser = await chromium.launch({
      executablePath,
      args: [...listLaunchArgs(), '--js-flags=--expose-gc', '--enable-precise-memory-info'],
    });
    const page = await browser.newPage();
    /** @type {string[]} */
    const messages = [];
    page.on('console', (message) => {
      if (!DRIVER_HINT.test(message.text())) messages.push(`${message.type()}: ${message.text()}`);
    });
    page.on('pageerror', (error) => messages.push(`page error: ${error.message}`));
    await page.goto(url);
    return {
      version: browser.version(),
      messages,
      evaluate: (expression) => page.evaluate(expression),
      close: () => browser.close(),
    };
  },
};
