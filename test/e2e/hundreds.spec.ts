// What a long life brings: many contexts lost one after the other, many sources. LOSSES=100 loses so many; it takes two minutes.
import {
  compare,
  expect,
  fieldUrl,
  open,
  seenEvents,
  settle,
  takePicture,
  test,
  waitForEvent,
  withElement,
} from './helpers/harness.ts';
import { attributesOf } from './helpers/reference.ts';

const losses = Number(process.env.LOSSES ?? 10);

const plain = `<volume-view src="${fieldUrl}" ${attributesOf({ steps: '20' })} alt="A field"></volume-view>`;

test('contexts are lost one after the other, and each time the same picture comes back', async ({ page }) => {
  test.setTimeout(60_000 + 5000 * losses);
  await open(page, plain);
  await settle(page);
  const before = await takePicture(page);
  for (let times = 1; times <= losses; times++) {
    const since = await page.evaluate(() => window.__seen.length);
    await withElement(page, (element) =>
      element
        .shadowRoot!.querySelector('canvas')!
        .getContext('webgl2')!
        .getExtension('WEBGL_lose_context')!
        .loseContext(),
    );
    await waitForEvent(page, 'render', { since });
    if (times % 5 === 0) expect(compare(await takePicture(page), before).worst, `after ${times}`).toBe(0);
  }
  expect((await seenEvents(page)).filter(({ type }) => type === 'error')).toEqual([]);
  expect(await withElement(page, (element) => element.shadowRoot!.querySelectorAll('canvas').length)).toBe(1);
});

test('200 sources one after the other leave one picture, one canvas and no address of a blob', async ({ page }) => {
  await page.addInitScript(() => {
    const alive = ((window as unknown as { alive: Set<string> }).alive = new Set<string>());
    const [create, revoke] = [URL.createObjectURL.bind(URL), URL.revokeObjectURL.bind(URL)];
    URL.createObjectURL = (source) => {
      const url = create(source);
      alive.add(url);
      return url;
    };
    URL.revokeObjectURL = (url) => {
      alive.delete(url);
      revoke(url);
    };
  });
  await open(page, plain);
  await settle(page);
  const before = await takePicture(page);
  await withElement(
    page,
    async (element, url) => {
      for (let i = 1; i <= 200; i++) {
        element.src = i === 200 ? url : `${url}?${i}`;
        // Some are waited for, some are overtaken.
        if (i % 10 === 0) await element.whenRendered();
        else if (i % 3 === 0) await new Promise((resolve) => setTimeout(resolve, 5));
      }
    },
    { argument: fieldUrl },
  );
  await settle(page);
  expect(compare(await takePicture(page), before).worst).toBe(0);
  expect((await seenEvents(page)).filter(({ type }) => type === 'error')).toEqual([]);
  expect(await withElement(page, (element) => element.shadowRoot!.querySelectorAll('canvas').length)).toBe(1);
  await expect.poll(() => page.evaluate(() => (window as unknown as { alive: Set<string> }).alive.size)).toBe(0);
});
