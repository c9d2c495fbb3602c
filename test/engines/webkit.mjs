// WebKitGTK over plain W3C WebDriver calls: no client library is needed for six of them.
import { existsSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { setTimeout as sleep } from 'node:timers/promises';
import { findOnPath } from '../../scripts/find-browser.mjs';
import { findFreePort, startProcess, startScreen, stopProcess } from './processes.mjs';

/** The test browser that comes with the library: /usr/lib/<machine>/webkit2gtk-4.1/MiniBrowser. */
function findMiniBrowser() {
  if (process.platform !== 'linux') return null;
  const versions = ['webkit2gtk-4.1', 'webkitgtk-6.0', 'webkit2gtk-4.0'];
  const folders = readdirSync('/usr/lib').flatMap((machine) =>
    versions.map((version) => join('/usr/lib', machine, version)),
  );
  return folders.map((folder) => join(folder, 'MiniBrowser')).find((path) => existsSync(path)) ?? null;
}

/**
 * One WebDriver command.
 * @param {string} url
 * @param {unknown} [body] - makes it a POST
 * @param {string} [method]
 */
async function command(url, body, method = body === undefined ? 'GET' : 'POST') {
  const init = body === undefined ? { method } : { method, body: JSON.stringify(body) };
  const response = await fetch(url, init);
  const { value } = /** @type {{ value: any }} */ (await response.json());
  if (!response.ok) throw new Error(`WebDriver: ${value?.error}: ${value?.message}`);
  return value;
}

/** @param {string} base */
async function waitUntilReady(base) {
  for (let attempt = 0; attempt < 100; attempt += 1) {
    const ready = await fetch(`${base}/status`).then(
      (response) => response.ok,
      () => false,
    );
    if (ready) return;
    await sleep(200);
  }
  throw new Error('WebKitWebDriver did not answer within 20 s');
}

/** @type {import('./run.mjs').Engine} */
export const engine = {
  name: 'WebKit',
  packages: ['webkit2gtk-driver', 'xvfb'],
  find: () => (findOnPath('WebKitWebDriver') && findOnPath('Xvfb') ? findMiniBrowser() : null),
  async open(url, executablePath) {
    const screen = await startScreen();
    const port = await findFreePort();
    const root = process.getuid?.() === 0 ? { WEBKIT_DISABLE_SANDBOX_THIS_IS_DANGEROUS: '1' } : {};
    const driver = startProcess('WebKitWebDriver', [`--port=${port}`, '--host=127.0.0.1'], {
      env: { ...process.env, DISPLAY: screen.display, GDK_BACKEND: 'x11', LIBGL_ALWAYS_SOFTWARE: '1', ...root },
    });
    const stop = async () => {
      await stopProcess(driver);
      await screen.close();
    };
    try {
      const base = `http://127.0.0.1:${port}`;
      await waitUntilReady(base);
      const browserOptions = { binary: executablePath, args: ['--automation'] };
      const { sessionId, capabilities } = await command(`${base}/session`, {
        capabilities: { alwaysMatch: { 'webkitgtk:browserOptions': browserOptions } },
      });
      const session = `${base}/session/${sessionId}`;
      await command(`${session}/url`, { url });
      return {
        version: `${capabilities.browserName} ${capabilities.browserVersion}`,
        messages: [], // the protocol has none; the page collects its own (errors.js)
        evaluate: (expression) => command(`${session}/execute/sync`, { script: `return (${expression})`, args: [] }),
        async close() {
          await command(session, undefined, 'DELETE').catch(() => undefined);
          await stop();
        },
      };
    } catch (error) {
      await stop();
      throw error;
    }
  },
};
