// <volume-slice-view>: panes with slices, alone and beside a <volume-view>, by mouse, touch and keys.
import type { Page } from '@playwright/test';
import type { VolumeSliceView } from '../../components/volume-slice-view/volume-slice-view.ts';
import { findFaults } from './helpers/axe.ts';
import {
  expect,
  fieldUrl,
  networkLines,
  open,
  settle,
  takeScreenshot,
  keptTest as test,
  test as newPageTest,
} from './helpers/harness.ts';

const head = '<style>volume-slice-view { width: 240px } main { display: flex; flex-wrap: wrap }</style>';
const phantom = '/demos/data/ct-phantom.nii.gz';
const inPage = (body: string): string => `<main><h1>Slices</h1>${body}</main>`;
const alone = (attributes = ''): string =>
  inPage(`<volume-slice-view id="a" src="${phantom}" ${attributes}></volume-slice-view>`);
const script = '<script type="module" src="/dist/volume-slice-view.js"></script>';

/** Run a function with a pane once its picture is there. */
async function withPane<R>(page: Page, selector: string, act: (pane: VolumeSliceView) => R | Promise<R>): Promise<R> {
  await page.evaluate(() => customElements.whenDefined('volume-slice-view').then(() => true));
  await page.locator(selector).evaluate((pane) => (pane as unknown as VolumeSliceView).whenRendered());
  return page.locator(selector).evaluate(act as never);
}

const textOf = (page: Page, selector: string, part: string): Promise<string> =>
  withPane(page, selector, () => undefined).then(
    async () => (await page.locator(`${selector} [part=${part}]`).textContent()) ?? '',
  );
const cursorOf = (page: Page, selector = '#a'): Promise<readonly number[] | null> =>
  withPane(page, selector, (pane) => pane.cursor);

/** Grey at a place of a pane, CSS pixels; beside the crosshair. */
async function grayAt(page: Page, selector: string, x: number, y: number): Promise<number> {
  await withPane(page, selector, () => undefined);
  const { width, data } = await takeScreenshot(page, selector);
  return data[4 * (y * width + x)];
}

async function middleOf(page: Page, selector = '#a'): Promise<{ x: number; y: number }> {
  const box = (await page.locator(selector).boundingBox())!;
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
}

test.describe('a pane that stands alone', () => {
  newPageTest('shows a CT as radiology does, and loads neither x3dom nor a <volume-view>', async ({ page }) => {
    const asked: string[] = [];
    page.on('request', (request) => asked.push(new URL(request.url()).pathname));
    await page.addInitScript(() => {
      const { getContext } = HTMLCanvasElement.prototype;
      HTMLCanvasElement.prototype.getContext = function (this: HTMLCanvasElement, ...args: unknown[]) {
        if (String(args[0]).startsWith('webgl')) console.error('a WebGL context was asked for');
        return Reflect.apply(getContext, this, args) as never;
      } as never;
    });
    await open(page, alone(), { head, script });
    expect(await textOf(page, '#a', 'window')).toBe('W 400  L 40');
    expect(await page.locator('#a [part=side]').allTextContents()).toEqual(['R', 'L', 'A', 'P']);
    expect(await textOf(page, '#a', 'scale')).toBe('100 mm');
    expect(await grayAt(page, '#a', 30, 60), 'air is black').toBe(0);
    expect(await page.locator('#a [part=picture]').getAttribute('aria-label')).toMatch(/^Axial slice, [SI] [\d.]+ mm$/);
    expect(asked.filter((path) => /x3dom|volume-view\.js|ray-caster/.test(path))).toEqual([]);
    expect(asked.filter((path) => path === phantom).length, 'loaded once').toBe(1);
    expect(await findFaults(page)).toEqual([]);
  });

  test('goes where its attributes say, and not elsewhere: sides, slabs, oblique ones, nearest voxels', async ({
    page,
  }) => {
    await open(
      page,
      alone(
        'type="sagittal" at="-40" thickness="20" projection="max" interpolation="nearest" value-window="0 1000" window-function="linear"',
      ),
      { head, script },
    );
    expect(await textOf(page, '#a', 'place')).toContain('L 40 mm');
    expect(await textOf(page, '#a', 'place')).toContain('maximum of 20 mm');
    expect(await page.locator('#a [part=side]').allTextContents()).toEqual(['A', 'P', 'S', 'I']);
    await page.locator('#a').evaluate((pane) => pane.setAttribute('at', '1e6'));
    const far = (await cursorOf(page))![0];
    expect(far, 'the last slice there is').toBeLessThan(400);
    await page.locator('#a').evaluate((pane) => {
      pane.setAttribute('type', 'oblique');
      pane.setAttribute('normal', '1 1 0');
      pane.setAttribute('cursor', '10 -20 30');
    });
    expect(await cursorOf(page)).toEqual([10, -20, 30]);
    expect(
      (await page.locator('#a [part=side]').allTextContents()).map((side) =>
        side.length === 2 ? [side, side[1] + side[0]].find((both) => /^[RL]/.test(both)) : side,
      ),
    ).toEqual(['LA', 'RP', 'S', 'I']);
  });

  test('moves by mouse: crosshair, slices, window, size', async ({ page }) => {
    await open(page, alone(), { head, script });
    const before = (await cursorOf(page))!;
    const { x, y } = await middleOf(page);
    await page.mouse.move(x, y);
    await page.mouse.wheel(0, 240);
    expect(await cursorOf(page), 'a wheel before a press scrolls the page').toEqual(before);
    await page.mouse.down();
    await page.mouse.move(x + 24, y - 12);
    await page.mouse.up();
    const pointed = (await cursorOf(page))!;
    expect(pointed[0], "right in the picture is the patient's left").toBeLessThan(before[0] - 5);
    expect(pointed[1], 'up in it is the front').toBeGreaterThan(before[1] + 5);
    expect(pointed[2]).toBe(before[2]);
    await page.mouse.wheel(0, 240);
    expect((await cursorOf(page))![2], 'four slices down').toBeLessThan(before[2] - 5);
    const gray = await grayAt(page, '#a', 132, 100);
    await page.mouse.down({ button: 'right' });
    await page.mouse.move(x - 100, y - 80);
    await page.mouse.up({ button: 'right' });
    expect(await textOf(page, '#a', 'window')).not.toBe('W 400  L 40');
    expect(await grayAt(page, '#a', 132, 100)).not.toBe(gray);
    const bar = await page.locator('#a .bar').evaluate((element) => element.clientWidth);
    await page.keyboard.down('Control');
    await page.mouse.wheel(0, -450);
    await page.keyboard.up('Control');
    await withPane(page, '#a', () => undefined);
    expect(await textOf(page, '#a', 'scale'), `a bar of 100 mm was ${bar} wide`).not.toBe('100 mm');
    await page.mouse.dblclick(x, y);
    expect(await textOf(page, '#a', 'scale')).toBe('100 mm');
    expect(await textOf(page, '#a', 'window')).toBe('W 400  L 40');
  });

  test('lets the page scroll at the last slice, and a double click leaves slice and crosshair alone', async ({
    page,
  }) => {
    await open(page, `${alone()}<div style="height: 3000px"></div>`, { head, script });
    const { x, y } = await middleOf(page);
    await page.mouse.click(x + 20, y - 15);
    const before = (await cursorOf(page))!;
    await page.mouse.move(x, y);
    await page.mouse.down({ button: 'right' });
    await page.mouse.move(x - 60, y);
    await page.mouse.up({ button: 'right' });
    await page.mouse.dblclick(x - 50, y + 40);
    expect(await cursorOf(page), 'where it was before the double click').toEqual(before);
    expect(await textOf(page, '#a', 'window')).toBe('W 400  L 40');
    await page.mouse.dblclick(x + 50, y + 40);
    expect(await cursorOf(page), 'and before another').toEqual(before);
    await page.mouse.click(x - 50, y + 40);
    expect(await cursorOf(page), 'a click alone moves it').not.toEqual(before);
    for (const [key, wheel] of [
      ['End', -240],
      ['Home', 240],
    ] as const) {
      await page.keyboard.press(key);
      await page.evaluate(() => scrollTo(0, 100));
      const last = (await cursorOf(page))!;
      const box = await middleOf(page);
      await page.mouse.move(box.x, box.y);
      await page.mouse.down();
      await page.mouse.up();
      await page.mouse.wheel(0, wheel);
      await expect.poll(() => page.evaluate(() => scrollY), key).not.toBe(100);
      expect((await cursorOf(page))![2]).toBe(last[2]);
      // The other way there are slices.
      const scrolled = await page.evaluate(async () => {
        scrollTo(0, 0);
        await new Promise((resolve) => setTimeout(resolve, 300));
        return scrollY;
      });
      const again = await middleOf(page);
      await page.mouse.click(again.x, again.y);
      await page.mouse.wheel(0, -wheel);
      await expect.poll(async () => (await cursorOf(page))![2]).not.toBe(last[2]);
      expect(await page.evaluate(() => scrollY)).toBe(scrolled);
    }
  });

  test('says what its window is in words, to a mouse and to a screen reader', async ({ page }) => {
    await open(page, alone(), { head, script });
    expect(await textOf(page, '#a', 'window')).toBe('W 400  L 40');
    const words = 'Window 400, level 40: black up to −160, white from 240';
    await expect(page.locator('#a [part=window]')).toHaveAttribute('title', words);
    const described = await page.locator('#a [part=picture]').evaluate((picture) =>
      picture
        .getAttribute('aria-describedby')!
        .split(' ')
        .map((id) => (picture.getRootNode() as ShadowRoot).getElementById(id)!.textContent),
    );
    expect(described[0]).toBe(words);
    // Over the words too a click is the pane's.
    const box = (await page.locator('#a [part=window]').boundingBox())!;
    const before = await cursorOf(page);
    await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
    expect(await cursorOf(page)).not.toEqual(before);
  });

  newPageTest('has its picture when whenRendered() says so, however late its size is known', async ({ page }) => {
    // What an observer tells comes a second late: the picture does not wait for it.
    await page.addInitScript(() => {
      const Original = window.ResizeObserver;
      window.ResizeObserver = class extends Original {
        constructor(callback: ResizeObserverCallback) {
          super((...args) => setTimeout(() => callback(...args), 1000));
        }
      };
    });
    await open(page, alone(), { head, script });
    const painted = await page.evaluate(async () => {
      await customElements.whenDefined('volume-slice-view');
      const pane = document.querySelector('volume-slice-view')!;
      const counts: number[] = [];
      const count = (one: typeof pane): number => {
        const canvas = one.shadowRoot!.querySelector('canvas')!;
        return canvas
          .getContext('2d')!
          .getImageData(0, 0, canvas.width, canvas.height)
          .data.filter((value, i) => i % 4 < 3 && value > 0).length;
      };
      await pane.whenRendered();
      counts.push(count(pane));
      // Of a file that is there already.
      const other = pane.cloneNode() as typeof pane;
      other.id = 'b';
      pane.after(other);
      await other.whenRendered();
      counts.push(count(other));
      return counts;
    });
    expect(painted[0]).toBeGreaterThan(1000);
    expect(painted[1]).toBe(painted[0]);
  });

  test('moves by keys, says so, and swaps the buttons', async ({ page }) => {
    await open(page, alone('drag="window"'), { head, script });
    const before = (await cursorOf(page))!;
    await page.locator('#a [part=picture]').focus();
    for (const key of ['PageUp', 'PageUp', 'ArrowLeft', 'ArrowDown', 'Shift+ArrowRight'])
      await page.keyboard.press(key);
    const after = (await cursorOf(page))!;
    expect(after[2]).toBeGreaterThan(before[2]);
    expect(after[1]).toBeLessThan(before[1]);
    expect((before[0] - after[0]) / (before[1] - after[1]), 'one to the left and ten to the right').toBeCloseTo(9, 6);
    await expect(page.locator('#a [role=status]')).toHaveText(/^[SI] [\d.]+ mm: (−?[\d.]+ HU|−?[\d.]+)$/);
    await page.keyboard.press('End');
    const last = (await cursorOf(page))![2];
    await page.keyboard.press('PageUp');
    expect((await cursorOf(page))![2]).toBe(last);
    await page.keyboard.press('Tab');
    await page.keyboard.press('ArrowLeft');
    expect((await cursorOf(page))![2], 'the slider goes through them too').toBeLessThan(last);
    const { x, y } = await middleOf(page);
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + 60, y);
    await page.mouse.up();
    expect(await textOf(page, '#a', 'window')).not.toBe('W 400  L 40');
  });

  test.describe('in error', () => {
    test.use({ allowedLines: networkLines });

    test('says what is wrong, keeps the last good picture, and goes on', async ({ page }) => {
      await open(page, alone(), { head, script });
      const cursor = await cursorOf(page);
      const gray = await grayAt(page, '#a', 132, 100);
      expect(gray).toBeGreaterThan(0);
      await page.evaluate(() => {
        const pane = document.querySelector('#a')!;
        const codes: unknown[] = ((window as never as { codes: unknown[] }).codes = []);
        pane.addEventListener('error', (event) => codes.push((event as CustomEvent<{ code: string }>).detail.code));
        pane.setAttribute('type', 'diagonal');
      });
      await expect(page.getByRole('alert')).toContainText('axial or coronal or sagittal or oblique');
      expect(await grayAt(page, '#a', 132, 100)).toBe(gray);
      for (const [name, value, said] of [
        ['normal', '0 0 0', 'may not be 0 0 0'],
        ['thickness', '-3', 'a number from 0'],
        ['at', 'top', 'a place along'],
        ['value-window', '5 1', 'lower value first'],
        ['src', 'nowhere.nii', '404'],
      ] as const) {
        await page.locator('#a').evaluate(
          (pane, [key, text]) => {
            for (const other of ['type', 'normal', 'thickness', 'at', 'value-window']) pane.removeAttribute(other);
            pane.setAttribute(key, text);
          },
          [name, value] as const,
        );
        await expect(page.getByRole('alert'), name).toContainText(said);
      }
      expect(await grayAt(page, '#a', 132, 100)).toBe(gray);
      expect(await findFaults(page)).toEqual([]);
      await page.locator('#a').evaluate((pane, url) => pane.setAttribute('src', url), phantom);
      await expect(page.getByRole('alert')).toHaveCount(0);
      expect(await cursorOf(page)).toEqual(cursor);
      expect(await page.evaluate(() => (window as never as { codes: unknown[] }).codes)).toEqual([
        ...Array.from({ length: 5 }, () => 'attribute/invalid'),
        'source/not-found',
      ]);
    });
  });

  test('has a size in any layout, also written from right to left, and is fine on a screen of twice the pixels', async ({
    page,
  }) => {
    await open(
      page,
      `<div dir="rtl" style="display: inline-flex">${'<volume-slice-view src="' + phantom + '"></volume-slice-view>'}</div>`,
      { script },
    );
    const box = (await page.locator('volume-slice-view').boundingBox())!;
    expect([box.width, box.height]).toEqual([300, 300]);
    const [letters, left] = await withPane(page, 'volume-slice-view', (pane) => [
      [...pane.shadowRoot!.querySelectorAll('[part=side]')].map(({ textContent }) => textContent),
      pane.shadowRoot!.querySelector('.side.l')!.getBoundingClientRect().left,
    ]);
    expect(letters).toEqual(['R', 'L', 'A', 'P']);
    expect(left).toBeLessThan(box.x + 20);
    await withPane(page, 'volume-slice-view', (pane) => pane.remove());
    expect(await page.evaluate(() => document.querySelectorAll('volume-slice-view').length)).toBe(0);
  });
});

test.describe('panes of a <volume-view>', () => {
  const three = ['axial', 'coronal', 'sagittal']
    .map((type) => `<volume-slice-view id="${type}" for="v" type="${type}"></volume-slice-view>`)
    .join('');
  const body = inPage(
    `<volume-view id="v" src="${phantom}" steps="20" alt="A torso"></volume-view>${three}<volume-slice-view id="other" for="v" group="b"></volume-slice-view>`,
  );

  test('have one crosshair and one window, and load nothing again', async ({ page }) => {
    const asked: string[] = [];
    page.on('request', (request) => asked.push(new URL(request.url()).pathname));
    await open(page, body, { head });
    await settle(page);
    await withPane(page, '#axial', (pane) => void (pane.cursor = [31.25, -12.5, 40.75]));
    for (const type of ['axial', 'coronal', 'sagittal'])
      expect(await cursorOf(page, `#${type}`), type).toEqual([31.25, -12.5, 40.75]);
    expect(await cursorOf(page, '#other')).not.toEqual([31.25, -12.5, 40.75]);
    const reported = await withPane(
      page,
      '#coronal',
      (pane) =>
        new Promise((resolve) => {
          pane.addEventListener('cursor-change', (event) => resolve((event as CustomEvent).detail), { once: true });
          (document.querySelector('#sagittal') as unknown as VolumeSliceView).cursor = [0, 0, 0];
        }),
    );
    expect(reported).toMatchObject({ cursor: [0, 0, 0], value: expect.any(Number) });
    expect(asked.filter((path) => path === phantom).length).toBe(1);
    await page.locator('#v').evaluate((view) => view.setAttribute('value-window', '-1000 1000'));
    await expect(page.locator('#axial [part=window]')).toHaveText('W 2000  L 0');
  });

  test('show labels in their colours, and say of a radar what has slices', async ({ page }) => {
    await open(
      page,
      inPage(
        `<volume-view id="v" src="${fieldUrl}" steps="20" alt="A field"></volume-view><volume-slice-view id="a" colors="volume"></volume-slice-view>`,
      ),
      { head },
    );
    await settle(page);
    const colored = await withPane(page, '#a', (pane) => {
      const canvas = pane.shadowRoot!.querySelector('canvas')!;
      const { data } = canvas.getContext('2d')!.getImageData(0, 0, canvas.width, canvas.height);
      return data.some((value, i) => i % 4 === 0 && Math.abs(value - data[i + 2]) > 20);
    });
    expect(colored).toBe(true);
    await page.locator('#v').evaluate((view) => view.setAttribute('src', '/demos/data/storm-radar.json'));
    await expect(page.getByRole('alert')).toContainText('a radar scan has no axial');
  });
});
