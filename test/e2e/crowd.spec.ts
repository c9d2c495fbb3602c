// More elements in sight than there are contexts.
import type { Page } from '@playwright/test';
import { maxContexts } from '../../src/viewer/scenes/context-pool.ts';
import {
  black,
  contexts,
  countContexts,
  element,
  expected,
  isLive,
  onBlack,
  sized,
  waitUntilDrawn,
} from './helpers/crowd.ts';
import {
  ballUrl,
  compare,
  expect,
  expectSamePicture,
  fieldUrl,
  forgetEvents,
  open,
  seenEvents,
  setAttributes,
  settle,
  takePicture,
  takeScreenshot,
  test,
  waitForEvent,
  withElement,
} from './helpers/harness.ts';
import { drawReference } from './helpers/reference.ts';
import { ball } from './helpers/volumes.ts';

/** More elements in sight than there are contexts, all drawn. */
async function openCrowd(page: Page, { children = '' } = {}): Promise<number[]> {
  const numbers = Array.from({ length: maxContexts + 2 }, (_, i) => i);
  const row = numbers.map((i) => element(i, children)).join('');
  await countContexts(page);
  await open(page, `<div style="display: grid; grid-template-columns: repeat(5, 130px)">${row}</div>`, { head: black });
  await waitUntilDrawn(page, numbers);
  return numbers;
}

async function findSnapshot(page: Page, numbers: readonly number[]): Promise<number> {
  for (const i of numbers) if (!(await isLive(page, i))) return i;
  throw new Error('all are live');
}

/** Take an element's context away: the others are all asked to draw. */
async function takeContext(page: Page, from: number, numbers: readonly number[]): Promise<void> {
  await page.mouse.move(890, 690);
  await page.evaluate(() => (document.activeElement as HTMLElement | null)?.blur());
  for (const i of numbers) if (i !== from) await withElement(page, (view) => view.redraw(), { selector: `#v${i}` });
  await expect.poll(() => isLive(page, from)).toBe(false);
}

test.describe('more in sight than there are contexts', () => {
  test('all show their pictures, and at rest nothing is drawn', async ({ page }) => {
    const numbers = await openCrowd(page);
    for (const i of numbers) expectSamePicture(await takeScreenshot(page, `#v${i}`), expected(i));
    expect(await contexts(page)).toEqual({ now: maxContexts, max: maxContexts });
    await forgetEvents(page);
    await page.waitForTimeout(500);
    expect(await seenEvents(page)).toEqual([]);
  });

  test('the mouse over it gives an element a context, without a jump', async ({ page }) => {
    const numbers = await openCrowd(page);
    const snapshot = await findSnapshot(page, numbers);
    const before = await takeScreenshot(page, `#v${snapshot}`);
    await page.locator(`#v${snapshot}`).hover();
    await expect.poll(() => isLive(page, snapshot)).toBe(true);
    await page.waitForFunction(
      (id) => document.querySelector(`#${id}`)!.shadowRoot!.querySelectorAll('canvas').length === 1,
      `v${snapshot}`,
    );
    expect(compare(await takeScreenshot(page, `#v${snapshot}`), before).worst).toBe(0);
    expect((await contexts(page)).max).toBe(maxContexts);
  });

  test('keys turn one that had none, and what a person chose stays when it has none again', async ({ page }) => {
    const numbers = await openCrowd(page);
    const snapshot = await findSnapshot(page, numbers);
    const id = `v${snapshot}`;
    await forgetEvents(page);
    await page.locator(`#${id} .picture`).press('ArrowLeft');
    await waitForEvent(page, 'camera-change', { id });
    await settle(page, `#${id}`);
    const turned = await takeScreenshot(page, `#${id}`);
    expect(compare(turned, expected(snapshot)).worst).toBeGreaterThan(20);
    // The ring of the focus is no part of the picture.
    await page.evaluate(() => (document.activeElement as HTMLElement).blur());
    const stats = await withElement(page, (view) => JSON.stringify(view.renderStats), { selector: `#${id}` });
    const blob = await takePicture(page, { selector: `#${id}` });
    const shown = await takeScreenshot(page, `#${id}`);
    await takeContext(page, snapshot, numbers);
    expect(compare(await takeScreenshot(page, `#${id}`), shown).worst).toBe(0);
    expect(
      JSON.parse(await withElement(page, (view) => JSON.stringify(view.renderStats), { selector: `#${id}` })),
    ).toMatchObject({ width: sized.width, steps: JSON.parse(stats).steps });
    expect(compare(await takePicture(page, { selector: `#${id}` }), blob).worst).toBe(0);
  });

  test('an attribute that changes is shown', async ({ page }) => {
    const numbers = await openCrowd(page);
    const snapshot = await findSnapshot(page, numbers);
    await withElement(page, (view) => view.setAttribute('steps', '60'), { selector: `#v${snapshot}` });
    await settle(page, `#v${snapshot}`);
    const reference = drawReference({ steps: 60, ...(snapshot % 2 ? { volume: ball } : {}), ...onBlack });
    expectSamePicture(await takeScreenshot(page, `#v${snapshot}`), reference);
    await setAttributes(page, { src: snapshot % 2 ? fieldUrl : ballUrl }, `#v${snapshot}`);
    expectSamePicture(
      await takeScreenshot(page, `#v${snapshot}`),
      drawReference({ steps: 60, ...(snapshot % 2 ? {} : { volume: ball }), ...onBlack }),
    );
  });

  test("so is an author's shape, one that was there and one that is new", async ({ page }) => {
    const shape = (color: string): string =>
      `<shape><appearance><material diffusecolor="0 0 0" emissivecolor="${color}"></material></appearance><box size="8 8 60"></box></shape>`;
    const numbers = await openCrowd(page, { children: shape('0 1 0') });
    const snapshot = await findSnapshot(page, numbers);
    const green = await takeScreenshot(page, `#v${snapshot}`);
    await forgetEvents(page);
    await withElement(page, (view) => view.querySelector('material')!.setAttribute('emissivecolor', '0 0 1'), {
      selector: `#v${snapshot}`,
    });
    await waitForEvent(page, 'render', { id: `v${snapshot}` });
    await settle(page, `#v${snapshot}`);
    const blue = await takeScreenshot(page, `#v${snapshot}`);
    expect(compare(blue, green).worst).toBeGreaterThan(200);
    await takeContext(page, snapshot, numbers);
    await withElement(page, (view) => view.querySelector('shape')!.remove(), { selector: `#v${snapshot}` });
    await expect
      .poll(async () => compare(await takeScreenshot(page, `#v${snapshot}`), expected(snapshot)).worst)
      .toBeLessThanOrEqual(2);
  });

  test('an error stays where it was, and the last picture under it', async ({ page }) => {
    const numbers = await openCrowd(page);
    const wrong = await findSnapshot(page, numbers);
    await page.addStyleTag({ content: 'volume-view::part(error) { visibility: hidden }' });
    await withElement(page, (view) => view.setAttribute('transfer-function', 'nonsense'), { selector: `#v${wrong}` });
    await waitForEvent(page, 'error', { id: `v${wrong}` });
    expectSamePicture(await takeScreenshot(page, `#v${wrong}`), expected(wrong));
    await page.locator(`#v${wrong}`).hover();
    await expect.poll(() => isLive(page, wrong)).toBe(true);
    await takeContext(page, wrong, numbers);
    await expect(page.locator(`#v${wrong} .error`)).toContainText('nonsense');
    expectSamePicture(await takeScreenshot(page, `#v${wrong}`), expected(wrong));
  });

  test('where all of them move without end, each gets its turns', async ({ page }) => {
    const clock = '<timesensor def="clock" cycleinterval="3" loop="true"></timesensor>';
    const numbers = await openCrowd(page, { children: clock });
    // Beside those that draw all the time, one that was never drawn comes to be drawn.
    await page.evaluate((html) => document.body.insertAdjacentHTML('beforeend', html), element(90));
    await waitUntilDrawn(page, [90]);
    expectSamePicture(await takeScreenshot(page, '#v90'), expected(90));
    await forgetEvents(page);
    await expect.poll(async () => new Set((await seenEvents(page)).map(({ id }) => id)).size).toBe(numbers.length);
    expect((await contexts(page)).max).toBe(maxContexts);
  });
});
