// The apps: what is built, how, and what is looked at besides the picture.
import assert from 'node:assert/strict';

/**
 * @typedef {object} App
 * @property {string} name - of its folder below apps, too, unless `from` says another
 * @property {string} [from]
 * @property {string} command - a program of node_modules/.bin, as the docs have it
 * @property {string} serve - the folder that is served, below its own
 * @property {boolean} [message] - whether the message about x3dom is looked at
 * @property {(app: import('./open-app.mjs').OpenApp) => Promise<void>} [look]
 */

/** Attributes, an array as a property, and a listener: as the framework has set them. @param {import('./open-app.mjs').OpenApp} app */
async function lookAtFramework({ page }) {
  const view = page.locator('volume-view');
  assert.equal(await view.getAttribute('src'), '/volume.nii.gz');
  assert.equal(await view.getAttribute('alt'), 'A phantom');
  assert.equal(await view.getAttribute('value-window'), '-200 1200');
  assert.match(await page.locator('output').innerText(), /^-?\d+ to \d+$/, 'the listener of load was called');
}

/** The same, with a note and a tour that the component hears. @param {import('./open-app.mjs').OpenApp} app */
async function lookAtAngular(app) {
  await lookAtFramework(app);
  const { page } = app;
  assert.equal(await page.locator('volume-note').textContent(), 'The middle');
  await page.getByRole('button', { name: 'Next' }).click();
  await page.getByText('Step 2', { exact: true }).waitFor();
  await page.waitForFunction(() => {
    const view = /** @type {any} */ (document.querySelector('volume-view'));
    return view.getView()['camera-orbit']?.startsWith('90deg 90deg');
  });
}

/** Bootstrap's row and columns: a bare tag has a size. @param {import('./open-app.mjs').OpenApp} app */
async function lookAtColumns({ page }) {
  const sizes = await page
    .locator('volume-view')
    .evaluateAll((views) => views.map((view) => [view.clientWidth, view.clientHeight]));
  assert.equal(sizes.length, 2);
  for (const [width, height] of sizes) {
    assert.ok(width > 150, `a column's view is ${width} px wide`);
    assert.ok(Math.abs(height - width * 0.75) < 2, `a column's view is ${width} x ${height}; expected 4:3`);
  }
  const [first, last] = await page
    .locator('.row > .col')
    .evaluateAll((columns) => columns.map((column) => column.getBoundingClientRect().top));
  assert.equal(first, last, 'the columns stand side by side');
}

/** @type {App[]} */
export const apps = [
  { name: 'vite', command: 'vite build', serve: 'dist', message: true, look: lookAtColumns },
  { name: 'react', command: 'vite build', serve: 'dist', look: lookAtFramework },
  { name: 'svelte', command: 'vite build', serve: 'dist', look: lookAtFramework },
  { name: 'vue', command: 'vite build', serve: 'dist', look: lookAtFramework },
  { name: 'angular', command: 'vite build', serve: 'dist', look: lookAtAngular },
  { name: 'next', command: 'next build', serve: 'out', look: lookAtFramework },
  {
    name: 'webpack',
    from: 'plain',
    command: 'webpack ./app.js --mode production -o dist --output-filename app.js',
    serve: '.',
  },
  {
    name: 'esbuild',
    from: 'plain',
    command: 'esbuild app.js --bundle --minify --outfile=dist/app.js',
    serve: '.',
    message: true,
  },
  {
    name: 'esbuild-split',
    from: 'plain',
    command: 'esbuild app.js --bundle --minify --format=esm --splitting --outdir=dist',
    serve: '.',
  },
  { name: 'rollup', from: 'plain', command: 'rollup app.js -p @rollup/plugin-node-resolve -d dist', serve: '.' },
  { name: 'parcel', command: 'parcel build index.html --dist-dir dist --no-autoinstall', serve: 'dist', message: true },
];
