import { existsSync } from 'node:fs';
import { findOnPath } from '../../scripts/find-browser.mjs';
import { startScreen } from './processes.mjs';

const MAC = '/Applications/Firefox.app/Contents/MacOS/firefox';
const needsScreen = process.platform === 'linux';

/** @type {import('./run.mjs').Engine} */
export const engine = {
  name: 'Firefox',
  packages: ['firefox-esr', 'xvfb'],
  find() {
    const path = findOnPath('firefox-esr') ?? findOnPath('firefox') ?? (existsSync(MAC) ? MAC : null);
    return needsScreen && !findOnPath('Xvfb') ? null : path;
  },
  async open(url, executablePath) {
    const { default: puppeteer } = await import('puppeteer-core');
    const screen = needsScreen ? await startScreen() : null;
    const environment = { ...process.env, LIBGL_ALWAYS_SOFTWARE: '1', MOZ_DISABLE_CONTENT_SANDBOX: '1' };
    if (screen) Object.assign(environment, { DISPLAY: screen.display, WAYLAND_DISPLAY: undefined });
    const browser = await puppeteer.launch({
      browser: 'firefox',
      executablePath,
      headless: !screen, // headless Firefox has no WebGL as root
      env: environment,
      extraPrefsFirefox: {
        'security.sandbox.content.level': 0,
        'webgl.force-enabled': true,
        'gfx.x11-egl.force-enabled': true,
      },
    });
    const page = await browser.newPage();
    /** @type {string[]} */
    const messages = [];
    page.on('console', (message) => messages.push(`${message.type()}: ${message.text()}`));
    page.on('pageerror', (error) =>
      messages.push(`page error: ${error instanceof Error ? error.message : String(error)}`),
    );
    await page.goto(url);
    return {
      version: await browser.version(),
      messages,
      evaluate: (expression) => page.evaluate(expression),
      async close() {
        await browser.close();
        await screen?.close();
      },
    };
  },
};
