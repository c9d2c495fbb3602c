// An element comes, goes, loses its context, and shows the same picture again.
import { countGreen, plain, shape } from './helpers/green-shape.ts';
import {
  ballUrl,
  compare,
  expect,
  expectSamePicture,
  fieldUrl,
  forgetEvents,
  open,
  seenEvents,
  settle,
  takePicture,
  test,
  waitForEvent,
  withElement,
} from './helpers/harness.ts';
import { attributesOf, drawReference } from './helpers/reference.ts';
import { ball } from './helpers/volumes.ts';

test.describe('in and out of the page', () => {
  test('taken out it holds nothing, put back it shows the same picture without a new load', async ({ page }) => {
    await open(page, plain);
    const before = await takePicture(page);
    const gone = await withElement(page, async (element) => {
      const canvas = element.shadowRoot!.querySelector('canvas')!;
      const gl = canvas.getContext('webgl2')!;
      (window as unknown as { kept: Element }).kept = element;
      element.remove();
      await new Promise(requestAnimationFrame);
      return { lost: gl.isContextLost(), canvases: element.shadowRoot!.querySelectorAll('canvas').length };
    });
    expect(gone).toEqual({ lost: true, canvases: 0 });
    await forgetEvents(page);
    await page.evaluate(() => document.body.append((window as unknown as { kept: Element }).kept));
    expect(compare(await takePicture(page), before).worst).toBe(0);
    expect((await seenEvents(page)).filter(({ type }) => type !== 'render')).toEqual([]);
  });

  test('ten times', async ({ page }) => {
    await open(page, plain);
    const before = await takePicture(page);
    for (let i = 0; i < 10; i++) {
      await withElement(page, async (element) => {
        element.remove();
        await new Promise(requestAnimationFrame);
        document.body.append(element);
        await element.whenRendered();
      });
    }
    expect(compare(await takePicture(page), before).worst).toBe(0);
  });

  test("with its author's shapes", async ({ page }) => {
    await open(page, plain.replace('></volume-view>', `>${shape('0 1 0')}</volume-view>`));
    const before = await takePicture(page);
    await withElement(page, async (element) => {
      element.remove();
      await new Promise(requestAnimationFrame);
      document.body.append(element);
    });
    const after = await takePicture(page);
    expect(countGreen(after)).toBeGreaterThan(40);
    expect(compare(after, before).worst).toBe(0);
  });

  test('moved within the page it goes on with the same canvas', async ({ page }) => {
    await open(page, `<div id="a">${plain}</div><div id="b"></div>`);
    const before = await takePicture(page);
    const isSame = await withElement(page, async (element) => {
      const canvas = element.shadowRoot!.querySelector('canvas')!;
      document.querySelector('#b')!.append(element);
      await element.whenRendered();
      return canvas === element.shadowRoot!.querySelector('canvas') && !canvas.getContext('webgl2')!.isContextLost();
    });
    expect(isSame).toBe(true);
    expect(compare(await takePicture(page), before).worst).toBe(0);
    expect((await seenEvents(page)).filter(({ type }) => type === 'load')).toHaveLength(1);
  });

  test('made by script, without a parser', async ({ page }) => {
    await open(page, '');
    await page.evaluate(
      async ([src, attributes]) => {
        await customElements.whenDefined('volume-view');
        const element = document.createElement('volume-view');
        for (const [, name, value] of attributes.matchAll(/([\w-]+)="([^"]*)"/g)) element.setAttribute(name, value);
        element.src = src;
        document.body.append(element);
      },
      [fieldUrl, attributesOf()] as const,
    );
    expectSamePicture(await takePicture(page), drawReference());
  });
});

test('an element takes one WebGL context, and gives it back', async ({ page }) => {
  await page.addInitScript(() => {
    const contexts = new Set<WebGLRenderingContext>();
    const original = HTMLCanvasElement.prototype.getContext;
    HTMLCanvasElement.prototype.getContext = function (this: HTMLCanvasElement, ...args: unknown[]) {
      const context = Reflect.apply(original, this, args) as WebGLRenderingContext | null;
      if (context && 'isContextLost' in context) contexts.add(context);
      return context as never;
    };
    Object.assign(window, { countContexts: () => [...contexts].filter((context) => !context.isContextLost()).length });
  });
  const countContexts = (): Promise<number> =>
    page.evaluate(() => (window as unknown as { countContexts(): number }).countContexts());
  await open(page, plain.repeat(3));
  for (let i = 0; i < 3; i++) await settle(page, `volume-view:nth-of-type(${i + 1})`);
  expect(await countContexts()).toBe(3);
  await page.evaluate(() => document.querySelectorAll('volume-view').forEach((element) => element.remove()));
  expect(await countContexts()).toBe(0);
});

test('eight elements at once, all with their own pictures', async ({ page }) => {
  const body = Array.from(
    { length: 8 },
    (_, i) =>
      `<volume-view id="v${i}" src="${i % 2 ? ballUrl : fieldUrl}" ${attributesOf({ steps: String(40 + i) })}></volume-view>`,
  ).join('');
  await open(page, `<div style="display: grid; grid-template-columns: repeat(4, 130px)">${body}</div>`);
  for (let i = 0; i < 8; i++) {
    const picture = await takePicture(page, { selector: `#v${i}` });
    expectSamePicture(picture, drawReference({ steps: 40 + i, ...(i % 2 ? { volume: ball } : {}) }));
  }
  expect((await seenEvents(page)).filter(({ type }) => type === 'error')).toEqual([]);
});

test('a lost context comes back with the picture and the view', async ({ page }) => {
  await open(page, plain);
  await settle(page);
  await page.locator('.picture').press('ArrowLeft');
  await waitForEvent(page, 'camera-change');
  const before = await takePicture(page);
  await forgetEvents(page);
  await withElement(page, (element) =>
    element
      .shadowRoot!.querySelector('canvas')!
      .getContext('webgl2')!
      .getExtension('WEBGL_lose_context')!
      .loseContext(),
  );
  await waitForEvent(page, 'render');
  expect(compare(await takePicture(page), before).worst).toBe(0);
  expect((await seenEvents(page)).filter(({ type }) => type === 'error')).toEqual([]);
  await page.locator('.picture').press('0');
  await settle(page);
  expectSamePicture(await takePicture(page), drawReference());
});
