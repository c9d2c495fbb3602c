// The widget in a real marimo notebook: `node scripts/try-marimo.mjs PYTHON`, where PYTHON has marimo, anywidget and NumPy. It runs the
// notebook in marimo's editor, turns the volume by dragging, clicks on it, reads what came back to Python, and lets Python turn it. It is no
// part of the tests, as it installs nothing and takes half a minute. `node scripts/build-jupyter.mjs` comes before.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { chromium } from '@playwright/test';
import { findBrowser, listTestArgs } from './find-browser.mjs';
import { projectRoot } from './shared-data.mjs';
import { turnAndClick } from './turn-and-click.mjs';

const python = process.argv[2] ?? 'python3';
const port = 8879;
const work = mkdtempSync(join(tmpdir(), 'volume-view-marimo-'));
const notebook = join(work, 'try.py');
writeFileSync(
  notebook,
  `import marimo
app = marimo.App()

@app.cell
def _():
    import json, sys
    sys.path.insert(0, ${JSON.stringify(join(projectRoot, 'packages/jupyter/src'))})
    import marimo as mo
    import numpy as np
    from volume_view import VolumeView
    grid = np.mgrid[-1:1:48j, -1:1:56j, -1:1:64j]
    ball = (200 * np.exp(-6 * (grid**2).sum(0))).astype(np.int16)
    view = mo.ui.anywidget(VolumeView(ball, affine=np.diag([2, 2, 2, 1]), pickable=True))
    view
    return ball, json, mo, view

@app.cell
def _(ball, json, mo, view):
    view.value
    pick = view.widget.pick
    is_value = bool(pick and pick["value"] == ball[tuple(pick["voxel"])])
    mo.plain_text("answer " + json.dumps([is_value, view.widget.camera, view.widget.volume, view.widget.error]))
    return

@app.cell
def _(mo):
    turn = mo.ui.button(label="turn it", value=0, on_click=lambda count: count + 1)
    turn
    return (turn,)

@app.cell
def _(turn, view):
    if turn.value:
        view.widget.camera_orbit = "10deg 20deg 150%"
    return
`,
);
const marimo = spawn(
  python,
  [
    ...['-m', 'marimo', 'edit', '--headless', '--no-token', '--host', '127.0.0.1', '--port', String(port)],
    ...['--skip-update-check', notebook],
  ],
  { stdio: 'ignore', cwd: work },
);
const browser = await chromium.launch({ executablePath: await findBrowser(), args: listTestArgs() });
try {
  const page = await browser.newPage({ viewport: { width: 1200, height: 1200 } });
  for (let i = 0; ; i++) {
    if (await page.goto(`http://127.0.0.1:${port}/`).catch(() => null)) break;
    assert.ok(i < 60, 'marimo did not start');
    await page.waitForTimeout(1000);
  }
  await page.locator('.marimo-cell').nth(3).waitFor({ timeout: 60_000 });
  await page.keyboard.press('Control+Shift+R'); // Run all.
  await turnAndClick(page);
  const output = page.getByText(/^answer/).last();
  await page.waitForTimeout(2000); // The cell that reads it runs again.
  const [isValue, camera, volume, error] = JSON.parse((await output.innerText()).replace('answer ', ''));
  assert.deepEqual([isValue, volume.dimensions, error], [true, [48, 56, 64], null]);
  assert.match(camera.camera_orbit, /deg/);
  console.log(`came back to Python: a pick, the camera ${camera.camera_orbit}`);
  await page.getByRole('button', { name: 'turn it' }).click();
  await page.waitForFunction(() => {
    /** @type {(root: Document | ShadowRoot) => Element | null} */
    const find = (root) => {
      const here = root.querySelector('volume-view');
      if (here) return here;
      for (const { shadowRoot } of root.querySelectorAll('*')) {
        const inside = shadowRoot && find(shadowRoot);
        if (inside) return inside;
      }
      return null;
    };
    return find(document)?.getAttribute('camera-orbit') === '10deg 20deg 150%';
  });
  console.log('a changed trait turned the volume');
  await page.screenshot({ path: process.argv[3] ?? join(work, 'marimo.png') });
} finally {
  await browser.close();
  marimo.kill();
  rmSync(work, { recursive: true, force: true });
}
