// Pages that are written from right to left. What counts is what a reader reads: the colour beside a number is the colour that
// the transfer function gives this number, and what is at hand at a place sets the value of this place.
import type { Locator, Page } from '@playwright/test';
import { evaluate } from '../../src/optics/transfer/transfer-function.ts';
import { parseTransferFunction } from '../../src/optics/transfer/parse-transfer-function.ts';
import {
  drag,
  editor,
  handle,
  middleOf,
  openEditor,
  readStops,
  said,
  view as plainView,
} from './helpers/companions.ts';
import { expect, networkLines, open, settle, keptTest as test } from './helpers/harness.ts';
import { decodePicture } from './helpers/pictures.ts';
import type { Picture } from './helpers/pictures.ts';
import { serve, several } from './helpers/scans.ts';

const directions = ['ltr', 'rtl'] as const;

/** Blue, red and yellow lie at other places where a scale runs the other way. */
const text = '0 blue 30%, 100 red 30%, 200 #ffff00 30%';
const stops = parseTransferFunction(text, [0, 255]);
const view = plainView.replace(said, text);
const legends =
  '<volume-legend for="field" label="Strength" style="width: 400px"></volume-legend><volume-legend for="field" orientation="vertical"></volume-legend>';
const inDirection = (dir: string, body: string): string => `<div dir="${dir}">${body}</div>`;

const takePage = async (page: Page): Promise<Picture> => decodePicture(await page.screenshot());

/** Red, green and blue at a place of the page, 0..1. */
function colorAt({ width, data }: Picture, x: number, y: number): number[] {
  const at = 4 * (Math.round(y) * width + Math.round(x));
  return [...data.subarray(at, at + 3)].map((channel) => channel / 255);
}

/** The opaque colour of a value, as the transfer function says. */
function colorOf(value: number): readonly number[] {
  const [r, g, b, opacity] = evaluate(stops, value);
  return [r / opacity, g / opacity, b / opacity];
}

function expectColor(got: readonly number[], value: number): void {
  const expected = colorOf(value);
  const worst = Math.max(...expected.map((channel, i) => Math.abs(got[i] - channel)));
  expect(worst, `at ${value}: ${got.join()} instead of ${expected.join()}`).toBeLessThan(0.05);
}

/** Numbers of a scale, with their places. */
async function readTicks(ticks: Locator): Promise<{ value: number; x: number; y: number }[]> {
  const texts = await ticks.allTextContents();
  const places = await Promise.all(texts.map((_, i) => middleOf(ticks.nth(i))));
  return texts.map((text, i) => ({ value: parseFloat(text), ...places[i] }));
}

for (const dir of directions) {
  test(`${dir}: next to a number of the legend is its colour, and all numbers are within its length`, async ({
    page,
  }) => {
    await openEditor(page, inDirection(dir, view + legends + editor));
    const picture = await takePage(page);
    for (const [index, upright] of [false, true].entries()) {
      const legend = page.locator('volume-legend').nth(Number(upright));
      const strip = (await legend.locator('.colors').boundingBox())!;
      const ticks = await readTicks(legend.locator('[part=ticks] span'));
      expect(ticks.map(({ value }) => value)).toEqual([0, 50, 100, 150, 200]);
      for (const { value, x, y } of ticks.slice(1, -1))
        expectColor(
          upright ? colorAt(picture, strip.x + strip.width / 2, y) : colorAt(picture, x, strip.y + strip.height / 2),
          value,
        );
      for (const span of await legend.locator('[part=ticks] span').all()) {
        const box = (await span.boundingBox())!;
        const [from, to, low, high] = upright
          ? [box.y, box.y + box.height, strip.y, strip.y + strip.height]
          : [box.x, box.x + box.width, strip.x, strip.x + strip.width];
        expect(from, `legend ${index}`).toBeGreaterThanOrEqual(low - 1);
        expect(to, `legend ${index}`).toBeLessThanOrEqual(high + 1);
      }
    }
  });

  test(`${dir}: what stands on an upright legend's colours grows away from them`, async ({ page }) => {
    await openEditor(page, inDirection(dir, view + legends + editor));
    const legend = page.locator('volume-legend').nth(1);
    const [colors, heights] = await Promise.all(
      ['.colors', '.opacity'].map(async (part) => (await legend.locator(part).boundingBox())!),
    );
    const picture = await takePage(page);
    // Of 30 % opacity, the top is two thirds as high as the scale is wide: yellow beside the colours, ground beyond.
    const at = (share: number): number[] => {
      const away = colors.x < heights.x ? share : 1 - share;
      return colorAt(picture, heights.x + away * heights.width, heights.y + 4);
    };
    expect(at(0.2)[0]).toBeGreaterThan(0.5);
    expect(at(0.9)[0]).toBeLessThan(0.3);
  });

  test(`${dir}: the editor's handles are where their numbers and colours are, and a hand that drags one sets the value of its place`, async ({
    page,
  }) => {
    await openEditor(page, inDirection(dir, view + editor));
    const strip = (await page.locator('volume-transfer-function .strip').boundingBox())!;
    const ticks = await readTicks(page.locator('volume-transfer-function .values span'));
    const [fifty, hundred] = [50, 100].map((value) => ticks.find((tick) => tick.value === value)!);
    const red = await middleOf(handle(page, 2));
    expect(red.x).toBeCloseTo(hundred.x, -0.5);
    const picture = await takePage(page);
    for (const { x, value } of ticks.slice(1, -1)) expectColor(colorAt(picture, x, strip.y + 4), value);
    await drag(page, handle(page, 2), { x: fifty.x - hundred.x, y: 0 });
    await settle(page);
    expect(Math.abs((await readStops(page))[1].value - 50)).toBeLessThan(2);
    expect(Math.abs((await middleOf(handle(page, 2))).x - fifty.x)).toBeLessThan(2);
  });

  test(`${dir}: numbers of bands and factors keep their signs and their order`, async ({ page }) => {
    await openEditor(
      page,
      inDirection(dir, view + editor.replace('for=', 'mode="bands" band-edges="-50 0 100 200" for=')),
    );
    const places = await page
      .locator('volume-transfer-function .range')
      .first()
      .evaluate((element) => {
        const range = document.createRange();
        const nodes = [...element.querySelector('bdi')!.childNodes].filter(
          (node) => node instanceof Text && node.data.trim() !== '',
        ) as Text[];
        // Where each sign of the text is on the screen.
        return nodes
          .flatMap((node) =>
            Array.from({ length: node.length }, (_, i) => {
              range.setStart(node, i);
              range.setEnd(node, i + 1);
              return { sign: node.data[i], x: range.getBoundingClientRect().left };
            }),
          )
          .filter(({ sign }) => sign.trim() !== '');
      });
    expect(
      places.every(({ x }, i) => i === 0 || x > places[i - 1].x),
      JSON.stringify(places),
    ).toBe(true);
    expect(places.map(({ sign }) => sign).join('')).toBe('−50–0');
  });

  test(`${dir}: the timeline's slider goes to the scan whose mark it is put to`, async ({ page }) => {
    await serve(page);
    await open(
      page,
      inDirection(
        dir,
        `<volume-view ${several(4)}></volume-view><volume-timeline style="width: 500px"></volume-timeline>`,
      ),
    );
    await settle(page);
    await expect(page.locator('volume-timeline .name')).not.toHaveCount(0);
    const marks = page.locator('volume-timeline .tick');
    const mark = await middleOf(marks.nth(1));
    const slider = (await page.getByRole('slider').boundingBox())!;
    await page.mouse.click(mark.x, slider.y + slider.height / 2);
    await expect(page.getByRole('slider')).toHaveValue('1');
    const count = (await page.locator('volume-timeline .count').textContent())!;
    expect(count.trim()).toBe('2 / 4');
  });
}

/** The signs of what a selector finds in an element's shadow root, from left to right on the screen; those of one line. */
async function readFromLeft(element: Locator, selector: string): Promise<string> {
  return element
    .locator(selector)
    .first()
    .evaluate((found) => {
      const range = document.createRange();
      const walker = document.createTreeWalker(found, NodeFilter.SHOW_TEXT);
      const signs: { sign: string; x: number; y: number }[] = [];
      for (let node = walker.nextNode() as Text | null; node; node = walker.nextNode() as Text | null) {
        for (let i = 0; i < node.length; i++) {
          range.setStart(node, i);
          range.setEnd(node, i + 1);
          const { left, top, width } = range.getBoundingClientRect();
          if (width > 0) signs.push({ sign: node.data[i], x: left, y: top });
        }
      }
      const line = signs.filter(({ y }) => Math.abs(y - signs.at(-1)!.y) < 4);
      line.sort((a, b) => a.x - b.x);
      return line
        .map(({ sign }) => sign)
        .join('')
        .trim();
    });
}

test('rtl: numbers with units and English sentences are read from left to right: rings, hints, panels', async ({
  page,
}) => {
  await open(
    page,
    inDirection(
      'rtl',
      '<volume-view src="/demos/data/storm-radar-1500.json" steps="16" controls alt="A storm" style="width: 640px; height: 480px"></volume-view><volume-legend></volume-legend><volume-readout for="none"></volume-readout>',
    ),
  );
  await settle(page);
  const element = page.locator('volume-view');
  const rings = await element.locator('.labels span:not([hidden])').allTextContents();
  expect(rings.some((text) => /^\d+ km$/.test(text))).toBe(true);
  for (const [i, text] of rings.entries())
    expect(await readFromLeft(element, `.labels span:not([hidden]) >> nth=${i}`)).toBe(text);
  await expect(element.getByRole('button', { name: 'More' })).toBeVisible();
  if (await element.locator('.hint').count()) expect(await readFromLeft(element, '.hint')).toMatch(/zooms\.$/);
  await element.getByRole('button', { name: 'More' }).click();
  await element.getByRole('button', { name: 'Help' }).click();
  expect(await readFromLeft(element, '.panel dd')).toMatch(/arrow keys$|keys$/);
  expect(await readFromLeft(page.locator('volume-legend'), '.unit')).toBe('dBZ');
  expect(await readFromLeft(page.locator('volume-readout'), '.hint')).toMatch(/[.)"]$/);
});

test.describe('rtl, with an error', () => {
  test.use({ allowedLines: networkLines });

  test('its sentences end at their right', async ({ page }) => {
    await open(
      page,
      inDirection(
        'rtl',
        '<volume-view src="nowhere.nii" alt="None" style="width: 640px; height: 300px"></volume-view>',
      ),
    );
    const alert = page.locator('volume-view').getByRole('alert');
    await expect(alert).toBeVisible();
    expect(await readFromLeft(page.locator('volume-view'), '.error strong')).toBe('The file could not be loaded.');
  });
});

test('forced colours: pictures, scales and histograms have a border', async ({ page }) => {
  await page.emulateMedia({ forcedColors: 'active' });
  await openEditor(
    page,
    view + legends + editor + '<volume-slice-view for="field" style="width: 200px"></volume-slice-view>',
  );
  const outlines = await page.evaluate(() => {
    const styleOf = (host: string, inner: string | null): string => {
      const element = document.querySelector(host)!;
      return getComputedStyle(inner ? element.shadowRoot!.querySelector(inner)! : element).outlineStyle;
    };
    return [
      styleOf('volume-view', null),
      styleOf('volume-slice-view', null),
      styleOf('volume-legend', '.bar'),
      styleOf('volume-transfer-function', '.plot'),
      styleOf('volume-transfer-function', '.strip'),
    ];
  });
  expect(outlines).toEqual(['solid', 'solid', 'solid', 'solid', 'solid']);
  await page.emulateMedia({ forcedColors: null });
});
