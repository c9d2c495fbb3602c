// A video of scans in time, in an element with a timeline: the frame that is shown is the one that was asked for. `SEEKS=200` asks more often.
import type { Page } from '@playwright/test';
import { expect, open, test, withElement } from './helpers/harness.ts';
import { expectShown } from './helpers/scans.ts';

const seeks = Number(process.env.SEEKS ?? 15);
const frames = 60;

/** Each frame of the fixture has one number everywhere: see test/fixtures/make-video-fixtures.py. */
const numberOf = (frame: number): number => (37 * frame) % 256;

async function openVideo(page: Page): Promise<void> {
  const list = {
    video: '/test/fixtures/video/seek.webm',
    mosaic: '4x3',
    spacing: [1, 1, 1],
    scans: Array.from({ length: frames }, (_, i) => ({ time: `${i / 10} s` })),
  };
  await page.route('**/seek.json', (route) => route.fulfill({ json: list }));
  await open(
    page,
    `<volume-view src="/seek.json" value-window="0 255" transfer-function="0 #fff 100%, 1 #fff 100%" steps="16" alt="Numbers"></volume-view><volume-timeline></volume-timeline>`,
  );
  await expectShown(page, 0);
}

/** The value of the volume that is drawn. */
const drawn = (page: Page): Promise<number | undefined> =>
  withElement(page, async (element) => {
    await element.whenRendered();
    return (await element.pick(60, 45))?.value;
  });

/** As a person does who drags the knob. */
const dragTo = (page: Page, frame: number): Promise<void> =>
  page.getByRole('slider', { name: 'Scan' }).evaluate((slider: HTMLInputElement, value) => {
    slider.value = String(value);
    slider.dispatchEvent(new Event('input', { bubbles: true, composed: true }));
    slider.dispatchEvent(new Event('change', { bubbles: true, composed: true }));
  }, frame);

test(`the frame of the timeline is the frame that was asked for, in ${seeks} random seeks`, async ({ page }) => {
  test.setTimeout(60_000 + 2000 * seeks);
  await openVideo(page);
  expect(await drawn(page)).toBe(numberOf(0));
  let state = 1;
  const random = (): number => (state = (Math.imul(state, 1664525) + 1013904223) >>> 0) / 2 ** 32;
  for (let i = 0; i < seeks; i++) {
    // Every third time several are asked for at once, and the last one counts.
    for (let n = i % 3 === 2 ? 4 : 0; n > 0; n--) await dragTo(page, Math.floor(random() * frames));
    const frame = Math.floor(random() * frames);
    if (i % 2) await withElement(page, (element, time) => void (element.time = time), { argument: `${frame / 10} s` });
    else await dragTo(page, frame);
    await expectShown(page, frame);
    expect(await drawn(page), `seek ${i + 1}, frame ${frame}`).toBe(numberOf(frame));
  }
});
