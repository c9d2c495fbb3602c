// The curve of values over time in a <volume-readout>: what it shows, what is fetched for it, and what a person does with it.
import { readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import type { AddressInfo } from 'node:net';
import type { Locator, Page } from '@playwright/test';
import { decode } from 'fast-png';
import { findFaults } from './helpers/axe.ts';
import { expect, keptTest as test, networkLines, open, settle, withElement } from './helpers/harness.ts';
import { expectShown, listed, serve, several, timeOf } from './helpers/scans.ts';

const functional = readFileSync(new URL('../../demos/data/functional.nii', import.meta.url));

/** Of voxel 9 12 2 of functional.nii. Source: `nibabel.load(...).get_fdata()[9, 12, 2]` of nibabel 5.4.2, six digits. */
const course = [
  3545.36, 3591.28, 3710.28, 3638.79, 3603.5, 3522.97, 3536.16, 3512.18, 3642.56, 3682.9, 3646.41, 3661.79, 3661.49,
  3594.6, 3493.93, 3582.84, 3477.57, 3628.61, 3673.1, 3548.23,
];

const size = 'style="width: 240px; height: 180px"';
const brain = `<volume-view id="brain" src="/functional.nii" value-window="1500 6500" camera-orbit="0deg 1deg 90%" ${size} alt="Brain"></volume-view>`;

const curve = (page: Page): Locator => page.locator('volume-readout [part=curve]');
const slider = (page: Page): Locator => page.locator('volume-readout [part=curve-plot]');
const shownValue = (page: Page): Locator => page.locator('volume-readout [part=curve-value]');
const button = (page: Page): Locator => page.getByRole('button', { name: 'Over time' });

/** The table of all values. */
async function tableOf(page: Page): Promise<string[][]> {
  const details = page.locator('volume-readout details');
  if (!(await details.evaluate((element: HTMLDetailsElement) => element.open)))
    await page.locator('volume-readout [part=curve-table]').click();
  await expect(details.locator('tbody tr').first()).toBeVisible();
  return details
    .locator('tbody tr')
    .evaluateAll((rows) => rows.map((row) => [...row.children].map((cell) => cell.textContent?.trim() ?? '')));
}

/** Clicks the pixel under which a voxel is. */
async function clickVoxel(page: Page, voxel: readonly number[]): Promise<void> {
  const place = await withElement(
    page,
    async (element, [i, j, k]) => {
      for (let y = 4; y < element.clientHeight; y += 4)
        for (let x = 4; x < element.clientWidth; x += 4) {
          const pick = await element.pick(x, y);
          if (pick?.voxel?.[0] === i && pick.voxel[1] === j && pick.voxel[2] === k) return [x, y];
        }
      return null;
    },
    { argument: voxel },
  );
  expect(place, `voxel ${voxel.join(' ')} is in the picture`).not.toBe(null);
  const box = (await page.locator('volume-view').boundingBox())!;
  await page.mouse.click(box.x + place![0], box.y + place![1]);
  await page.mouse.move(box.x + box.width + 200, box.y + box.height + 100);
}

async function openBrain(
  page: Page,
  readout = '<volume-readout for="brain" curve></volume-readout>',
): Promise<string[]> {
  const asked: string[] = [];
  await page.route('**/functional.nii', (route) => {
    asked.push(route.request().headers().range ?? '');
    return route.fulfill({ body: functional, contentType: 'application/octet-stream' });
  });
  await open(page, `<main><h1>Brain</h1>${brain}${readout}</main>`);
  await settle(page);
  return asked;
}

test('has the values of a voxel at all times, as nibabel has them, without another request', async ({ page }) => {
  const asked = await openBrain(page);
  await expect(curve(page)).toHaveText(/Click a place in the picture/);
  await clickVoxel(page, [9, 12, 2]);
  await expect.poll(() => tableOf(page)).toEqual(course.map((value, t) => [`${2 * t} s`, String(value)]));
  await expect(shownValue(page)).toHaveText('0 s: 3545.36');
  await expect(curve(page).locator('p.hint')).toHaveText('From 3477.57 (32 s) to 3710.28 (4 s).');
  expect(await findFaults(page)).toEqual([]);
  expect(asked).toEqual(['']);
});

test('goes to the time that is clicked, pointed at, or reached by keys, and the readout has its value', async ({
  page,
}) => {
  await openBrain(page);
  await clickVoxel(page, [9, 12, 2]);
  await expect(slider(page)).toHaveAttribute('aria-valuetext', '0 s, scan 1 of 20: 3545.36');
  const value = page.locator('volume-readout [part=text]').first();
  const expectTime = async (index: number): Promise<void> => {
    await expectShown(page, index);
    await expect(shownValue(page)).toHaveText(`${2 * index} s: ${course[index]}`);
    await expect(slider(page)).toHaveAttribute('aria-valuenow', String(index + 1));
    await expect(value).toHaveText(String(course[index]));
    await expect(page.locator('volume-readout [part=text]').last()).toHaveText('9, 12, 2');
  };
  await slider(page).focus();
  for (const [key, index] of [
    ['ArrowRight', 1],
    ['ArrowUp', 2],
    ['End', 19],
    ['PageDown', 17],
    ['Home', 0],
    ['ArrowLeft', 0],
  ] as const) {
    await page.keyboard.press(key);
    await expectTime(index);
  }
  const box = (await slider(page).boundingBox())!;
  await page.mouse.move(box.x + (box.width * 16) / 19, box.y + 20);
  await expect(shownValue(page)).toHaveText('32 s: 3477.57');
  await expectShown(page, 0);
  await page.mouse.down();
  await page.mouse.move(box.x + (box.width * 4) / 19, box.y + 20, { steps: 3 });
  await page.mouse.up();
  await page.mouse.move(0, 0);
  await expectTime(4);
});

test('is offered where there are several times only, and nothing is read before somebody asks', async ({ page }) => {
  const { asked } = await serve(page);
  await open(page, `<volume-view ${several(8)} ${size}></volume-view><volume-readout></volume-readout>`);
  await settle(page);
  await expect(button(page)).toBeVisible();
  await expect(button(page)).toHaveAttribute('aria-pressed', 'false');
  await expect(curve(page)).toHaveCount(0);
  await expect.poll(() => new Set(asked)).toEqual(new Set([0, 1]));
  await page.mouse.click(125, 95);
  await page.mouse.move(600, 500);
  await expect(page.locator('volume-readout [part=text]').first()).toHaveText('0.0784314');
  expect(new Set(asked)).toEqual(new Set([0, 1]));
  await button(page).click();
  await expect(button(page)).toHaveAttribute('aria-pressed', 'true');
  expect(await page.locator('volume-readout').getAttribute('curve')).toBe('');
  await expect
    .poll(async () => (await tableOf(page)).map(([, value]) => value))
    .toEqual(Array.from({ length: 8 }, (_, i) => String(Number(Math.fround((20 + 20 * i) / 255).toPrecision(6)))));
  expect(new Set(asked)).toEqual(new Set([0, 1, 2, 3, 4, 5, 6, 7]));
  expect((await tableOf(page)).map(([time]) => time).slice(0, 2)).toEqual(['scan 1 of 8', 'scan 2 of 8']);
  await button(page).click();
  await expect(curve(page)).toHaveCount(0);
});

test.describe('with a scan that is missing', () => {
  test.use({ allowedLines: networkLines });
  test('has a gap there, and says so', async ({ page }) => {
    await serve(page, { missing: [5], manifest: listed(8) });
    await open(
      page,
      `<volume-view src="/scans/list.json" ${several(8).replace(/src="[^"]*"/, '')} ${size}></volume-view><volume-readout curve></volume-readout>`,
    );
    await settle(page);
    await page.mouse.click(125, 95);
    await page.mouse.move(600, 500);
    await expect(curve(page).locator('p.hint')).toContainText('Scans that could not be read: 1 of 8.');
    const rows = await tableOf(page);
    expect(rows.map(([, value]) => value === '–')).toEqual([0, 1, 2, 3, 4, 5, 6, 7].map((i) => i === 5));
    expect(rows[2][0]).toBe(`${timeOf(2).slice(11, 16)} UTC`);
    const line = (await curve(page).locator('.line').getAttribute('d'))!;
    expect(line.match(/M/g)).toHaveLength(2);
  });
});

test.describe('with scans that do not come', () => {
  test('shows how far it is, and begins again at another place', async ({ page }) => {
    const { asked, held } = await serve(page);
    for (const scan of [4, 5, 6, 7]) held.add(scan);
    await open(page, `<volume-view ${several(8)} ${size}></volume-view><volume-readout curve></volume-readout>`);
    await settle(page);
    await page.mouse.click(125, 95);
    await expect(curve(page).getByText('Reading all times: 50%')).toBeVisible();
    await expect.poll(() => asked.filter((scan) => scan === 4).length).toBe(1);
    await page.mouse.click(135, 95);
    await expect.poll(() => asked.filter((scan) => scan === 4).length).toBe(2);
    held.clear();
    await expect(curve(page).locator('progress')).toHaveCount(0);
    expect((await tableOf(page)).every(([, value]) => Number(value) > 0)).toBe(true);
    expect(asked.filter((scan) => scan === 7)).toHaveLength(1);
  });
});

test('asks a server that sends parts for the numbers of the voxel alone', async ({ page }) => {
  const asked: string[] = [];
  // Each volume of 2142 bytes begins 200,000 bytes after the last: voxels of far larger volumes.
  const [n, bytes] = [64, 64 * 64 * 24 * 2];
  const file = Buffer.alloc(352 + 12 * bytes);
  functional.copy(file, 0, 0, 352);
  [4, n, n, 24, 12].forEach((length, i) => file.writeInt16LE(length, 40 + 2 * i));
  for (let t = 0; t < 12; t++) file.fill(Buffer.from([100 + 10 * t, 0]), 352 + t * bytes, 352 + (t + 1) * bytes);
  file.writeFloatLE(1, 112);
  file.writeFloatLE(0, 116);
  const server = createServer(({ headers: { range = '' } }, response) => {
    asked.push(range);
    const [, start, end] = /bytes=(\d+)-(\d+)/.exec(range)?.map(Number) ?? [0, 0, file.length - 1];
    const part = file.subarray(start, end + 1);
    response.writeHead(range ? 206 : 200, {
      'content-length': part.length,
      'accept-ranges': 'bytes',
      'access-control-allow-origin': '*',
      'access-control-expose-headers': 'accept-ranges',
      ...(range && { 'content-range': `bytes ${start}-${end}/${file.length}` }),
    });
    response.end(part);
  });
  await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve));
  const { port } = server.address() as AddressInfo;
  try {
    await open(
      page,
      `<volume-view src="http://127.0.0.1:${port}/long.nii" value-window="0 250" transfer-function="0 #fff 100%, 250 #fff 100%" ${size} alt="Scans"></volume-view><volume-readout curve></volume-readout>`,
    );
    await settle(page);
    const before = asked.length;
    await page.mouse.click(125, 95);
    await expect(curve(page).locator('p.hint')).toHaveText('From 100 (0 s) to 210 (22 s).');
    const more = asked.slice(before).map((range) => /bytes=(\d+)-(\d+)/.exec(range)!.slice(1).map(Number));
    expect(more).toHaveLength(12);
    expect(more.every(([start, end]) => end - start === 1)).toBe(true);
  } finally {
    server.close();
  }
});

/** Numbers of one of the demo's scans: tiles of 360 radials and 400 gates, four a row; see its manifest. */
function gateOf(time: string, { sweep, radial, gate }: Record<'sweep' | 'radial' | 'gate', number>): number {
  const { data, width } = decode(readFileSync(new URL(`../../demos/data/storm-radar-${time}.png`, import.meta.url)));
  return 0.5 * data[(Math.floor(sweep / 4) * 360 + radial) * width + (sweep % 4) * 400 + gate] - 32.5;
}

test('has the value of one gate of a radar in each of three scans, as the pixels of their images say', async ({
  page,
}) => {
  const times = ['1500', '1510', '1520'];
  const src = times.map((time) => `/demos/data/storm-radar-${time}.json`).join(' ');
  await open(
    page,
    `<volume-view id="storm" src="${src}" ${size} alt="Storm"></volume-view><volume-readout for="storm" curve></volume-readout>`,
  );
  await settle(page);
  const places = await withElement(page, async (element) => {
    const all = [];
    for (let y = 20; y < element.clientHeight; y += 10)
      for (let x = 20; x < element.clientWidth; x += 10) {
        const pick = await element.pick(x, y);
        if (pick?.radar) all.push({ x, y, gate: pick.radar.gate });
      }
    return all;
  });
  // The storm moves: a place where each of the scans has a value, and none has the same as another.
  const found = places.find(({ gate }) => {
    const values = times.map((time) => gateOf(time, gate));
    return values.every((value) => value > -32.5) && new Set(values).size === times.length;
  });
  expect(found, 'a place with rain').toBeDefined();
  const box = (await page.locator('volume-view').boundingBox())!;
  await page.mouse.click(box.x + found!.x, box.y + found!.y);
  const read = async (): Promise<unknown[]> =>
    (await tableOf(page)).map(([time, value]) => [/15:[012]0/.exec(time)?.[0], Number.parseFloat(value)]);
  // One scan is opened after another.
  await expect.poll(read).toEqual(times.map((time) => [`15:${time.slice(2)}`, gateOf(time, found!.gate)]));
});
