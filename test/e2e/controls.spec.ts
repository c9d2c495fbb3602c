// The controls over a picture: what they do, by mouse and by keys, and where they are left out.
import type { Locator, Page } from '@playwright/test';
import type { registerTranslation } from '../../src/index.ts';
import { findFaults } from './helpers/axe.ts';
import {
  expect,
  fewPixels,
  fieldUrl,
  keptTest as test,
  networkLines,
  open,
  setAttributes,
  settle,
  test as newPageTest,
  waitForEvent,
  withElement,
} from './helpers/harness.ts';
import { attributesOf } from './helpers/reference.ts';
import { expectShown, listed, look, serve } from './helpers/scans.ts';

test.use(fewPixels);

const large = { head: '<style>volume-view { width: 320px; height: 240px }</style>' };
const view = (more = ''): string =>
  `<main><h1>A field</h1><volume-view src="${fieldUrl}" ${attributesOf({ steps: '10' })} controls alt="A field" ${more}></volume-view></main>`;
const button = (page: Page, name: string): Locator =>
  page.locator('volume-view').getByRole('button', { name, exact: true });

async function openView(page: Page, more = ''): Promise<void> {
  await open(page, view(more), large);
  await settle(page);
  await expect(page.locator('volume-view').getByRole('group', { name: 'Controls of the picture' })).toBeVisible();
}

/** Degrees. */
async function orbitOf(page: Page): Promise<{ theta: number; phi: number }> {
  const { detail } = await waitForEvent(page, 'camera-change');
  await settle(page);
  const last = await page.evaluate(() => window.__seen.filter(({ type }) => type === 'camera-change').at(-1)!.detail);
  const { orbit } = (last ?? detail) as { orbit: { theta: number; phi: number } };
  return { theta: (orbit.theta * 180) / Math.PI, phi: (orbit.phi * 180) / Math.PI };
}

newPageTest('they are not there, and not loaded, without the attribute; and they go with it', async ({ page }) => {
  const loaded: string[] = [];
  page.on('request', (request) => loaded.push(request.url()));
  await open(page, view().replace('controls', ''), large);
  await settle(page);
  expect(loaded.filter((url) => url.includes('view-controls'))).toEqual([]);
  await expect(page.locator('volume-view').getByRole('button')).toHaveCount(0);
  await setAttributes(page, { controls: '' });
  await expect(button(page, 'Views')).toBeVisible();
  await setAttributes(page, { controls: null });
  await expect(page.locator('volume-view').getByRole('button')).toHaveCount(0);
});

test('axe finds nothing in them, open and closed; each is 44 pixels large', async ({ page }) => {
  await openView(page);
  expect(await findFaults(page)).toEqual([]);
  for (const name of ['Views', 'More']) {
    await button(page, name).click();
    await expect(button(page, name)).toHaveAttribute('aria-expanded', 'true');
    expect(await findFaults(page)).toEqual([]);
  }
  for (const box of await page
    .locator('volume-view')
    .getByRole('button')
    .evaluateAll((all) => all.map((one) => one.getBoundingClientRect()))) {
    expect(Math.round(Math.min(box.width, box.height))).toBeGreaterThanOrEqual(44);
  }
});

test('standard views turn the picture the short way, and the first view comes back', async ({ page }) => {
  await openView(page);
  await button(page, 'Views').click();
  await button(page, 'Left').click();
  const left = await orbitOf(page);
  expect(left.theta).toBeCloseTo(90, 3);
  expect(left.phi).toBeCloseTo(90, 3);
  await button(page, 'Top').click();
  await expect.poll(async () => Math.round((await orbitOf(page)).phi)).toBe(0);
  const before = await withElement(page, (element) => element.getAttribute('camera-orbit'));
  await button(page, 'First view').click();
  await settle(page);
  expect(
    await withElement(page, (element) => element.getAttribute('camera-orbit')),
    "attributes stay the author's",
  ).toBe(before);
});

test('by keys alone: tab, enter, escape', async ({ page }) => {
  await openView(page);
  await page.locator('volume-view').getByRole('img').focus();
  await page.keyboard.press('Tab');
  await expect(button(page, 'Views')).toBeFocused();
  await page.keyboard.press('Enter');
  await expect(button(page, 'Front')).toBeVisible();
  await page.keyboard.press('Shift+Tab');
  await expect(button(page, 'Bottom')).toBeFocused();
  await page.keyboard.press('Enter');
  expect((await orbitOf(page)).phi).toBeCloseTo(180, 3);
  await page.keyboard.press('Escape');
  await expect(button(page, 'Front')).toHaveCount(0);
  await expect(button(page, 'Views')).toBeFocused();
});

newPageTest('a press elsewhere closes what is open; the hint goes when the picture is turned', async ({ page }) => {
  await openView(page);
  const hint = page.locator('volume-view').locator('.hint');
  await expect(hint).toHaveText('Drag to turn. After a click, the wheel zooms.');
  await button(page, 'Views').click();
  await page.mouse.click(60, 140);
  await expect(button(page, 'Front')).toHaveCount(0);
  await expect(hint).toBeVisible();
  await page.mouse.move(100, 140);
  await page.mouse.down();
  await page.mouse.move(140, 140, { steps: 4 });
  await page.mouse.up();
  await expect(hint).toHaveCount(0);
});

test('the picture is saved under the name of its file', async ({ page }) => {
  await openView(page);
  await button(page, 'More').click();
  const [download] = await Promise.all([page.waitForEvent('download'), button(page, 'Save the picture').click()]);
  expect(download.suggestedFilename()).toBe('field.nii.png');
});

newPageTest('the view is copied as attributes that give the same view', async ({ page, context }) => {
  await context.grantPermissions(['clipboard-read', 'clipboard-write']);
  await openView(page);
  await button(page, 'Views').click();
  await button(page, 'Right').click();
  await orbitOf(page);
  await button(page, 'More').click();
  await button(page, 'Copy this view').click();
  await expect(page.locator('volume-view').getByText('Copied: the attributes of this view.')).toBeVisible();
  const text = await page.evaluate(() => navigator.clipboard.readText());
  expect(text).toMatch(/camera-orbit="-?90deg 90deg /);
  await page.evaluate(
    ([markup, src]) =>
      document
        .querySelector('main')!
        .insertAdjacentHTML('beforeend', `<volume-view id="other" src="${src}" ${markup}></volume-view>`),
    [text, fieldUrl],
  );
  await settle(page, '#other');
  const [eye, other] = await page.evaluate(() =>
    [...document.querySelectorAll('volume-view')].map(({ camera }) => camera!.eye),
  );
  for (const axis of [0, 1, 2]) expect(other[axis]).toBeCloseTo(eye[axis], 3);
});

newPageTest('where the page may not copy, the attributes stand in a field', async ({ page }) => {
  await openView(page);
  await page.evaluate(() => Object.defineProperty(navigator, 'clipboard', { value: undefined }));
  await button(page, 'More').click();
  await button(page, 'Copy this view').click();
  await expect(page.locator('volume-view').getByRole('textbox')).toHaveValue(/camera-orbit="/);
});

test('full screen fills the screen, and back', async ({ page }) => {
  await openView(page);
  await button(page, 'Full screen').click();
  await expect(button(page, 'Leave full screen')).toBeVisible();
  const shares = await withElement(page, (element) => [
    element.clientWidth / innerWidth,
    element.clientHeight / innerHeight,
  ]);
  expect(shares).toEqual([1, 1]);
  await button(page, 'Leave full screen').click();
  await expect(button(page, 'Full screen')).toBeVisible();
});

test('a frame that does not allow full screen has no button for it', async ({ page }) => {
  await page.route('**/inner-controls.html', (route) =>
    route.fulfill({
      contentType: 'text/html',
      body: `<!doctype html><html lang="en"><script type="module" src="/dist/volume-view.js"></script>${view()}</html>`,
    }),
  );
  await open(
    page,
    '<iframe width="520" height="420" title="Inner" allow="fullscreen \'none\'" src="/test/e2e/pages/inner-controls.html"></iframe>',
  );
  const inner = page.frameLocator('iframe').locator('volume-view');
  await expect(inner.getByRole('button', { name: 'Views' })).toBeVisible();
  await expect(inner.getByRole('button', { name: 'Full screen' })).toHaveCount(0);
});

test('controlslist leaves some out', async ({ page }) => {
  await openView(page, 'controlslist="noviews NOSAVE nocopy nohelp nohint nozoom noembed"');
  await expect(page.locator('volume-view').getByRole('button')).toHaveCount(2);
  await expect(page.locator('volume-view').locator('.hint')).toHaveCount(0);
});

test('zoom buttons bring the camera nearer and back, no farther than it may go', async ({ page }) => {
  await openView(page);
  const radius = (): Promise<number> =>
    settle(page).then(() => withElement(page, ({ camera }) => camera!.orbit.radius));
  const first = await radius();
  await page.locator('.picture').press('ArrowLeft');
  await button(page, 'Zoom in').click();
  expect(await radius()).toBeCloseTo(first / 1.25, 4);
  await button(page, 'Zoom out').click();
  expect(await radius()).toBeCloseTo(first, 4);
  for (let i = 0; i < 12; i++) await button(page, 'Zoom out').click();
  const { far, target } = await withElement(page, async (element) => {
    await element.whenRendered();
    return { far: element.camera!.orbit.radius, target: element.camera!.target };
  });
  // Four times the distance at which 0.68 of the sphere around the 24 x 30 x 32 mm of the field just fits.
  expect(far).toBeCloseTo((4 * 0.68 * Math.hypot(12, 15, 16)) / Math.sin((16 * Math.PI) / 180), 3);
  expect(Math.hypot(...target)).toBeLessThan(1e-6);
});

newPageTest(
  'the code of a frame shows the same view in another page, with its legend and timeline',
  async ({ page, context }) => {
    await context.grantPermissions(['clipboard-read', 'clipboard-write']);
    await open(
      page,
      `<main>${view('max-camera-orbit="auto auto 200%" title="Not this" id="field"')}</main><volume-legend for="field"></volume-legend>`,
      large,
    );
    await settle(page);
    await withElement(page, (element) => {
      element.alt = 'A "field" & <more>';
      element.src = `./data/../data/field.nii.gz?a=b&c=%20d`;
      return element.whenRendered();
    });
    await button(page, 'Views').click();
    await button(page, 'Right').click();
    await settle(page);
    await button(page, 'More').click();
    await button(page, 'Copy embed code').click();
    await expect(page.locator('volume-view').getByText('Copied: the code of a frame with this view.')).toBeVisible();
    const code = await page.evaluate(() => navigator.clipboard.readText());
    const frame = await page.evaluate((html) => {
      const { content } = Object.assign(document.createElement('template'), { innerHTML: html });
      const [{ src, title, width, height }, count] = [
        content.querySelector('iframe')!,
        content.querySelectorAll('*').length,
      ];
      return { src, title, width, height, count };
    }, code);
    const legend = await page.locator('volume-legend').evaluate((one) => (one as HTMLElement).offsetHeight);
    expect(frame).toMatchObject({
      title: 'A "field" & <more>',
      width: '320',
      height: String(240 + legend + 16),
      count: 1,
    });
    expect(frame.src).not.toMatch(/[ +<"]/);
    const address = new URL(frame.src);
    expect(address.pathname).toBe('/dist/embed.html');
    const given = Object.fromEntries(address.searchParams);
    expect(given.src).toBe(new URL('/test/e2e/pages/data/field.nii.gz?a=b&c=%20d', page.url()).href);
    expect(given).toMatchObject({ steps: '10', controls: '', legend: '', 'max-camera-orbit': 'auto auto 200%' });
    expect(Object.keys(given)).not.toEqual(expect.arrayContaining(['id']));
    expect(Object.keys(given)).not.toContain('title');
    expect(Object.keys(given)).not.toContain('timeline');
    const eye = await withElement(page, ({ camera }) => camera!.eye);
    await page.goto(frame.src);
    await settle(page);
    const other = await withElement(page, ({ camera }) => camera!.eye);
    for (const axis of [0, 1, 2]) expect(other[axis]).toBeCloseTo(eye[axis], 3);
    await expect(page.locator('volume-legend')).toHaveCount(1);
  },
);

test.describe('where the page for frames is not', () => {
  test.use({ allowedLines: networkLines });

  test('a sentence says which files are missing and where', async ({ page }) => {
    await page.route('**/embed.html', (route) => route.fulfill({ status: 404, body: '' }));
    await openView(page);
    await button(page, 'More').click();
    await button(page, 'Copy embed code').click();
    await expect(page.locator('volume-view').getByRole('alert')).toContainText(
      /There is no page for frames at http.*\/dist\/embed.html\./,
    );
  });
});

test("what lies on a person's own computer has no code for other pages", async ({ page }) => {
  await openView(page);
  await withElement(page, async (element) => {
    element.src = URL.createObjectURL(await (await fetch(element.src!)).blob());
    await element.whenRendered();
  });
  await button(page, 'More').click();
  await expect(button(page, 'Save the picture')).toBeVisible();
  await expect(button(page, 'Copy embed code')).toHaveCount(0);
});

test('with a timeline in the page there is one button for playing', async ({ page }) => {
  await serve(page, { manifest: listed(3) });
  await open(
    page,
    `<volume-view src="/scans/list.json" ${look} controls play-speed="0.5" alt="Scans"></volume-view><volume-timeline></volume-timeline>`,
    large,
  );
  await settle(page);
  await expect(page.locator('volume-timeline').getByRole('button', { name: 'Play' })).toBeVisible();
  await expect(button(page, 'Views')).toBeVisible();
  await expect(button(page, 'Play')).toHaveCount(0);
  await page.locator('volume-timeline').evaluate((element) => element.remove());
  await withElement(page, (element) => element.requestUpdate());
  await expect(button(page, 'Play')).toBeVisible();
});

test('scans are played and paused', async ({ page }) => {
  await serve(page, { manifest: listed(3) });
  await open(
    page,
    `<volume-view src="/scans/list.json" ${look} controls play-speed="0.5" alt="Scans"></volume-view>`,
    large,
  );
  await settle(page);
  await button(page, 'Play').click();
  await expect(button(page, 'Pause')).toBeVisible();
  await expectShown(page, 1);
  await button(page, 'Pause').click();
  await expect(button(page, 'Play')).toBeVisible();
});

newPageTest('they speak the language that the page gives them, and follow it', async ({ page }) => {
  await open(page, `<section lang="xx-test">${view()}</section>`, large);
  await page.evaluate(async (url: string) => {
    const part = (await import(url)) as { registerTranslation: typeof registerTranslation };
    part.registerTranslation('xx', {
      controls: 'Regler',
      views: 'Ansichten',
      more: 'Mehr',
      help: 'Hilfe',
      mouseHint: 'Ziehen dreht.',
      view: {
        front: 'Vorn',
        back: 'Hinten',
        left: 'Linke Seite',
        right: 'Rechte Seite',
        top: 'Oben',
        bottom: 'Unten',
        south: 'S',
        north: 'N',
        west: 'W',
        east: 'O',
        above: 'Darüber',
      },
      helpLines: [['Drehen', 'Ziehen']],
    });
  }, '/dist/volume-view.js');
  await settle(page);
  const element = page.locator('volume-view');
  await expect(element.getByRole('group', { name: 'Regler' })).toBeVisible();
  await expect(element.locator('.hint')).toHaveText('Ziehen dreht.');
  await button(page, 'Ansichten').click();
  await button(page, 'Linke Seite').click();
  expect((await orbitOf(page)).theta).toBeCloseTo(90, 3);
  await button(page, 'Mehr').click();
  await expect(button(page, 'Save the picture'), 'English for what it lacks').toBeVisible();
  await button(page, 'Hilfe').click();
  await expect(element.getByRole('status', { name: 'Hilfe' })).toContainText('Drehen');
  await page.locator('section').evaluate((section) => section.setAttribute('lang', 'en'));
  await expect(element.getByRole('group', { name: 'Controls of the picture' })).toBeVisible();
  await expect(element.getByRole('status', { name: 'Help' })).toContainText('Drag with the right button');
});

test('all of them are reached and used by keys alone', async ({ page }) => {
  await openView(page);
  await page.locator('volume-view').getByRole('img').focus();
  await page.keyboard.press('ArrowLeft'); // With the hint, there is no room for all.
  await settle(page);
  for (const name of ['Views', 'Zoom in', 'Zoom out', 'First view', 'Full screen', 'More']) {
    await page.keyboard.press('Tab');
    await expect(button(page, name)).toBeFocused();
    expect(await button(page, name).evaluate((one) => getComputedStyle(one).outlineStyle), 'the focus is seen').toBe(
      'solid',
    );
  }
  await page.keyboard.press('Space');
  for (const name of ['Help', 'Copy embed code', 'Copy this view', 'Save the picture']) {
    await page.keyboard.press('Shift+Tab');
    if (name === 'Help') for (let i = 0; i < 5; i++) await page.keyboard.press('Shift+Tab'); // Past the bar.
    await expect(button(page, name)).toBeFocused();
  }
  const [download] = await Promise.all([page.waitForEvent('download'), page.keyboard.press('Enter')]);
  expect(download.suggestedFilename()).toBe('field.nii.png');
});

test.describe('next to an error', () => {
  test.use({ allowedLines: networkLines });

  test('they are not covered by it, and work on the picture that stays', async ({ page }) => {
    await openView(page);
    await withElement(page, (element) => (element.src = 'nowhere.nii'));
    const alert = page.locator('volume-view').getByRole('alert');
    await expect(alert.getByRole('button', { name: 'Try again' })).toBeVisible();
    await button(page, 'Views').click();
    await button(page, 'Left').click();
    await expect.poll(() => withElement(page, ({ cameraOrbit }) => cameraOrbit)).toMatch(/^90deg 90deg /);
    expect(await findFaults(page)).toEqual([]);
  });
});

test.describe('with fingers', () => {
  test.use({ hasTouch: true, viewport: { width: 390, height: 844 }, isMobile: true });

  newPageTest(
    "hint and bar take less than a fifth of the picture's height, in one row, and buttons stay 44 pixels large",
    async ({ page }) => {
      await open(
        page,
        `<div style="padding: 16px">${view().replace('<main><h1>A field</h1>', '').replace('</main>', '')}</div>`,
        {
          head: '<meta name="viewport" content="width=device-width"><style>volume-view { width: 358px; height: auto }</style>',
        },
      );
      await settle(page);
      const element = page.locator('volume-view');
      await expect(element.locator('.hint')).toHaveText('One finger turns, two fingers move and zoom.');
      const measure = (): Promise<{ share: number; min: number; cut: boolean }> =>
        withElement(page, (view) => {
          const around = view.getBoundingClientRect();
          const parts = [...view.shadowRoot!.querySelectorAll('.hint, .bar')].map((part) =>
            part.getBoundingClientRect(),
          );
          const buttons = [...view.shadowRoot!.querySelectorAll('.bar button')]
            .map((one) => one.getBoundingClientRect())
            .filter(({ width }) => width > 0);
          const hint = view.shadowRoot!.querySelector('.hint');
          return {
            share: (around.bottom - Math.min(...parts.map(({ top }) => top))) / around.height,
            min: Math.min(...buttons.flatMap(({ width, height }) => [width, height])),
            cut: hint !== null && (hint.scrollHeight > hint.clientHeight || hint.scrollWidth > hint.clientWidth),
          };
        });
      expect(await measure()).toMatchObject({ min: 44, cut: false });
      expect((await measure()).share).toBeLessThan(0.2);
      await element.locator('.picture').press('ArrowLeft');
      await expect(element.locator('.hint')).toHaveCount(0);
      await expect(button(page, 'First view')).toBeVisible();
      expect((await measure()).share).toBeLessThan(0.2);
    },
  );
});

for (const colorScheme of ['light', 'dark'] as const) {
  for (const dir of ['ltr', 'rtl'] as const) {
    newPageTest(
      `on a phone, ${colorScheme}, ${dir}: they stay within a small picture, and axe finds nothing`,
      async ({ page }) => {
        await page.emulateMedia({ colorScheme });
        await page.setViewportSize({ width: 390, height: 700 });
        await open(page, `<div dir="${dir}">${view()}</div>`, {
          head: '<style>:root { color-scheme: light dark } volume-view { width: 240px; height: 200px }</style>',
        });
        await settle(page);
        for (const name of [null, 'Views', 'More', 'Help']) {
          if (name) await button(page, name).click();
          expect(await findFaults(page)).toEqual([]);
          const outside = await withElement(page, (element) => {
            const around = element.getBoundingClientRect();
            const parts = [...element.shadowRoot!.querySelectorAll('.controls > *')].map((part) =>
              part.getBoundingClientRect(),
            );
            return parts.filter(
              ({ left, right, top, bottom }) =>
                left < around.left || right > around.right || top < around.top || bottom > around.bottom,
            ).length;
          });
          expect(outside, `${name}`).toBe(0);
        }
      },
    );
  }
}
