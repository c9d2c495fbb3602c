// An element that is moved between documents, and pages that hold it in ways that browsers do not tell of.
import {
  expect,
  expectSamePicture,
  fieldUrl,
  open,
  takePicture,
  takeScreenshot,
  test,
  withElement,
} from './helpers/harness.ts';
import { decodePicture } from './helpers/pictures.ts';
import { attributesOf, drawReference } from './helpers/reference.ts';

const own = `<volume-view src="${fieldUrl}" ${attributesOf()} style="display: block; width: 120px; height: 90px; background: black"></volume-view>`;
const body = `${own}<iframe style="width: 300px; height: 200px; border: 0"></iframe>`;
const onBlack = drawReference({ background: [0, 0, 0] });

test.describe('an element in a frame of the page', () => {
  test('is the same there, and back in the page', async ({ page }) => {
    await open(page, body);
    const view = await page.waitForFunction(() => document.querySelector('volume-view'));
    for (let times = 0; times < 2; times++) {
      await withElement(page, (element) => element.whenRendered());
      await view.evaluate((element) => {
        const inner = document.querySelector('iframe')!.contentDocument!;
        inner.body.style.margin = '0';
        inner.body.append(element!);
      });
      const there = page.frames()[1].locator('volume-view');
      await there.evaluate((element: HTMLElementTagNameMap['volume-view']) => element.whenRendered());
      expect((await there.boundingBox())!.height).toBe(90);
      expect(
        await there.evaluate((element) => {
          const { clientWidth, width } = element.shadowRoot!.querySelector('canvas')!;
          return [getComputedStyle(element.shadowRoot!.querySelector('.picture')!).position, clientWidth, width];
        }),
      ).toEqual(['absolute', 120, 120]);
      expectSamePicture(decodePicture(await there.screenshot()), onBlack);
      await view.evaluate((element) => document.body.prepend(element!));
      await withElement(page, (element) => element.whenRendered());
      expectSamePicture(await takePicture(page), drawReference());
      expectSamePicture(await takeScreenshot(page), onBlack);
    }
  });

  test('is the same after the frame was removed with it', async ({ page }) => {
    await open(page, body);
    const view = await page.waitForFunction(() => document.querySelector('volume-view'));
    await withElement(page, (element) => element.whenRendered());
    const errors = await view.evaluate(async (element) => {
      const seen: string[] = [];
      window.addEventListener('error', (event) => {
        if (event instanceof ErrorEvent) seen.push(event.message);
      });
      const frame = document.querySelector('iframe')!;
      frame.contentDocument!.body.append(element!);
      await element!.whenRendered();
      frame.remove();
      await new Promise((resolve) => setTimeout(resolve, 100));
      element!.setAttribute('steps', '60');
      await element!.whenRendered();
      await new Promise((resolve) => setTimeout(resolve, 200));
      document.body.prepend(element!);
      return seen;
    });
    expect(errors, 'of an observer of what is nowhere').toEqual([]);
    await withElement(page, (element) => element.whenRendered());
    expectSamePicture(await takePicture(page), drawReference());
    expectSamePicture(await takeScreenshot(page), onBlack);
  });
});
