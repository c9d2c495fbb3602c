// What companions have in common: how they are loaded, how they find the volume, what axe says of them.
import type { Page } from '@playwright/test';
import { findFaults } from './helpers/axe.ts';
import {
  drag,
  editor,
  handle,
  handles,
  legend,
  middleOf,
  openEditor,
  readValues,
  said,
  view,
} from './helpers/companions.ts';
import {
  compare,
  expect,
  fieldUrl,
  open,
  settle,
  takePicture,
  keptTest as test,
  test as newPageTest,
  withElement,
} from './helpers/harness.ts';

test.describe('the loader', () => {
  const watch = (page: Page): string[] => {
    const paths: string[] = [];
    page.on('request', (request) => paths.push(new URL(request.url()).pathname));
    return paths;
  };

  newPageTest('loads nothing of the companions on a page without them', async ({ page }) => {
    const paths = watch(page);
    await open(page, view);
    await settle(page);
    expect(paths).toContain('/dist/volume-view.js');
    expect(paths.filter((path) => /legend|volume-transfer-function|ticks|link/.test(path))).toEqual([]);
    expect(
      await page.evaluate(() =>
        Boolean(customElements.get('volume-legend') ?? customElements.get('volume-transfer-function')),
      ),
    ).toBe(false);
  });

  newPageTest('loads one alone, once, for any number of them', async ({ page }) => {
    const paths = watch(page);
    await open(page, view + legend + legend);
    await expect(page.getByRole('img', { name: /^Strength/ })).toHaveCount(2);
    expect(paths.filter((path) => path.includes('volume-legend')).length).toBe(1);
    expect(paths.filter((path) => path.includes('volume-transfer-function'))).toEqual([]);
  });

  newPageTest('sees those that come later, deep in something, and within a volume', async ({ page }) => {
    await open(page, view);
    await settle(page);
    await page.evaluate(() => {
      const section = document.createElement('section');
      section.append(document.createElement('p'));
      section.firstChild!.appendChild(document.createElement('volume-legend'));
      document.body.append(section);
      document.querySelector('volume-view')!.append(document.createElement('volume-transfer-function'));
    });
    await expect(page.locator('volume-legend .legend')).toBeVisible();
    await expect.poll(() => page.evaluate(() => Boolean(customElements.get('volume-transfer-function')))).toBe(true);
  });

  newPageTest('and a picture that is waited for has what comes with those in it', async ({ page }) => {
    let isLate = false;
    await page.route(/volume-slice\W/, async (route) => {
      await new Promise((resolve) => setTimeout(resolve, 1500));
      isLate = true;
      await route.continue();
    });
    const sliced = (slice: string): string =>
      `<volume-view src="${fieldUrl}" opacity-factor="0.1" style="width: 60px; height: 45px" alt="A field">${slice}</volume-view>`;
    await open(page, sliced('<volume-slice type="axial"></volume-slice>'));
    const [first, later] = [await takePicture(page), await takePicture(page)];
    expect(isLate).toBe(true);
    expect(compare(first, later).worst).toBe(0);
    await page.locator('volume-slice').evaluate((slice) => slice.remove());
    expect(compare(await takePicture(page), first).worst).toBeGreaterThan(40);
  });

  newPageTest.describe('where a file does not come', () => {
    newPageTest.use({ allowedLines: /^error: (Failed to load resource|TypeError: )/ });

    newPageTest('a picture is not waited for', async ({ page, lines }) => {
      await page.route(/volume-slice\W/, (route) => route.abort());
      await open(
        page,
        `<volume-view src="${fieldUrl}" style="width: 60px; height: 45px" alt="A field"><volume-slice type="axial"></volume-slice></volume-view>`,
      );
      expect((await takePicture(page)).width).toBe(60);
      expect(lines.join()).toContain('volume-slice');
    });
  });

  newPageTest('works in the classic script too', async ({ page }) => {
    await open(page, view + legend + editor, { script: '<script defer src="/dist/volume-view.iife.js"></script>' });
    await expect(page.getByRole('img', { name: /^Strength/ })).toBeVisible();
    await expect(handles(page)).toHaveCount(3);
  });

  newPageTest('and under a strict Content-Security-Policy', async ({ page }) => {
    await open(page, view + editor.replace(/ style="[^"]*"/, '') + legend, {
      head: `<meta http-equiv="Content-Security-Policy" content="default-src 'self'">`,
    });
    await expect(handles(page)).toHaveCount(3);
    const [first, last] = [await middleOf(handle(page, 1)), await middleOf(handle(page, 3))];
    expect(last.x - first.x, 'handles are placed').toBeGreaterThan(200);
    expect(first.y - last.y).toBeGreaterThan(50);
  });
});

test.describe('finding the volume', () => {
  const words = (page: Page): Promise<string> =>
    page
      .locator('volume-legend')
      .evaluate((element) => (element.shadowRoot?.textContent ?? '').replace(/\s+/g, ' ').trim());

  test('whatever comes first, and whatever goes', async ({ page }) => {
    await open(page, '<volume-legend for="late" label="Late"></volume-legend>');
    await expect.poll(() => words(page)).toBe('There is no <volume-view id="late"> in this page.');
    await page.evaluate(() => {
      const later = document.createElement('volume-view');
      document.body.append(later);
      later.id = 'late';
    });
    await expect.poll(() => words(page)).toBe('No volume is loaded yet.');
    await withElement(page, (element, src) => void (element.src = src), { argument: fieldUrl });
    await expect(page.getByRole('img', { name: /^Late/ })).toBeVisible();
    await withElement(page, (element) => {
      element.src = null;
    });
    await expect.poll(() => words(page)).toBe('No volume is loaded yet.');
    await page.locator('volume-view').evaluate((element) => element.remove());
    await expect.poll(() => words(page)).toMatch(/^There is no/);
  });

  test('another one when `for` changes; without it, the nearest', async ({ page }) => {
    const other = view.replace('id="field"', 'id="other"').replace(said, '0 white 0, 77 white 5%');
    await open(
      page,
      `<section>${view}</section><section>${other}<p>${legend.replace(' for="field"', '')}</p></section>`,
    );
    const picture = page.getByRole('img', { name: /^Strength/ });
    await expect(picture).toHaveAccessibleName(/^Strength, 0 to 77/);
    const setFor = (id: string | null): Promise<void> =>
      page.locator('volume-legend').evaluate((element, name) => {
        if (name === null) element.removeAttribute('for');
        else element.setAttribute('for', name);
      }, id);
    await setFor('field');
    await expect(picture).toHaveAccessibleName(/^Strength, 0 to 200/);
    await setFor('nobody');
    await expect.poll(() => words(page)).toBe('There is no <volume-view id="nobody"> in this page.');
    await setFor(null);
    await expect(picture).toHaveAccessibleName(/^Strength, 0 to 77/);
  });

  test('taken out of the page it lets go of the volume; put back it holds it again', async ({ page }) => {
    await openEditor(page, view + legend + editor);
    await page.evaluate(() => {
      const counted = window as unknown as { listeners: number };
      counted.listeners = 0;
      const element = document.querySelector('volume-view')!;
      const [add, remove] = [element.addEventListener.bind(element), element.removeEventListener.bind(element)];
      Object.assign(element, {
        addEventListener: (...args: Parameters<typeof add>) => (counted.listeners++, add(...args)),
        removeEventListener: (...args: Parameters<typeof remove>) => (counted.listeners--, remove(...args)),
      });
    });
    const listeners = (): Promise<number> =>
      page.evaluate(() => (window as unknown as { listeners: number }).listeners);
    await page.evaluate(() => {
      const kept = [...document.querySelectorAll('volume-legend, volume-transfer-function')];
      kept.forEach((element) => element.remove());
      Object.assign(window, { kept });
    });
    expect(await listeners()).toBe(-5); // three events of the legend, two of the editor
    await page.evaluate(() => document.body.append(...(window as unknown as { kept: Element[] }).kept));
    expect(await listeners()).toBe(0);
    await expect(handles(page)).toHaveCount(3);
    await drag(page, handle(page, 2), { x: 30, y: 0 });
    await expect.poll(() => readValues(page).then(([, value]) => value)).toBeGreaterThan(105);
  });
});

for (const scheme of ['light', 'dark'] as const) {
  test.describe(`axe, ${scheme}`, () => {
    test.use({ colorScheme: scheme, viewport: { width: 320, height: 700 } });
    const head = '<meta name="viewport" content="width=device-width"><style>:root { color-scheme: light dark }</style>';

    for (const [what, body] of Object.entries({
      stops: view + editor.replace('400px', '100%') + legend,
      bands:
        view + editor.replace('400px"', '100%" mode="bands"') + legend.replace('label', 'orientation="vertical" label'),
      nothing: '<volume-transfer-function></volume-transfer-function><volume-legend></volume-legend>',
    })) {
      test(`finds nothing: ${what}; nothing is wider than a phone`, async ({ page }) => {
        await open(page, `<main><h1>A volume</h1>${body}</main>`, { head });
        await expect(
          page.locator('volume-transfer-function').locator(what === 'nothing' ? '.hint' : '.editor'),
        ).toBeVisible();
        await expect(page.locator('volume-legend').locator(what === 'nothing' ? '.hint' : '.legend')).toBeVisible();
        if (what !== 'nothing') await settle(page);
        expect(await findFaults(page)).toEqual([]);
        expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(320);
      });
    }
  });
}
