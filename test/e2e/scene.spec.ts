import type { Page } from '@playwright/test';
import { files } from './helpers/data.ts';
import { ballUrl, compare, expect, expectSamePicture, fieldUrl, forgetEvents, open, seenEvents, settle, takePicture, takeScreenshot, test, waitForEvent, withElement } from './helpers/harness.ts';
import { meanOf } from './helpers/pictures.ts';
import type { Picture } from './helpers/pictures.ts';
import { attributesOf, drawReference } from './helpers/reference.ts';
import { serveSlowly } from './helpers/slow-server.ts';
import { ball } from './helpers/volumes.ts';

const plain = `<volume-view src="${fieldUrl}" ${attributesOf()} alt="A field"></volume-view>`;

const shape = (color: string, x = 0): string =>
  `<transform id="place" translation="${x} 0 0"><shape><appearance><material id="paint" diffusecolor="0 0 0" emissivecolor="${color}"></material></appearance><box size="8 8 60"></box></shape></transform>`;

/** Pixels of pure green: what a shape of that colour leaves where nothing is before it. */
function countGreen({ data }: Picture): number {
  let count = 0;
  for (let i = 0; i < data.length; i += 4) if (data[i] < 8 && data[i + 1] > 245 && data[i + 2] < 8) count++;
  return count;
}

async function change(page: Page, act: (element: Element) => void): Promise<Picture> {
  const since = (await seenEvents(page)).length;
  await page.locator('volume-view').evaluate(act);
  await waitForEvent(page, 'render', { since });
  return takePicture(page);
}

test.describe('the author\'s X3D', () => {
  test('is in the picture, within and before and behind the volume', async ({ page }) => {
    await open(page, plain.replace('></volume-view>', `>${shape('0 1 0')}</volume-view>`));
    const picture = await takePicture(page);
    // It sticks out at both ends of the volume (32 high), and is veiled by it in between.
    expect(countGreen(picture)).toBeGreaterThan(40);
    const [red, green, blue, alpha] = [0, 1, 2, 3].map((c) => picture.data[(45 * 120 + 60) * 4 + c]);
    expect(alpha).toBe(255);
    expect(green).toBeLessThan(250);
    expect(red + blue).toBeGreaterThan(10);
  });

  test('may be added, changed and removed at run time', async ({ page }) => {
    await open(page, plain);
    const bare = await takePicture(page);
    expect(countGreen(bare)).toBe(0);
    await page.evaluate((html) => {
      const template = document.createElement('template');
      template.innerHTML = html;
      document.querySelector('volume-view')!.append(template.content);
    }, shape('0 1 0'));
    await waitForEvent(page, 'render', { since: (await seenEvents(page)).length - 1 });
    await expect.poll(async () => countGreen(await takePicture(page))).toBeGreaterThan(40);
    const green = await takePicture(page);
    const blue = await change(page, (element) => element.querySelector('#paint')!.setAttribute('emissivecolor', '0 0 1'));
    expect(countGreen(blue)).toBe(0);
    expect(compare(blue, green).worst).toBeGreaterThan(200);
    const moved = await change(page, (element) => element.querySelector('#place')!.setAttribute('translation', '12 0 0'));
    expect(compare(moved, blue).worst).toBeGreaterThan(200);
    const removed = await change(page, (element) => element.querySelector('#place')!.remove());
    expect(compare(removed, bare).worst).toBe(0);
  });

  test('may be a light', async ({ page }) => {
    const lit = '<shape><appearance><material diffusecolor="0.3 0.3 0.3" ambientintensity="0"></material></appearance><box size="8 40 8"></box></shape>';
    await open(page, plain.replace('></volume-view>', `>${lit}</volume-view>`));
    const before = meanOf(await takePicture(page));
    await page.evaluate(() => {
      const light = document.createElement('directionallight');
      light.setAttribute('color', '0 0 1');
      light.setAttribute('direction', '0 -1 0');
      document.querySelector('volume-view')!.prepend(light);
    });
    await expect.poll(async () => meanOf(await takePicture(page))[2]).toBeGreaterThan(before[2] + 0.5);
    const after = meanOf(await takePicture(page));
    expect(Math.abs(after[0] - before[0])).toBeLessThan(0.1);
  });
});

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
        await element.renderComplete;
      });
    }
    expect(compare(await takePicture(page), before).worst).toBe(0);
  });

  test('with its author\'s shapes', async ({ page }) => {
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
      await element.renderComplete;
      return canvas === element.shadowRoot!.querySelector('canvas') && !canvas.getContext('webgl2')!.isContextLost();
    });
    expect(isSame).toBe(true);
    expect(compare(await takePicture(page), before).worst).toBe(0);
    expect((await seenEvents(page)).filter(({ type }) => type === 'load')).toHaveLength(1);
  });

  test('made by script, without a parser', async ({ page }) => {
    await open(page, '');
    await page.evaluate(async ([src, attributes]) => {
      await customElements.whenDefined('volume-view');
      const element = document.createElement('volume-view');
      for (const [, name, value] of attributes.matchAll(/([\w-]+)="([^"]*)"/g)) element.setAttribute(name, value);
      element.src = src;
      document.body.append(element);
    }, [fieldUrl, attributesOf()] as const);
    expectSamePicture(await takePicture(page), drawReference());
  });
});

test.describe('another src', () => {
  test('of many in a row only the last one is shown', async ({ page }) => {
    await open(page, plain);
    await settle(page);
    await forgetEvents(page);
    await withElement(page, async (element, urls) => {
      for (const url of urls) {
        element.src = url;
        await Promise.resolve();
      }
      await element.renderComplete;
    }, { argument: [ballUrl, fieldUrl, '/nowhere.nii', ballUrl, fieldUrl, ballUrl] });
    const seen = await seenEvents(page);
    expect(seen.filter(({ type }) => type === 'load').map(({ detail }) => (detail as { dimensions: number[] }).dimensions))
      .toEqual([[12, 12, 12]]);
    expect(seen.filter(({ type }) => type === 'error')).toEqual([]);
    expectSamePicture(await takePicture(page), drawReference({ volume: ball }));
  });

  test('ends the fetch of the one before', async ({ page }) => {
    const server = await serveSlowly(files['field.nii'], 0.5);
    await open(page, `<volume-view src="${server.url}" ${attributesOf()}></volume-view>`);
    await page.waitForFunction(() => window.__seen.some(({ detail }) => (detail as { loaded: number }).loaded > 0));
    await withElement(page, (element, src) => {
      element.src = src;
    }, { argument: ballUrl });
    await server.dropped;
    expectSamePicture(await takePicture(page), drawReference({ volume: ball }));
    expect((await seenEvents(page)).filter(({ type }) => type === 'load')).toHaveLength(1);
    server.close();
  });

  test('so does taking the element out, and back in it loads anew', async ({ page }) => {
    const server = await serveSlowly(files['field.nii'], 0.5);
    await open(page, `<volume-view src="${server.url}" ${attributesOf()}></volume-view>`);
    await page.waitForFunction(() => window.__seen.some(({ detail }) => (detail as { loaded: number }).loaded > 0));
    await withElement(page, (element) => {
      (window as unknown as { kept: Element }).kept = element;
      element.remove();
    });
    await server.dropped;
    server.release();
    await page.evaluate(() => document.body.append((window as unknown as { kept: Element }).kept));
    expectSamePicture(await takePicture(page), drawReference());
    expect(server.requests()).toBe(2);
    expect((await seenEvents(page)).map(({ type }) => type)).not.toContain('error');
    server.close();
  });

  test('set while it is out of the page is what it shows when it is back', async ({ page }) => {
    await open(page, plain);
    await settle(page);
    await forgetEvents(page);
    await withElement(page, async (element, src) => {
      element.remove();
      await new Promise(requestAnimationFrame);
      element.src = src;
      await element.updateComplete;
      document.body.append(element);
    }, { argument: ballUrl });
    expectSamePicture(await takePicture(page), drawReference({ volume: ball }));
    expect((await seenEvents(page)).filter(({ type }) => type === 'load')).toHaveLength(1);
  });

  test('asks for its file once', async ({ page }) => {
    const requests: string[] = [];
    page.on('request', (request) => requests.push(new URL(request.url()).pathname));
    await open(page, plain);
    await settle(page);
    expect(requests.filter((path) => path === fieldUrl)).toHaveLength(1);
    expect(requests.filter((path) => path.includes('decode-worker'))).toHaveLength(1);
    await withElement(page, async (element, src) => {
      element.src = src;
      await element.renderComplete;
    }, { argument: ballUrl });
    expect(requests.filter((path) => path === ballUrl)).toHaveLength(1);
  });

  test('in the same place keeps the view that a person chose', async ({ page }) => {
    await open(page, plain);
    await settle(page);
    await page.locator('.picture').press('ArrowLeft');
    await waitForEvent(page, 'camera-change');
    const before = await takePicture(page);
    await withElement(page, async (element) => {
      element.src = '/test/e2e/pages/data/field.nii';
      await element.renderComplete;
    });
    expect(compare(await takePicture(page), before).worst).toBe(0);
  });

  test('keeps the old picture until the new one is there', async ({ page }) => {
    await open(page, plain);
    const before = await takePicture(page);
    const server = await serveSlowly(files['ball.nii'], 0.5);
    await withElement(page, (element, src) => {
      element.src = src;
    }, { argument: server.url });
    await page.waitForFunction(() => window.__seen.some(({ detail }) => (detail as { total?: number }).total === 7264));
    const kept = await withElement(page, (element) => element.volume!.dimensions);
    expect(kept).toEqual([24, 20, 16]);
    await page.addStyleTag({ content: 'volume-view { background: black } volume-view::part(progress) { display: none }' });
    const onBlack = { ...before, data: before.data.map((x, i) => (i % 4 === 3 ? 255 : x)) };
    expect(compare(await takeScreenshot(page), onBlack).worst).toBeLessThanOrEqual(1);
    server.release();
    await settle(page);
    expectSamePicture(await takePicture(page), drawReference({ volume: ball }));
    server.close();
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
  const countContexts = (): Promise<number> => page.evaluate(() => (window as unknown as { countContexts(): number }).countContexts());
  await open(page, plain.repeat(3));
  for (let i = 0; i < 3; i++) await settle(page, `volume-view:nth-of-type(${i + 1})`);
  expect(await countContexts()).toBe(3);
  await page.evaluate(() => document.querySelectorAll('volume-view').forEach((element) => element.remove()));
  expect(await countContexts()).toBe(0);
});

test('eight elements at once, all with their own pictures', async ({ page }) => {
  const body = Array.from({ length: 8 }, (_, i) =>
    `<volume-view id="v${i}" src="${i % 2 ? ballUrl : fieldUrl}" ${attributesOf({ steps: String(40 + i) })}></volume-view>`).join('');
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
    element.shadowRoot!.querySelector('canvas')!.getContext('webgl2')!.getExtension('WEBGL_lose_context')!.loseContext());
  await waitForEvent(page, 'render');
  expect(compare(await takePicture(page), before).worst).toBe(0);
  expect((await seenEvents(page)).filter(({ type }) => type === 'error')).toEqual([]);
  await page.locator('.picture').press('0');
  await settle(page);
  expectSamePicture(await takePicture(page), drawReference());
});
