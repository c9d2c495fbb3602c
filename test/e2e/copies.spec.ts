// A page that has the script twice, or once with a version in its address: one copy holds, and nothing breaks.
import { readFileSync } from 'node:fs';
import type { Page } from '@playwright/test';
import { handles, editor, legend, view } from './helpers/companions.ts';
import { expect, open, settle, test, waitForEvent, withElement } from './helpers/harness.ts';

const { version } = JSON.parse(readFileSync('package.json', 'utf8')) as { version: string };
const asModule = '<script type="module" src="/dist/volume-view.js"></script>';
const asScript = '<script src="/dist/volume-view.iife.js"></script>';
const legendAlone = '<script type="module" src="/dist/volume-legend.js"></script>';
const warning = /^warning: <volume-view> of volume-view \S+ is left out: the page has 9\.9\.9 already\./;

async function expectAll(page: Page): Promise<void> {
  await settle(page);
  await expect(page.getByRole('img', { name: /^Strength/ })).toBeVisible();
  await expect(handles(page)).toHaveCount(3);
  expect(await withElement(page, (element) => element.shadowRoot!.querySelectorAll('canvas').length)).toBe(1);
}

for (const [what, script] of Object.entries({
  'as a classic script and as a module': asScript + asModule,
  'as two classic scripts': asScript + asScript.replace('.js', '.js?again'),
  'as two modules of two addresses': asModule + asModule.replace('.js', '.js?again'),
  'with a companion alone': legendAlone + asModule,
})) {
  test(`the same version twice, ${what}`, async ({ page, lines }) => {
    await open(page, view + legend + editor, { script });
    await expectAll(page);
    expect(lines.filter((line) => /volume-view/.test(line))).toEqual([]);
  });
}

// As a CMS writes addresses of scripts. For a browser, a module with a version is another one than that without.
for (const [what, script] of Object.entries({
  'a module': asModule,
  'a classic script': asScript,
  'companions alone': legendAlone + legendAlone.replace('legend', 'transfer-function') + asModule,
})) {
  test(`a version in the address of ${what}: one copy, its errors and its steps`, async ({ page }) => {
    await open(page, view + legend + editor, {
      script: script.replaceAll('.js"', '.js?ver=1.2"'),
    });
    await expectAll(page);
    expect(await withElement(page, (element) => element.renderStats?.steps)).toBe(20);
    await withElement(page, (element) => element.setAttribute('src', '/dist/volume-view.js'));
    expect((await waitForEvent(page, 'error')).detail).toMatchObject({ code: 'format/unknown' });
  });
}

test.describe('another version', () => {
  test.use({ allowedLines: warning });

  test('is reported once', async ({ page, lines }) => {
    await page.route('**/volume-view.iife.js', (route) =>
      route.fulfill({
        contentType: 'text/javascript',
        body: readFileSync('dist/volume-view.iife.js', 'utf8').replaceAll(version, '9.9.9'),
      }),
    );
    await open(page, view + legend + editor, { script: asScript + asModule });
    await expectAll(page);
    expect(lines.filter((line) => warning.test(line))).toHaveLength(1);
  });
});
