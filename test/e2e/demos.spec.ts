// The pages of the demos, with the built package in the place of their sources, and small pictures.
import { readdirSync } from 'node:fs';
import { join } from 'node:path';
import { projectRoot } from '../../scripts/shared-data.mjs';
import { findFaults } from './helpers/axe.ts';
import { openDemo } from './helpers/demo.ts';
import { compare, expect, settle, takePicture, test } from './helpers/harness.ts';
import { meanOf } from './helpers/pictures.ts';

const small = 'volume-view { inline-size: 2rem !important }';
/** The study's page is TypeScript, which browsers do not read; the paper's aorta is not in the package; the last is only an element. */
const unfit = ['accuracy.html', 'paper.html', 'standalone.html'];
const pages = readdirSync(join(projectRoot, 'demos')).filter((name) => name.endsWith('.html'));

test('the gallery leads to each page, and each leads to the next one', async ({ page }) => {
  await openDemo(page, '', small);
  const links = await page
    .locator('.cards a')
    .evaluateAll((all) =>
      all.map((link) => [link.getAttribute('href')!, link.querySelector('h3')!.textContent] as const),
    );
  expect(new Set([...links.map(([href]) => href), 'index.html', 'paper.html', 'standalone.html'])).toEqual(
    new Set(pages),
  );
  const all = ['./', 'All demos'] as const;
  for (const [i, [href]] of links.entries()) {
    const [[before, beforeName], [after, afterName]] = [links[i - 1] ?? all, links[i + 1] ?? all];
    const html = await (await page.request.get(`/demos/${href}`)).text();
    expect(html).toContain(
      `<footer><a href="${before}">← ${beforeName}</a> <a href="${after}">${afterName} →</a></footer>`,
    );
  }
});

test.describe('on a phone', () => {
  test.use({ viewport: { width: 390, height: 844 }, hasTouch: true });

  for (const name of pages.filter((path) => !unfit.includes(path))) {
    test(`${name} fits, says nothing on the console, and axe finds nothing`, async ({ page }) => {
      await openDemo(page, name, small);
      expect(await page.evaluate(() => document.documentElement.scrollWidth - innerWidth)).toBeLessThanOrEqual(0);
      const first = page.locator('volume-view').first();
      if (await first.count())
        expect(
          await first.evaluate((view) =>
            (view as unknown as { whenRendered(): Promise<unknown> }).whenRendered().then(() => 'drawn'),
          ),
        ).toBe('drawn');
      expect(await findFaults(page)).toEqual([]);
    });
  }
});

test('the lesson on a storm can be answered: its numbers are those of the picture', async ({ page }) => {
  await openDemo(page, 'storm-lesson.html', 'volume-view { inline-size: 240px !important }');
  const step = async (number: number): Promise<void> => {
    await page.locator('volume-tour').evaluate((tour, to) => tour.setAttribute('step', `${to}`), number);
    await settle(page, '#storm');
  };
  const results = () =>
    page
      .locator('volume-question')
      .evaluateAll((all) =>
        all.map((one) => (one as HTMLElement & { result: { correct: boolean } | null }).result?.correct),
      );
  await settle(page, '#storm');
  await page.getByRole('radiogroup').getByText('Heavy rain, or hail').click();
  await page.locator('#strength').getByRole('button', { name: 'Answer' }).click();
  await expect.poll(results).toEqual([true, undefined, undefined, undefined]);

  await step(2);
  const value = await page.locator('#storm').evaluate(async (view) => {
    const pin = view.shadowRoot!.querySelector('[part~="note-pin"]')!.getBoundingClientRect();
    const { positionFromPoint } = view as unknown as {
      positionFromPoint(x: number, y: number): Promise<{ value: number } | null>;
    };
    return (await positionFromPoint.call(view, pin.x + pin.width / 2, pin.y + pin.height / 2))!.value;
  });
  await page.locator('#value').getByRole('textbox').fill(value.toFixed(1));
  await page.locator('#value').getByRole('button', { name: 'Answer' }).click();
  await expect.poll(results).toEqual([true, true, undefined, undefined]);

  await step(3);
  await page.locator('#storm').scrollIntoViewIfNeeded();
  // The place of the strongest echo among points of the picture: what a reader is asked to look for.
  const [x, y] = await page.locator('#storm').evaluate(async (view) => {
    const { left, top, width, height } = view.getBoundingClientRect();
    const { positionFromPoint } = view as unknown as {
      positionFromPoint(x: number, y: number): Promise<{ value: number } | null>;
    };
    let [best, strongest] = [[left, top] as [number, number], -Infinity];
    for (let i = 0.1; i < 0.95; i += 0.05)
      for (let j = 0.1; j < 0.95; j += 0.05) {
        const at = [left + i * width, top + j * height] as [number, number];
        const found = await positionFromPoint.call(view, ...at);
        if (found && found.value > strongest) [best, strongest] = [at, found.value];
      }
    return best;
  });
  await page.mouse.click(x, y);
  await expect.poll(results).toEqual([true, true, true, undefined]);

  await step(4);
  await page.locator('#name').getByRole('textbox').fill('Anvil');
  await page.locator('#name').getByRole('button', { name: 'Answer' }).click();
  await expect.poll(results).toEqual([true, true, true, true]);
  await expect(page.locator('#name').locator('[part=score]')).toContainText('4 of 4');
});

test('the projections are four pictures, and none is black', async ({ page }) => {
  await openDemo(page, 'projection.html', small);
  const pictures = [];
  for (const name of ['All', 'Max', 'Min', 'Average']) {
    await page.getByText(name, { exact: true }).click();
    await settle(page, '#torso');
    pictures.push(await takePicture(page, { selector: '#torso' }));
    expect(meanOf(pictures.at(-1)!)[0], name).toBeGreaterThan(10);
  }
  for (const [i, one] of pictures.entries())
    for (const other of pictures.slice(0, i)) expect(compare(one, other).rmse).toBeGreaterThan(20);
  await expect(page.locator('#markup')).toContainText('value-window="-700 -100"');
  await expect(page.locator('#torso')).not.toHaveAttribute('region');
});
