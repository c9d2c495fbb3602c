import type { Page } from '@playwright/test';
import {
  compare,
  expect,
  fieldUrl,
  forgetEvents,
  open,
  setAttributes,
  settle,
  sharePage,
  takePicture,
  keptTest as test,
  test as newPageTest,
  waitForEvent,
  withElement,
} from './helpers/harness.ts';
import type { ErrorDetail } from '../../src/index.ts';
import { meanOf } from './helpers/pictures.ts';

/** Two sweeps, at 0.4 and 7 degrees, up to 10 km, of a radar 321 m above the sea. */
const radarUrl = '/test/fixtures/radar/odim-2.2.h5';

/** All values in colours from red to green; the volume itself is as good as not there. */
const looks = {
  'transfer-function': '-40 #f00 1%, 90 #0f0 1%',
  'opacity-factor': '0.001',
  steps: '40',
  rings: 'none',
  'camera-orbit': '20deg 50deg 100%',
};
const radar = (slices: string, changes: Record<string, string> = {}): string => {
  const attributes = Object.entries({ ...looks, ...changes }).map(([name, value]) => `${name}="${value}"`);
  return `<volume-view src="${radarUrl}" ${attributes.join(' ')}>${slices}</volume-view>`;
};

/** Mean opacity of the picture, 0..255. */
async function opacity(page: Page): Promise<number> {
  return meanOf(await takePicture(page))[3];
}

async function lastError(page: Page): Promise<ErrorDetail> {
  return (await waitForEvent(page, 'error')).detail as ErrorDetail;
}

const one = {
  ppi: '<volume-slice type="ppi" elevation="6"></volume-slice>',
  cappi: '<volume-slice type="cappi" height="800"></volume-slice>',
  rhi: '<volume-slice type="rhi" azimuth="60"></volume-slice>',
  section: '<volume-slice type="section" from="-6000 2000" to="6000 3000"></volume-slice>',
};

/** Put other slices in the place of those that are there. */
async function setSlices(page: Page, html: string): Promise<void> {
  await page.locator('volume-view').evaluate((element, slices) => (element.innerHTML = slices), html);
}

test.describe('alone', () => {
  const sharedPage = sharePage(radar(''));

  for (const [type, slice] of Object.entries(one))
    test(`a ${type} is in the picture, and hidden ones are not`, async () => {
      const page = sharedPage();
      await setSlices(page, slice);
      expect(await opacity(page)).toBeGreaterThan(1.2);
      await page.locator('volume-slice').evaluate((element) => element.setAttribute('hidden', ''));
      expect(await opacity(page)).toBeLessThan(0.5);
    });
});

test('what is changed of a slice is shown at once, by attribute and by property', async ({ page }) => {
  await open(page, radar(one.ppi));
  const steep = await takePicture(page);
  await withElement(page, async (element) => {
    await customElements.whenDefined('volume-slice');
    const slice = element.querySelector('volume-slice')!;
    slice.elevation = 1;
    await slice.updateComplete;
  });
  const flat = await takePicture(page);
  expect(compare(steep, flat).worst).toBeGreaterThan(60);
  await withElement(page, (element) => element.querySelector('volume-slice')!.setAttribute('sweep', '1'));
  expect(compare(steep, await takePicture(page)).worst, 'sweep wins, and 1 is the one at 7 degrees').toBe(0);
  await withElement(page, (element) => element.querySelector('volume-slice')!.remove());
  expect(await opacity(page)).toBeLessThan(1);
  await withElement(page, (element, html) => element.insertAdjacentHTML('beforeend', html), { argument: one.ppi });
  expect(compare(steep, await takePicture(page)).worst).toBe(0);
});

test('heights are above the sea', async ({ page }) => {
  await open(page, radar('<volume-slice type="cappi" height="350"></volume-slice>'));
  const low = await opacity(page);
  await setHeight(page, '290');
  expect(await opacity(page), 'below the antenna there is nothing').toBeLessThan(1);
  await setHeight(page, '1400');
  expect(await opacity(page), 'narrower above the lowest beam').toBeLessThan(0.8 * low);
});

async function setHeight(page: Page, height: string): Promise<void> {
  await withElement(page, (element, value) => element.querySelector('volume-slice')!.setAttribute('height', value), {
    argument: height,
  });
  await settle(page);
}

const mistakes: Record<string, { slice: string; says: RegExp }> = {
  'no type': {
    slice: '<volume-slice></volume-slice>',
    says: /^type of a volume-slice got ""; expected ppi, cappi, rhi or section/,
  },
  'an elevation in words': {
    slice: '<volume-slice type="ppi" elevation="low"></volume-slice>',
    says: /^elevation of volume-slice type="ppi" got "low"; expected degrees/,
  },
  'a sweep that is not there': {
    slice: '<volume-slice type="ppi" sweep="2"></volume-slice>',
    says: /^sweep of volume-slice type="ppi" got "2"; expected a whole number from 0 to 1/,
  },
  'no height': {
    slice: '<volume-slice type="cappi"></volume-slice>',
    says: /^height of volume-slice type="cappi" got ""; expected metres above sea level/,
  },
  'an azimuth in words': {
    slice: '<volume-slice type="rhi" azimuth="SW"></volume-slice>',
    says: /^azimuth of volume-slice type="rhi" got "SW"; expected degrees clockwise from north/,
  },
  'half a point': {
    slice: '<volume-slice type="section" from="1" to="2 3"></volume-slice>',
    says: /^from of volume-slice type="section" got "1"; expected metres east and north/,
  },
  'a line of no length': {
    slice: '<volume-slice type="section" from="2 3" to="2 3"></volume-slice>',
    says: /^to of volume-slice type="section" got "2 3"; expected another point/,
  },
  'too many': { slice: one.ppi.repeat(5), says: /^volume-view got 5 volume-slice elements; expected at most 4/ },
};

test.describe('mistakes', () => {
  const sharedPage = sharePage(radar(''));

  for (const [name, { slice, says }] of Object.entries(mistakes))
    test(`${name}: an error names the slice, and the others are drawn`, async () => {
      const page = sharedPage();
      await setSlices(page, slice + one.cappi);
      const { code, message } = await lastError(page);
      expect(code).toBe('attribute/invalid');
      expect(message.replace('got 6', 'got 5')).toMatch(says);
      await forgetEvents(page);
      await page.locator('volume-slice').evaluateAll((all) => all.slice(0, -1).forEach((element) => element.remove()));
      expect(await opacity(page)).toBeGreaterThan(3);
    });
});

test("a volume that is not a radar's has no slices and no rings, and says so", async ({ page }) => {
  await open(page, `<volume-view src="${fieldUrl}" steps="20">${one.cappi}</volume-view>`);
  expect((await lastError(page)).message).toContain('volume-slice type="cappi" got a volume that is not a radar\'s');
  await page.locator('volume-slice').evaluate((slice) => slice.remove());
  await forgetEvents(page);
  await page.locator('volume-view').evaluate((element) => element.setAttribute('rings', ''));
  expect((await lastError(page)).message).toContain('rings got ""; expected a radar scan');
});

test('a region alone is shown, and framed', async ({ page }) => {
  await open(page, radar(one.ppi, { 'camera-orbit': '0deg 0deg 100%' }));
  const all = await takePicture(page);
  const stats = await withElement(page, (element) => element.renderStats!);
  await setAttributes(page, { region: '1000 1000 0 5000 5000 2000' });
  const part = await takePicture(page);
  expect(compare(all, part).worst).toBeGreaterThan(60);
  expect(meanOf(part)[3]).toBeGreaterThan(3);
  expect((await withElement(page, (element) => element.renderStats!)).stepLength).toBeLessThan(stats.stepLength / 2);
  await setAttributes(page, { region: null });
  expect(compare(all, await takePicture(page)).worst).toBe(0);
});

test("regions that can't be read, or hold nothing, are an error", async ({ page }) => {
  await open(page, radar(one.ppi, { region: '1 2 3' }));
  expect((await lastError(page)).message).toMatch(/^region got "1 2 3"; expected 6 numbers/);
  await settle(page).catch(() => {});
  await forgetEvents(page);
  await page.locator('volume-view').evaluate((element) => element.setAttribute('region', '90000 0 0 99000 1000 1000'));
  expect((await lastError(page)).message).toMatch(
    /^region got "90000 .*"; expected two opposite corners of a box that holds some of the volume/,
  );
});

test('rings stand around the radar with their distances, and north', async ({ page }) => {
  await open(page, radar('', { rings: '', 'camera-orbit': '180deg 0deg 140%', style: 'width: 800px; height: 600px' }));
  await settle(page);
  const labels = page.locator('volume-view .labels span');
  expect(await labels.allTextContents()).toEqual(['2 km', '4 km', '6 km', '8 km', '10 km', 'N']);
  const boxes = await Promise.all((await labels.all()).map(async (label) => (await label.boundingBox())!));
  const view = (await page.locator('volume-view').boundingBox())!;
  const center = [view.x + view.width / 2, view.y + view.height / 2];
  const middles = boxes.map((box) => [box.x + box.width / 2 - center[0], box.y + box.height / 2 - center[1]]);
  // Seen from above with north up: distances to the right in proportion, N straight up.
  expect(middles[1][0] / middles[0][0]).toBeCloseTo(2, 1);
  expect(Math.abs(middles[1][1])).toBeLessThan(1);
  expect(Math.abs(middles[5][0])).toBeLessThan(1);
  expect(middles[5][1]).toBeLessThan(-10);
  expect(await opacity(page)).toBeGreaterThan(2);
  await setAttributes(page, { rings: '5' });
  expect(await labels.allTextContents()).toEqual(['5 km', '10 km', 'N']);
  await setAttributes(page, { rings: 'none' });
  expect(await labels.count()).toBe(0);
  expect(await opacity(page)).toBeLessThan(1);
});

test('labels at the edge of the picture are moved so far that all of them is read', async ({ page }) => {
  await open(page, radar('', { rings: '', 'camera-orbit': '180deg 0deg 140%' }));
  await settle(page);
  const picture = (await page.locator('volume-view').boundingBox())!;
  let atEdge = 0;
  // North goes over the upper edge, and the rings' labels over the right one.
  for (const distance of [100, 90, 80, 70, 60, 50]) {
    await setAttributes(page, { 'camera-orbit': `180deg 0deg ${distance}%` });
    for (const label of await page.locator('volume-view .labels span:not([hidden])').all()) {
      const { x, y, width, height } = (await label.boundingBox())!;
      expect(
        Math.min(
          x - picture.x,
          y - picture.y,
          picture.x + picture.width - x - width,
          picture.y + picture.height - y - height,
        ),
      ).toBeGreaterThan(2);
      const place = await label.evaluate(({ style: { left, top } }) => [left, top].map(parseFloat));
      if (
        Math.abs(x + width / 2 - picture.x - (picture.width * place[0]) / 100) > 1 ||
        Math.abs(y + height / 2 - picture.y - (picture.height * place[1]) / 100) > 1
      )
        atEdge++;
    }
  }
  expect(atEdge, 'labels that had to be moved').toBeGreaterThan(0);
});

test('rings are cut to the region, and their labels stand in it', async ({ page }) => {
  await open(page, radar('', { rings: '2', region: '1000 1000 0 7000 6000 3000', 'camera-orbit': '180deg 0deg 140%' }));
  await settle(page);
  const labels = page.locator('volume-view .labels span');
  // The region's corners are 1.4 and 9.2 km away; the line to the north is outside.
  expect(await labels.allTextContents()).toEqual(['2 km', '4 km', '6 km', '8 km']);
  const view = (await page.locator('volume-view').boundingBox())!;
  for (const label of await page.locator('volume-view .labels span:not([hidden])').all()) {
    const box = (await label.boundingBox())!;
    expect(Math.abs(box.x + box.width / 2 - view.x - view.width / 2)).toBeLessThan(view.width / 2);
    expect(Math.abs(box.y + box.height / 2 - view.y - view.height / 2)).toBeLessThan(view.height / 2);
  }
  await setAttributes(page, { region: '-3000 1000 0 3000 6000 3000' });
  expect(await labels.allTextContents()).toEqual(['2 km', '4 km', '6 km', 'N']);
  await setAttributes(page, { rings: '' });
  expect(await labels.allTextContents()).toEqual(['1 km', '2 km', '3 km', '4 km', '5 km', '6 km', 'N']);
});

test('rings of a wrong distance are an error', async ({ page }) => {
  await open(page, radar('', { rings: '500' }));
  expect((await lastError(page)).message).toMatch(/^rings got "500"; expected kilometres from ring to ring/);
});

test.describe("planes through a volume that is no radar's", () => {
  const plane = (attributes: string): string => `<volume-slice ${attributes}></volume-slice>`;
  const view = `<volume-view src="${fieldUrl}" opacity-factor="0" steps="40" camera-orbit="20deg 50deg 100%"></volume-view>`;

  newPageTest('are in the picture, move by attribute and by property, and are not when hidden', async ({ page }) => {
    const asked: string[] = [];
    page.on('request', (request) => asked.push(request.url()));
    await open(page, view);
    expect(await opacity(page)).toBeLessThan(0.5);
    const before = asked.length;
    await setSlices(page, plane('type="axial"'));
    const middle = await takePicture(page);
    expect(meanOf(middle)[3]).toBeGreaterThan(20);
    expect(asked.length, 'what draws them is loaded with the first one').toBeGreaterThan(before);
    await withElement(page, async (element) => {
      await customElements.whenDefined('volume-slice');
      const slice = element.querySelector('volume-slice')!;
      slice.at = 4;
      await slice.updateComplete;
    });
    expect(compare(middle, await takePicture(page)).worst).toBeGreaterThan(60);
    await withElement(page, (element) => element.querySelector('volume-slice')!.setAttribute('value-window', '0 2000'));
    const dark = await takePicture(page);
    expect(meanOf(dark)[0]).toBeLessThan(meanOf(middle)[0] / 2);
    await setSlices(page, plane('type="axial" hidden'));
    expect(await opacity(page)).toBeLessThan(0.5);
  });

  test('that can not be read are reported, and the others stay', async ({ page }) => {
    await open(page, view.replace('></', `>${plane('type="oblique" normal="0 0 0"')}${plane('type="coronal"')}</`));
    expect(await lastError(page)).toMatchObject({
      code: 'attribute/invalid',
      message: expect.stringContaining('may not be 0 0 0'),
    });
    await withElement(page, (element) => element.querySelector('volume-slice')!.remove());
    expect(await opacity(page)).toBeGreaterThan(10);
  });
});
