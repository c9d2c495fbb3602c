// A picture at rest that shows nothing says so, with its cause; where something shows, and where nothing is meant to, no word is said.
import type { Page } from '@playwright/test';
import { niftiBytes } from '../helpers/nifti-bytes.ts';
import { syntheticVolume } from '../helpers/synthetic.ts';
import { findFaults } from './helpers/axe.ts';
import { expect, fieldUrl, keptTest as test, open, setAttributes, settle, withElement } from './helpers/harness.ts';

const size = { head: '<style>volume-view { width: 320px; height: 240px }</style>' };
const view = (attributes = '', children = '', src = fieldUrl): string =>
  `<main><h1>A field</h1><volume-view src="${src}" steps="20" ${attributes} alt="A field">${children}</volume-view></main>`;

/** Serve volumes that are made here. */
async function serve(page: Page): Promise<void> {
  const make = (field: (x: number, y: number, z: number) => number): Uint8Array =>
    niftiBytes(syntheticVolume({ dimensions: [16, 16, 16], spacing: [1, 1, 1], field, kind: 'float32' }));
  const files: Record<string, () => Uint8Array> = {
    nan: () => make(() => NaN),
    seven: () => make(() => 7),
    labels: () => make((x) => (x < 0.5 ? 1 : 2)),
  };
  const triangle = [
    'solid',
    'facet normal 0 0 1',
    'outer loop',
    ...['-9 -9 0', '9 -9 0', '0 9 0'].map((place) => `vertex ${place}`),
    'endloop',
    'endfacet',
    'endsolid',
  ].join('\n');
  await page.route('**/blank/triangle.stl', async (route) => {
    await new Promise((resolve) => setTimeout(resolve, 1500));
    await route.fulfill({ body: triangle });
  });
  await page.route('**/blank/*.nii', (route) =>
    route.fulfill({ body: Buffer.from(files[/(\w+)\.nii/.exec(route.request().url())![1]]()) }),
  );
}

/** The words over the picture; '' for none. */
const note = (page: Page): Promise<string> =>
  withElement(page, ({ shadowRoot }) => shadowRoot!.querySelector('.blank')?.textContent ?? '');

/** Frames and parts that come later have come. */
async function rest(page: Page): Promise<void> {
  await settle(page);
  await page.waitForTimeout(400);
}

const above = 'transfer-function="500 #000 0, 600 #fff 100%"';

const blank: Record<string, readonly [html: string, word: RegExp]> = {
  'a transfer function above all values': [
    view(above),
    /^Nothing to see here\. All values, from [\d.]+ to [\d.]+, are transparent\./,
  ],
  'one below all values': [view('transfer-function="-9 #fff 0, -8 #fff 100%, -7 #fff 0"'), /All values/],
  'the largest values of each ray, all of them transparent': [view(`${above} projection="max"`), /All values/],
  'no opacity at all': [view('transfer-function="0 #000 0, 1 #fff 0"'), /transparent everywhere/],
  'a volume without any value': [view('', '', '/blank/nan.nii'), /no values/],
  'a plane that cuts all away': [view('', '<clipplane plane="1 0 0 -1000"></clipplane>'), /cut away/],
  'labels that all are hidden': [
    view(
      '',
      '<volume-labels src="/blank/labels.nii"><volume-label value="0" hidden></volume-label><volume-label value="1" hidden></volume-label><volume-label value="2" hidden></volume-label></volume-labels>',
      '/blank/seven.nii',
    ),
    /All labels are hidden/,
  ],
  'an opacity that nobody sees': [view('opacity-factor="0.000001"'), /too faint/],
  'a camera that looks past it': [view('camera-target="1000 0 0" camera-orbit="0deg 90deg 60"'), /out of sight/],
  'a radar whose echoes are all weaker than its colours': [
    view('rings="none" transfer-function="200 #000 0, 300 #fff 100%"', '', '/test/fixtures/radar/odim-2.2.h5'),
    /^No echoes from 200 dBZ on/,
  ],
};

for (const [name, [html, word]] of Object.entries(blank))
  test(`${name}: a word`, async ({ page }) => {
    await serve(page);
    await open(page, html, size);
    await settle(page);
    await expect.poll(() => note(page)).toMatch(word);
    const said = await withElement(page, ({ renderStats, shadowRoot }) => ({
      keeps: renderStats!.keepsMaxError,
      role: shadowRoot!.querySelector('.blank')!.getAttribute('role'),
    }));
    expect(said, 'nothing has been kept').toEqual({ keeps: said.keeps === null ? null : false, role: 'status' });
  });

const right: Record<string, string> = {
  'a picture': view(),
  'a volume of one value': view('', '', '/blank/seven.nii'),
  'opacity-factor="0", as its author wants it': view('opacity-factor="0"'),
  'a shape alone': view(
    above,
    '<shape><appearance><material diffusecolor="1 0 0"></material></appearance><sphere radius="6"></sphere></shape>',
  ),
  'rings around a radar without echoes': view(
    'transfer-function="200 #000 0, 300 #fff 100%"',
    '',
    '/test/fixtures/radar/odim-2.2.h5',
  ),
  'a surface that comes late': view(above, '<volume-surface src="/blank/triangle.stl"></volume-surface>'),
};

for (const [name, html] of Object.entries(right))
  test(`${name}: no word`, async ({ page }) => {
    await serve(page);
    await open(page, html, size);
    await rest(page);
    expect(await note(page)).toBe('');
  });

test('it notifies the page, follows its language, is not printed, and goes as soon as something shows', async ({
  page,
}) => {
  await open(page, view(above), size);
  await withElement(page, (element) => {
    const reported: unknown[] = ((window as unknown as { reported: unknown[] }).reported = []);
    element.addEventListener('picture-blank', ({ detail }) => reported.push(detail && detail.cause));
  });
  await settle(page);
  await expect.poll(() => note(page)).toMatch(/^Nothing/);
  expect(await findFaults(page)).toEqual([]);
  await page.evaluate(() => (document.documentElement.lang = 'de'));
  await expect.poll(() => note(page)).toMatch(/^Hier ist nichts zu sehen\./);
  await page.evaluate(() => (document.documentElement.lang = 'en'));
  await page.emulateMedia({ media: 'print' });
  expect(
    await withElement(page, ({ shadowRoot }) => getComputedStyle(shadowRoot!.querySelector('.blank')!).display),
  ).toBe('none');
  await page.emulateMedia({ media: null });
  await setAttributes(page, { 'transfer-function': '0 #000 0, 1 #fff 50%' });
  await expect.poll(() => note(page)).toBe('');
  await setAttributes(page, { 'transfer-function': '500 #000 0, 600 #fff 100%' });
  await expect.poll(() => note(page)).toMatch(/^Nothing/);
  await setAttributes(page, { src: null });
  await expect.poll(() => note(page), 'there is no picture any more').toBe('');
  expect(await page.evaluate(() => (window as unknown as { reported: unknown[] }).reported)).toEqual([
    'values',
    null,
    'values',
    null,
  ]);
});

test('a person who moves away knows why nothing is to be seen', async ({ page }) => {
  await open(page, view('camera-orbit="0deg 90deg 60"'), size);
  await settle(page);
  await page.evaluate(() => {
    // As far as no person moves at once: the view's own camera.
    const { viewer } = Reflect.get(document.querySelector('volume-view')!, Symbol.for('volume-view.socket')).view;
    viewer.rig.aim({ ...viewer.rig.goal, target: [1000, 0, 0] }, true);
    viewer.invalidate();
  });
  await rest(page);
  expect(await note(page)).toBe('');
});

test('scans that play may be empty; one at which they stop says so', async ({ page }) => {
  await serve(page);
  await open(page, view(`${above} play-speed="20"`, '', '/blank/seven.nii /blank/labels.nii'), size);
  await settle(page);
  await expect.poll(() => note(page)).toMatch(/^Nothing/);
  await withElement(page, (element) => void element.play());
  await expect.poll(() => note(page)).toBe('');
  await withElement(page, (element) => element.pause());
  await expect.poll(() => note(page)).toMatch(/^Nothing/);
});
