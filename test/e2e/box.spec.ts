// The box of a bare tag, as layouts of pages make it: it fills a block, and elsewhere has a size of its own, as an image has.
import type { Page } from '@playwright/test';
import { expect, fieldUrl, settle, test, withElement } from './helpers/harness.ts';

const tag = '<volume-view></volume-view>';

/** A page with no CSS but that of the test: 900 wide, and no margins. */
async function openBare(page: Page, body: string, head = ''): Promise<void> {
  const path = '/test/e2e/pages/box.html';
  await page.route(`**${path}`, (route) =>
    route.fulfill({
      contentType: 'text/html; charset=utf-8',
      body: `<!doctype html><html lang="en"><head><title>Test</title><script type="module" src="/dist/volume-view.js"></script>
      <style>body { margin: 0 }</style>${head}</head><body>${body}</body></html>`,
    }),
  );
  await page.goto(path);
  await page.evaluate(() =>
    customElements
      .whenDefined('volume-view')
      .then(() => Promise.all([...document.querySelectorAll('volume-view')].map((element) => element.updateComplete))),
  );
}

/** One page for many: an element's box depends on its section alone. */
const sections = (bodies: Record<string, string>): string =>
  Object.entries(bodies)
    .map(([name, body]) => `<section id="${name}">${body}</section>`)
    .join('');
const apart = '<style>section { display: flow-root; position: relative; width: 900px }</style>';

/** Width and height of each of the page's elements, by section. */
const boxes = (page: Page): Promise<Record<string, number[][]>> =>
  page.evaluate(() =>
    Object.fromEntries(
      [...document.querySelectorAll('section')].map((section) => [
        section.id,
        [...section.querySelectorAll('volume-view')].map((element) => {
          const { width, height } = element.getBoundingClientRect();
          return [width, height].map((length) => Math.round(length * 10) / 10);
        }),
      ]),
    ),
  );

/** What Bootstrap 5 says of its rows and columns, as far as it makes their boxes. */
const bootstrap = `<style>
  section *, section *::before, section *::after { box-sizing: border-box }
  .row { --x: 24px; display: flex; flex-wrap: wrap; margin-inline: calc(var(--x) / -2) }
  .row > * { flex-shrink: 0; width: 100%; max-width: 100%; padding-inline: calc(var(--x) / 2) }
  .col { flex: 1 0 0 }
  .col-4 { flex: 0 0 auto; width: 33.33333333% }
  .col-auto { flex: 0 0 auto; width: auto }
  .d-flex { display: flex }
  .justify-content-center { justify-content: center }
  .img-fluid { max-width: 100%; height: auto }
</style>`;

/** Layouts, and what the boxes of their elements are. */
const layouts: Record<string, [body: string, expected: number[][]]> = {
  block: [tag, [[900, 675]]],
  'narrow block': [`<div style="width: 400px">${tag}</div>`, [[400, 300]]],
  'flex row': [`<div style="display: flex">${tag}<p>Words</p></div>`, [[300, 225]]],
  'flex row of two, one of which grows': [
    `<div style="display: flex; align-items: start">${tag}<volume-view style="flex: 1"></volume-view></div>`,
    [
      [300, 225],
      [600, 450],
    ],
  ],
  'flex row that is narrower': [
    `<div style="display: flex; width: 200px; align-items: start">${tag}</div>`,
    [[200, 150]],
  ],
  'flex row with a height': [`<div style="display: flex; height: 150px">${tag}</div>`, [[300, 150]]],
  column: [`<div style="display: flex; flex-direction: column; width: 400px">${tag}<p>Words</p></div>`, [[400, 300]]],
  'centred column': [
    `<div style="display: flex; flex-direction: column; align-items: center">${tag}<p>Words</p></div>`,
    [[300, 225]],
  ],
  grid: [
    `<div style="display: grid; grid-template-columns: 1fr 1fr">${tag}${tag}</div>`,
    [
      [450, 337.5],
      [450, 337.5],
    ],
  ],
  'grid of auto columns': [
    `<div style="display: grid; grid-template-columns: auto auto; justify-content: start">${tag}<p>Words</p></div>`,
    [[300, 225]],
  ],
  'centred grid': [`<div style="display: grid; place-items: center">${tag}</div>`, [[300, 225]]],
  float: [`<volume-view style="float: left"></volume-view><p>Words</p>`, [[300, 225]]],
  'cell of a table': [`<table cellpadding="0"><tr><td>${tag}</td><td>Words</td></tr></table>`, [[300, 225]]],
  'cell of a wide table': [
    `<table cellpadding="0" cellspacing="0" style="width: 800px; table-layout: fixed"><tr><td>${tag}</td><td>Words</td></tr></table>`,
    [[400, 300]],
  ],
  'inline block': [`Words <volume-view style="display: inline-block"></volume-view> words`, [[300, 225]]],
  'absolute place': [`<volume-view style="position: absolute; inset-inline-end: 0"></volume-view>`, [[300, 225]]],
  'banner behind the words': [
    `<div style="position: relative; height: 300px"><volume-view style="position: absolute; inset: 0"></volume-view></div>`,
    [[900, 300]],
  ],
  'banner with a width': [
    `<div style="position: relative; height: 300px"><volume-view style="position: absolute; inset: 0 auto 0 0; width: 50%"></volume-view></div>`,
    [[450, 300]],
  ],
  'all of a low block': [
    `<div style="width: 374px; height: 300px"><volume-view style="height: 100%"></volume-view></div>`,
    [[374, 300]],
  ],
  'a height alone, in CSS': [`<volume-view style="height: 300px"></volume-view>`, [[900, 300]]],
  'a ratio in CSS': [`<volume-view style="aspect-ratio: 2"></volume-view>`, [[900, 450]]],
  'fit-content': [`<volume-view style="width: fit-content"></volume-view>`, [[300, 225]]],
  'column of Bootstrap': [
    `<div class="row" style="width: 924px"><div class="col">${tag}</div><div class="col">${tag}</div></div>`,
    [
      [438, 328.5],
      [438, 328.5],
    ],
  ],
  'third of a row of Bootstrap': [
    `<div class="row" style="width: 924px"><div class="col-4">${tag}</div></div>`,
    [[284, 213]],
  ],
  'col-auto of Bootstrap': [
    `<div class="row" style="width: 924px"><div class="col-auto">${tag}</div></div>`,
    [[300, 225]],
  ],
  'col-auto of Bootstrap, the tag itself': [
    `<div class="row" style="width: 924px"><volume-view class="col-auto"></volume-view></div>`,
    [[324, 225]],
  ],
  'd-flex of Bootstrap': [`<div class="d-flex justify-content-center">${tag}</div>`, [[300, 225]]],
  'img-fluid of Bootstrap': [
    `<div style="display: flex; width: 200px"><volume-view class="img-fluid" width="400" height="200"></volume-view></div>`,
    [[200, 100]],
  ],
};

test('a bare tag fills a block, and has a size of its own in any other layout', async ({ page }) => {
  await page.setViewportSize({ width: 900, height: 900 });
  await openBare(
    page,
    sections(Object.fromEntries(Object.entries(layouts).map(([name, [body]]) => [name, body]))),
    apart + bootstrap,
  );
  expect(await boxes(page)).toEqual(
    Object.fromEntries(Object.entries(layouts).map(([name, [, expected]]) => [name, expected])),
  );
});

test('a bare tag is no higher than the screen, and no wider than a phone', async ({ page }) => {
  await page.setViewportSize({ width: 900, height: 600 });
  await openBare(page, sections({ block: tag }));
  const column = `<div style="display: flex; flex-direction: column">${tag}<p>Words</p></div>`;
  expect(await boxes(page)).toEqual({ block: [[900, 600]] });
  await openBare(page, sections({ block: tag, column }));
  expect(await boxes(page)).toEqual({ block: [[900, 600]], column: [[900, 600]] });
  await page.setViewportSize({ width: 240, height: 500 });
  await openBare(page, sections({ grid: `<div style="display: grid; place-items: center">${tag}</div>` }));
  expect(await boxes(page)).toEqual({ grid: [[240, 180]] });
});

test('the text below stays where it is when the script comes', async ({ page }) => {
  await page.setViewportSize({ width: 900, height: 900 });
  // What a browser can read of the attributes without a script: numbers.
  const numbers = Object.fromEntries(
    Object.entries(sizes).flatMap(([name, [attributes, , css]]) =>
      /%|px|wide/.test(attributes) || css ? [] : [[name, `<volume-view ${attributes}></volume-view>`]],
    ),
  );
  const bodies = sections({
    ...Object.fromEntries(Object.entries(layouts).map(([name, [body]]) => [name, body])),
    ...numbers,
  });
  let send = (): void => {};
  const held = new Promise<void>((resolve) => {
    send = resolve;
  });
  await page.route('**/dist/volume-view.js', async (route) => {
    await held;
    await route.continue();
  });
  await page.route('**/early.html', (route) =>
    route.fulfill({
      contentType: 'text/html; charset=utf-8',
      body: `<!doctype html><html lang="en"><head><title>Test</title><link rel="stylesheet" href="/dist/volume-view.css"><script async type="module" src="/dist/volume-view.js"></script>
      <style>body { margin: 0 }</style>${apart + bootstrap}</head><body>${bodies}</body></html>`,
    }),
  );
  await page.goto('/early.html', { waitUntil: 'commit' });
  // All of the page has to be there, with the style of the package: boxes also move while a page is read, without any script.
  await page.waitForFunction(
    () =>
      document.readyState !== 'loading' &&
      document.querySelectorAll('volume-view').length > 20 &&
      [...document.styleSheets].some(({ href }) => href?.endsWith('/dist/volume-view.css')),
  );
  const before = await boxes(page);
  expect(await page.evaluate(() => customElements.get('volume-view') === undefined)).toBe(true);
  send();
  await page.waitForFunction(() => customElements.get('volume-view') !== undefined);
  await page.evaluate(() =>
    Promise.all([...document.querySelectorAll('volume-view')].map((element) => element.updateComplete)),
  );
  expect(before).toEqual(await boxes(page));
  expect(before.block).toEqual([[900, 675]]);
});

test.describe('a theme that resets all display', () => {
  test.use({ allowedLines: /display: block or inline-block/ });

  test('makes a box without a size, and the console says what to write', async ({ page }) => {
    const lines: string[] = [];
    page.on('console', (message) => lines.push(message.text()));
    await openBare(page, sections({ one: '<volume-view style="display: inline"></volume-view>' }));
    expect(lines.filter((line) => line.includes('display: block or inline-block'))).toHaveLength(1);
  });
});

test('a bare tag shows its picture in a flex row', async ({ page }) => {
  await openBare(
    page,
    `<div style="display: flex"><volume-view src="${fieldUrl}" steps="20" alt="A field"></volume-view><p>Words</p></div>`,
  );
  await settle(page);
  const canvas = await page
    .locator('volume-view canvas')
    .evaluate(({ width, height }: HTMLCanvasElement) => [width, height]);
  expect(canvas).toEqual([300, 225]);
});

/** Attributes, the box that they make, and the page's CSS for `volume-view`. */
const sizes: Record<string, [attributes: string, expected: number[], css?: string]> = {
  'both, with their ratio': ['width="400" height="200"', [400, 200]],
  'a width alone': ['width="400"', [400, 300]],
  'a height alone': ['height="150"', [200, 150]],
  'a part of the page': ['width="50%"', [450, 337.5]],
  'with a unit, as people write them': ['width="400px" height="200px"', [400, 200]],
  'the CSS of the page goes before': ['width="400" height="200"', [600, 300], 'width: 600px; height: auto'],
  'the CSS of the page goes before, by other names': [
    'width="400" height="200"',
    [900, 450],
    'inline-size: 100%; block-size: auto',
  ],

  'what is no length is left out': ['width="wide" height="-3"', [900, 675]],
};

test('width and height are honoured as those of an image, and what the page says in CSS goes before', async ({
  page,
}) => {
  await page.setViewportSize({ width: 900, height: 900 });
  const css = Object.entries(sizes)
    .map(([name, [, , rule = '']]) => `[id="${name}"] volume-view { ${rule} }`)
    .join('');
  const bodies = Object.entries(sizes).map(([name, [attributes]]) => [
    name,
    `<volume-view ${attributes}></volume-view>`,
  ]);
  await openBare(page, sections(Object.fromEntries(bodies)), `${apart}<style>${css}</style>`);
  expect(await boxes(page)).toEqual(
    Object.fromEntries(Object.entries(sizes).map(([name, [, expected]]) => [name, [expected]])),
  );
});

test('width and height are followed when a script changes them, as properties too', async ({ page }) => {
  await openBare(page, sections({ one: '<volume-view width="400" height="200"></volume-view>' }));
  const change = async (name: 'width' | 'height', value: number | null): Promise<number[][]> => {
    await withElement(
      page,
      async (element, [key, to]) => {
        element[key] = to;
        await element.updateComplete;
      },
      { argument: [name, value] as const },
    );
    return (await boxes(page)).one;
  };
  expect(await change('width', 300)).toEqual([[300, 200]]);
  expect(await change('height', null)).toEqual([[300, 225]]);
  expect(await change('width', null)).toEqual([[900, 675]]);
  expect(await withElement(page, ({ width, height }) => [width, height])).toEqual([null, null]);
});
