// Where the camera goes by itself: ways on which attributes send it, limits, turning by itself, the letters of the sides; and the line under a picture that is refined.
import type { Page } from '@playwright/test';
import { findFaults } from './helpers/axe.ts';
import {
  expect,
  fewPixels,
  fieldUrl,
  forgetEvents,
  keptTest as test,
  open,
  seenEvents,
  setAttributes,
  settle,
  takePicture,
  test as newPageTest,
  withElement,
} from './helpers/harness.ts';
import { attributesOf } from './helpers/reference.ts';
import { look } from './helpers/scans.ts';

const large = { head: '<style>volume-view { width: 320px; height: 240px }</style>' };
const view = (more = ''): string =>
  `<main><h1>A field</h1><volume-view src="${fieldUrl}" ${attributesOf({ steps: '10' })} alt="A field" ${more}></volume-view></main>`;

const degrees = (page: Page): Promise<{ theta: number; phi: number; radius: number }> =>
  withElement(page, ({ camera }) => {
    const { theta, phi, radius } = camera!.orbit;
    return { theta: (theta * 180) / Math.PI, phi: (phi * 180) / Math.PI, radius };
  });

test.use(fewPixels);

test.describe('ways', () => {
  test('an attribute sends the camera on a way that passes between, and does not report that a person moved it; pictures wait for its end', async ({
    page,
  }) => {
    await open(page, view('interpolation-decay="300"'), large);
    await settle(page);
    await forgetEvents(page);
    const seen = await withElement(page, async (element) => {
      const list: number[] = [];
      element.addEventListener('render', () => list.push((element.camera!.orbit.theta * 180) / Math.PI));
      element.cameraOrbit = '95deg 65deg 90';
      await element.whenRendered();
      return list;
    });
    expect(seen.filter((theta) => theta > 36 && theta < 94).length).toBeGreaterThan(2);
    expect(seen.at(-1)).toBeCloseTo(95, 6);
    expect((await seenEvents(page)).filter(({ type }) => type === 'camera-change')).toEqual([]);
    const { theta, said } = await withElement(page, async (element) => {
      element.cameraOrbit = '35deg 65deg 90';
      await element.toBlob();
      return { theta: (element.camera!.orbit.theta * 180) / Math.PI, said: element.cameraOrbit };
    });
    expect(theta).toBeCloseTo(35, 6);
    expect(said).toBe('35deg 65deg 90');
  });

  test('jumpCameraToGoal and interpolation-decay="0" end it at once; so does less motion', async ({ page }) => {
    await open(page, view('interpolation-decay="5000"'), large);
    await settle(page);
    const jump = (): Promise<number[]> =>
      withElement(page, async (element) => {
        const list: number[] = [];
        element.addEventListener('render', () => list.push(Math.round((element.camera!.orbit.theta * 180) / Math.PI)));
        element.cameraOrbit = element.cameraOrbit === '35deg 65deg 90' ? '95deg 65deg 90' : '35deg 65deg 90';
        if (element.interpolationDecay !== 0) element.jumpCameraToGoal();
        await element.whenRendered();
        return [...new Set(list)];
      });
    expect(await jump()).toEqual([95]);
    await setAttributes(page, { 'interpolation-decay': '0' });
    expect(await jump()).toEqual([35]);
    await page.emulateMedia({ reducedMotion: 'reduce' });
    await setAttributes(page, { 'interpolation-decay': '5000' });
    const began = Date.now();
    await setAttributes(page, { 'camera-orbit': '95deg 65deg 90' });
    expect((await degrees(page)).theta).toBeCloseTo(95, 6);
    expect(Date.now() - began).toBeLessThan(5000);
    await page.emulateMedia({ reducedMotion: null });
  });

  test('the wheel never loses the volume: twelve clicks of it at an edge', async ({ page }) => {
    await open(page, view('controls'), large);
    await settle(page);
    await page.mouse.move(300, 100);
    await page.mouse.click(300, 100);
    for (let i = 0; i < 12; i++) await page.mouse.wheel(0, 100);
    await settle(page);
    const { orbit, target } = await withElement(page, ({ camera }) => camera!);
    // Four times the distance at which 0.68 of the sphere around the 24 x 30 x 32 mm of the field just fits into 32 degrees; it stood at 90.
    expect(orbit.radius).toBeLessThanOrEqual(
      (4 * 0.68 * Math.hypot(12, 15, 16)) / Math.sin((16 * Math.PI) / 180) + 1e-6,
    );
    expect(Math.hypot(...target)).toBeLessThan(1e-6);
  });

  test('min-camera-orbit and max-camera-orbit hold for hands and attributes, and say what is wrong with them', async ({
    page,
  }) => {
    await open(page, view('min-camera-orbit="0deg 45deg 80" max-camera-orbit="60deg 90deg 160%"'), large);
    await settle(page);
    for (let i = 0; i < 12; i++) await page.locator('.picture').press('ArrowDown');
    for (let i = 0; i < 12; i++) await page.locator('.picture').press('ArrowLeft');
    for (let i = 0; i < 12; i++) await page.locator('.picture').press('+');
    await settle(page);
    const hand = await degrees(page);
    expect([Math.round(hand.theta), Math.round(hand.phi)]).toEqual([60, 45]);
    expect(hand.radius).toBeCloseTo(80, 6);
    await setAttributes(page, { 'camera-orbit': '-90deg 170deg 300' });
    const placed = await degrees(page);
    expect([Math.round(placed.theta), Math.round(placed.phi)]).toEqual([0, 90]);
    expect(placed.radius).toBeCloseTo((1.6 * 0.68 * Math.hypot(12, 15, 16)) / Math.sin((16 * Math.PI) / 180), 4);
    const message = await withElement(page, async (element) => {
      const failed = new Promise<string>((resolve) =>
        element.addEventListener('error', ({ detail }) => resolve(detail.message), { once: true }),
      );
      element.maxCameraOrbit = '60deg 90deg';
      return failed;
    });
    expect(message).toMatch(/^max-camera-orbit got "60deg 90deg"; expected three parts/);
    await setAttributes(page, { 'max-camera-orbit': null });
    await expect(page.locator('volume-view').getByRole('alert')).toHaveCount(0);
  });
});

test.describe('turning by itself', () => {
  const turning = view('auto-rotate auto-rotate-delay="100" rotation-per-second="1rad"');
  const isTurning = async (page: Page): Promise<boolean> => {
    const thetas = [];
    for (let i = 0; i < 3; i++) {
      thetas.push((await degrees(page)).theta);
      await page.waitForTimeout(150);
    }
    return Math.abs(thetas[2] - thetas[0]) > 0.5;
  };

  test('goes on until a hand comes, and again after that; a button stops it, and a script can wait for a picture', async ({
    page,
  }) => {
    await open(page, turning, large);
    await settle(page);
    await expect.poll(() => isTurning(page)).toBe(true);
    await settle(page); // It is no change that somebody could wait for.
    await forgetEvents(page);
    await page.waitForTimeout(200);
    expect(
      (await seenEvents(page)).filter(({ type }) => type === 'camera-change'),
      'nobody moved it',
    ).toEqual([]);
    expect(
      await withElement(page, (element) => element.cameraOrbit === element.getAttribute('camera-orbit')),
      'it tells where it is',
    ).toBe(false);
    // A finger on it holds it.
    await page.mouse.move(100, 150);
    await page.mouse.down();
    await page.waitForTimeout(300);
    expect(await isTurning(page)).toBe(false);
    await page.mouse.up();
    await expect.poll(() => isTurning(page)).toBe(true);
    const element = page.locator('volume-view');
    await element.getByRole('button', { name: 'Stop turning' }).click();
    expect(await isTurning(page)).toBe(false);
    await settle(page);
    expect(await withElement(page, ({ renderStats }) => renderStats!.converged), 'a final picture').toBe(true);
    await page.waitForTimeout(300);
    expect(await isTurning(page), 'it stays').toBe(false);
    expect(await findFaults(page)).toEqual([]);
    await element.getByRole('button', { name: 'Turn by itself' }).click();
    expect(await isTurning(page)).toBe(true);
    await setAttributes(page, { 'auto-rotate': null });
    expect(await isTurning(page)).toBe(false);
    await expect(element.getByRole('button')).toHaveCount(0);
  });

  test('not under less motion, unless a person wants it', async ({ page }) => {
    await page.emulateMedia({ reducedMotion: 'reduce' });
    await open(page, turning, large);
    await settle(page);
    await page.waitForTimeout(500);
    expect(await isTurning(page)).toBe(false);
    await page.locator('volume-view').getByRole('button', { name: 'Turn by itself' }).click();
    expect(await isTurning(page)).toBe(true);
    await page.emulateMedia({ reducedMotion: null });
  });

  test('not out of sight', async ({ page }) => {
    await open(page, `${turning}<div style="height: 4000px"></div>`, large);
    await settle(page);
    await expect.poll(() => isTurning(page)).toBe(true);
    await page.evaluate(() => scrollTo(0, 2000));
    await page.waitForTimeout(300);
    expect(await isTurning(page)).toBe(false);
    await page.evaluate(() => scrollTo(0, 0));
    await expect.poll(() => isTurning(page)).toBe(true);
  });

  test('a speed that is none is reported', async ({ page }) => {
    await open(page, view('auto-rotate rotation-per-second="fast"'), large);
    await expect(page.locator('volume-view').getByRole('alert')).toContainText(
      'rotation-per-second got "fast"; expected an angle such as 10deg',
    );
  });
});

test.describe('the orientation marker', () => {
  const letters = (page: Page): Promise<{ text: string; x: number; y: number }[]> =>
    page
      .locator('volume-view')
      .locator('.marker button')
      .evaluateAll((all) => {
        // The letters come with code of their own.
        if (all.length === 0) return [];
        const around = all[0].parentElement!.getBoundingClientRect();
        return all.map((one) => {
          const { left, top, width, height } = one.getBoundingClientRect();
          return {
            text: one.textContent.trim(),
            x: left + width / 2 - around.left - around.width / 2,
            y: top + height / 2 - around.top - around.height / 2,
          };
        });
      });

  test("shows a patient's letters as they lie in the picture, and turns to the one that is pressed", async ({
    page,
  }) => {
    await open(page, view('orientation-marker').replace('35deg 65deg 90', '0deg 90deg 90'), large);
    await settle(page);
    const element = page.locator('volume-view');
    await expect(element.locator('.marker button')).toHaveCount(6);
    const find = async (text: string): Promise<{ x: number; y: number }> =>
      (await letters(page)).find((one) => one.text === text)!;
    // From the front: a patient's left is on the right of the picture, the head above.
    expect((await find('L')).x).toBeGreaterThan(25);
    expect((await find('R')).x).toBeLessThan(-25);
    expect((await find('S')).y).toBeLessThan(-25);
    expect(await findFaults(page)).toEqual([]);
    await element.getByRole('button', { name: 'Left' }).click();
    await settle(page);
    expect((await degrees(page)).theta).toBeCloseTo(90, 3);
    await expect.poll(async () => (await find('A')).x).toBeLessThan(-25); // From a patient's left the face is on the left.
    await element.getByRole('button', { name: 'Top' }).focus();
    await page.keyboard.press('Enter');
    await settle(page);
    expect((await degrees(page)).phi).toBeCloseTo(0, 3);
    // Those behind are reached by keys too, and seen then.
    await element.getByRole('button', { name: 'Bottom' }).focus();
    expect(await element.getByRole('button', { name: 'Bottom' }).evaluate((one) => getComputedStyle(one).opacity)).toBe(
      '1',
    );
    await page.keyboard.press('Enter');
    await settle(page);
    expect((await degrees(page)).phi).toBeCloseTo(180, 3);
    await setAttributes(page, { 'orientation-marker': null });
    await expect(element.getByRole('button')).toHaveCount(0);
  });

  test('is not in pictures that are taken', async ({ page }) => {
    await open(page, view(), large);
    await settle(page);
    const without = await takePicture(page);
    await setAttributes(page, { 'orientation-marker': '' });
    await expect(page.locator('volume-view').locator('.marker')).toBeVisible();
    expect((await takePicture(page)).data).toEqual(without.data);
  });

  test('of a radar has the four winds', async ({ page }) => {
    await open(
      page,
      `<volume-view src="/demos/data/storm-radar-1500.json" ${look} orientation-marker alt="Scans"></volume-view>`,
      large,
    );
    await settle(page);
    await expect
      .poll(async () => new Set((await letters(page)).map(({ text }) => text)))
      .toEqual(new Set(['E', 'N', 'S', 'W']));
  });

  test('has no letters where the file does not say whose its axes are', async ({ page }) => {
    await open(
      page,
      `<volume-view src="/demos/data/mni152-t1.json" steps="10" orientation-marker controls alt="A mosaic"></volume-view>`,
      large,
    );
    await settle(page);
    await expect(page.locator('volume-view').getByRole('button', { name: 'Views' })).toBeVisible();
    expect(await withElement(page, ({ volume }) => volume!.anatomical ?? false)).toBe(false);
    await expect(page.locator('volume-view').locator('.marker')).toHaveCount(0);
  });
});

newPageTest(
  'a picture that takes long has a line that says so, with what is drawn of it, and which is in no picture',
  async ({ page }) => {
    // Much to draw: with software GL several seconds.
    await open(
      page,
      '<volume-view src="/demos/data/mni152-t1.nii.gz" max-error="0.1" style="width: 800px; height: 600px" alt="A head"></volume-view>',
    );
    const seen = await withElement(page, async (element) => {
      const reported: { at: number; share: string; hidden: boolean }[] = [];
      let rested = 0;
      element.addEventListener('render', ({ detail }) => (rested ||= detail.converged ? 0 : performance.now()));
      const root = element.shadowRoot!;
      const timer = setInterval(() => {
        const line = root.querySelector<HTMLElement>('.refining > div');
        if (line)
          reported.push({
            at: performance.now() - rested,
            share: line.style.getPropertyValue('--_share'),
            hidden: line.parentElement!.ariaHidden === 'true',
          });
      }, 50);
      await element.whenRendered();
      clearInterval(timer);
      return { reported, left: root.querySelectorAll('.refining').length, converged: element.renderStats!.converged };
    });
    expect(seen).toMatchObject({ left: 0, converged: true });
    expect(seen.reported.length).toBeGreaterThan(3);
    expect(seen.reported[0].at).toBeGreaterThan(900);
    expect(seen.reported.every(({ hidden }) => hidden)).toBe(true);
    const shares = seen.reported
      .map(({ share }) => share)
      .filter((share) => share !== '')
      .map(Number);
    expect(shares.length).toBeGreaterThan(1);
    expect(shares.every((share) => share >= 0 && share <= 1)).toBe(true);
  },
);
