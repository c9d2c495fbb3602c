// The widget in a real JupyterLab: `node scripts/try-jupyter.mjs PYTHON`, where PYTHON has anywidget, jupyterlab, nbconvert and ipykernel.
// It turns the volume by dragging, clicks on it, asks Python what came back, and looks at what nbconvert and a page of one file keep. It is
// no part of the tests, as it installs nothing and takes a minute. `node scripts/build-jupyter.mjs` comes before.
import assert from 'node:assert/strict';
import { spawn, spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { chromium } from '@playwright/test';
import { findBrowser, listTestArgs } from './find-browser.mjs';
import { projectRoot } from './shared-data.mjs';
import { turnAndClick } from './turn-and-click.mjs';

const python = process.argv[2] ?? 'python3';
const work = mkdtempSync(join(tmpdir(), 'volume-view-lab-'));
const [port, token] = [8877, 'volume-view'];

const cells = [
  `import json, sys
sys.path.insert(0, ${JSON.stringify(join(projectRoot, 'packages/jupyter/src'))})
import numpy as np
from volume_view import VolumeView
grid = np.mgrid[-1:1:48j, -1:1:56j, -1:1:64j]
ball = (200 * np.exp(-6 * (grid**2).sum(0))).astype(np.int16)
view = VolumeView(ball, affine=np.diag([2, 2, 2, 1]), pickable=True)
view`,
  `i, j, k = view.pick["voxel"]
print(json.dumps([bool(view.pick["value"] == ball[i, j, k]), view.camera, view.volume["dimensions"], len(view.picture), view.error]))`,
  `view.camera_orbit = "10deg 20deg 150%"
view.to_html("one.html", title="Ball")
print("written")`,
];
writeFileSync(
  join(work, 'try.ipynb'),
  JSON.stringify({
    nbformat: 4,
    nbformat_minor: 5,
    metadata: { kernelspec: { name: 'python3', display_name: 'Python 3', language: 'python' } },
    cells: cells.map((source, i) => ({
      id: `cell${i}`,
      cell_type: 'code',
      execution_count: null,
      metadata: {},
      outputs: [],
      source,
    })),
  }),
);
const lab = spawn(
  python,
  [
    ...['-m', 'jupyter', 'lab', '--no-browser', '--ip=127.0.0.1', `--port=${port}`, '--allow-root'],
    ...[`--IdentityProvider.token=${token}`, `--ServerApp.root_dir=${work}`],
  ],
  { stdio: 'ignore' },
);
const browser = await chromium.launch({
  executablePath: await findBrowser(),
  args: listTestArgs(),
});
try {
  const page = await browser.newPage({ viewport: { width: 1200, height: 1000 } });
  for (let i = 0; ; i++) {
    const there = await page
      .goto(`http://127.0.0.1:${port}/lab/workspaces/try-${process.pid}/tree/try.ipynb?token=${token}`)
      .catch(() => null);
    if (there) break;
    assert.ok(i < 60, 'JupyterLab did not start');
    await page.waitForTimeout(1000);
  }
  const code = page.locator('.jp-Notebook .jp-CodeCell');
  await code.first().waitFor({ timeout: 60_000 });
  await page.waitForTimeout(4000); // The kernel starts.
  /** @param {number} i */
  const run = async (i) => {
    await code.nth(i).locator('.cm-content').click();
    await page.keyboard.press('Shift+Enter');
  };
  /** @param {number} i */
  const answer = async (i) => {
    await run(i);
    const output = code.nth(i).locator('.jp-OutputArea-output').last();
    await output.waitFor({ timeout: 30_000 });
    return (await output.innerText()).trim();
  };
  await run(0);
  await turnAndClick(page);
  const [isValue, camera, dimensions, picture, error] = JSON.parse(await answer(1));
  assert.deepEqual([isValue, dimensions, error], [true, [48, 56, 64], null]);
  assert.match(camera.camera_orbit, /deg/);
  assert.ok(picture > 1000);
  console.log(`came back to Python: a pick, the camera ${camera.camera_orbit}, a picture of ${picture} bytes`);
  assert.equal(await answer(2), 'written');
  await page.waitForFunction(
    () => document.querySelector('volume-view')?.getAttribute('camera-orbit') === '10deg 20deg 150%',
  );
  await page.keyboard.press('Control+s');
  await page.waitForTimeout(2000);
  const converted = spawnSync(python, ['-m', 'jupyter', 'nbconvert', '--to', 'html', 'try.ipynb'], { cwd: work });
  assert.equal(converted.status, 0);
  assert.match(readFileSync(join(work, 'try.html'), 'utf8'), /<img[^>]*src="data:image\/png/);
  console.log('nbconvert keeps the picture');
  const one = await browser.newPage();
  /** @type {string[]} */
  const asked = [];
  one.on('request', (request) => asked.push(request.url().slice(0, 5)));
  await one.goto(pathToFileURL(join(work, 'one.html')).href);
  const format = await one.evaluate(async () => {
    await customElements.whenDefined('volume-view');
    const shown = /** @type {any} */ (document.querySelector('volume-view'));
    await shown.whenRendered();
    return shown.volume.format;
  });
  assert.equal(format, 'NIfTI-1');
  assert.deepEqual(
    [...new Set(asked)].filter((url) => url !== 'data:' && url !== 'blob:'),
    ['file:'],
  );
  console.log('the page of one file shows the volume, and asks for nothing');
} finally {
  await browser.close();
  lab.kill();
  rmSync(work, { recursive: true, force: true });
}
