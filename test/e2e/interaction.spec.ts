// What hands do beside turning: pan, zoom to the pointer, pinch; and what a script is told of where the camera is.
import type { Page } from '@playwright/test';
import { orbitCamera } from '../../src/optics/rays/camera.ts';
import type { Orbit } from '../../src/optics/rays/camera.ts';
import type { VolumeView } from '../../src/index.ts';
import { add, cross, length, normalize, scale, subtract } from '../../src/volume/matrix.ts';
import type { Vector3 } from '../../src/volume/matrix.ts';
import {
  compare,
  expect,
  expectSamePicture,
  fieldUrl,
  forgetEvents,
  open,
  seenEvents,
  setAttributes,
  settle,
  sharePage,
  takePicture,
  keptTest as test,
  withElement,
} from './helpers/harness.ts';
import { attributesOf, drawReference, plainCamera, plainOrbit } from './helpers/reference.ts';
import { serve, several } from './helpers/scans.ts';
import { line, touch } from './helpers/touch.ts';

const plain = `<volume-view src="${fieldUrl}" ${attributesOf()} alt="A field"></volume-view>`;
const tall = '<div style="height: 3000px"></div>';
const fieldOfView = (32 * Math.PI) / 180;
/** World length of half the picture's height, in the plane of what is looked at: 45 pixels. */
const halfHeight = plainOrbit.radius * Math.tan(fieldOfView / 2);

/** The camera at rest. */
async function readCamera(page: Page): Promise<NonNullable<VolumeView['camera']>> {
  await settle(page);
  return (await withElement(page, ({ camera }) => camera))!;
}

const reset = (page: Page): Promise<void> =>
  setAttributes(page, { 'camera-orbit': '35deg 65deg 90', 'camera-target': '0 0 0' });

/** Where the camera looks after a hand has moved what is seen by some pixels of the plain view. */
function targetAfter([right, up]: readonly [number, number]): Vector3 {
  const across = normalize(cross(plainCamera.up, subtract(plainCamera.eye, plainCamera.target)));
  return add(scale(across, (-right / 45) * halfHeight), scale(plainCamera.up, (-up / 45) * halfHeight));
}

function expectNear(got: Vector3, expected: Vector3, within = 1e-3): void {
  expect(length(subtract(got, expected)), `${got.join()} instead of ${expected.join()}`).toBeLessThan(within);
}

async function drag(
  page: Page,
  by: readonly [x: number, y: number],
  button: 'left' | 'middle' | 'right' = 'left',
): Promise<void> {
  await page.mouse.move(60, 45);
  await page.mouse.down({ button });
  await page.mouse.move(60 + by[0], 45 + by[1], { steps: 4 });
  await page.mouse.up({ button });
}

test.describe('a mouse and keys', () => {
  const sharedPage = sharePage(plain + tall);
  test.beforeEach(() => reset(sharedPage()));

  for (const button of ['right', 'middle'] as const)
    test(`the ${button} button moves what is seen with the hand`, async () => {
      const page = sharedPage();
      await drag(page, [18, 9], button);
      const { target, orbit } = await readCamera(page);
      expectNear(target, targetAfter([18, -9]));
      expect(orbit).toEqual(plainOrbit);
      expectSamePicture(
        await takePicture(page),
        drawReference({ camera: orbitCamera(plainOrbit, target, fieldOfView) }),
      );
      await page.locator('.picture').press('0');
      expectNear((await readCamera(page)).target, [0, 0, 0]);
    });

  test('so does the left one with Shift, and arrows with Shift', async () => {
    const page = sharedPage();
    await page.keyboard.down('Shift');
    await drag(page, [-12, 6]);
    await page.keyboard.up('Shift');
    expectNear((await readCamera(page)).target, targetAfter([-12, -6]));
    await reset(page);
    await page.locator('.picture').press('Shift+ArrowRight');
    await page.locator('.picture').press('Shift+ArrowUp');
    expectNear((await readCamera(page)).target, targetAfter([4.5, 4.5]));
  });

  test('however far it is moved, the volume is not lost', async () => {
    const page = sharedPage();
    for (let i = 0; i < 4; i++) await drag(page, [600, 300], 'middle');
    const { target } = await readCamera(page);
    expect(length(target), 'no farther from its middle than its corners').toBeCloseTo(Math.hypot(12, 15, 16), 1);
  });

  test('the wheel keeps in its place what is under the pointer', async () => {
    const page = sharedPage();
    await page.mouse.click(90, 30);
    await page.mouse.wheel(0, -300);
    const near = await readCamera(page);
    expect(near.orbit.radius).toBeCloseTo(plainOrbit.radius * 2 ** -0.5, 3);
    // What is seen goes away from the pointer as it grows, by as much as the pointer was off the middle.
    const grown = 1 - 2 ** -0.5;
    expectNear(near.target, scale(targetAfter([30, 15]), -grown));
    await page.mouse.wheel(0, 300);
    const back = await readCamera(page);
    expectNear(back.target, [0, 0, 0]);
    expect(back.orbit.radius).toBeCloseTo(plainOrbit.radius, 3);
  });

  test('a pinch on a trackpad, a wheel with Ctrl, is as strong as the fingers, and a notch of a real wheel is mild', async () => {
    const page = sharedPage();
    const zoom = async (pixels: number): Promise<number> => {
      const before = (await readCamera(page)).orbit.radius;
      await page.mouse.move(60, 45);
      await page.keyboard.down('Control');
      await page.mouse.wheel(0, pixels);
      await page.keyboard.up('Control');
      return Math.log((await readCamera(page)).orbit.radius / before);
    };
    expect(await zoom(-10)).toBeCloseTo(-0.1, 4);
    expect(await zoom(10)).toBeCloseTo(0.1, 4);
    expect(await zoom(-120)).toBeCloseTo(-0.25, 4);
    await reset(page);
    await page.mouse.click(60, 45);
    await page.mouse.wheel(0, -10);
    expect(Math.log((await readCamera(page)).orbit.radius / plainOrbit.radius)).toBeCloseTo(-0.1 / 8.656, 4);
  });

  test("PageDown and PageUp are the page's", async () => {
    const page = sharedPage();
    await page.locator('.picture').press('PageDown');
    await expect.poll(() => page.evaluate(() => scrollY)).toBeGreaterThan(100);
    // Pages glide, and a key during that is lost.
    await expect
      .poll(async () => {
        await page.keyboard.press('PageUp');
        return page.evaluate(() => scrollY);
      })
      .toBe(0);
    expect((await readCamera(page)).orbit).toEqual(plainOrbit);
  });

  test('focus() lets keys turn it', async () => {
    const page = sharedPage();
    await withElement(page, (element) => element.focus());
    await page.keyboard.press('ArrowLeft');
    expect((await readCamera(page)).orbit.theta).toBeGreaterThan(plainOrbit.theta + 0.05);
  });
});

test.describe('the context menu', () => {
  type Menus = typeof globalThis & { menus: { prevented: boolean; at: number[]; before: string }[] };

  /** A page that keeps what it hears of menus, and what came before each. */
  async function openWithMenus(page: Page): Promise<() => Promise<Menus['menus']>> {
    await open(page, plain);
    await settle(page);
    await page.evaluate(() => {
      const menus: Menus['menus'] = ((globalThis as Menus).menus = []);
      let last = '';
      for (const type of ['pointerdown', 'pointerup']) document.addEventListener(type, () => (last = type), true);
      document.addEventListener(
        'contextmenu',
        (event) => {
          queueMicrotask(() =>
            menus.push({ prevented: event.defaultPrevented, at: [event.clientX, event.clientY], before: last }),
          );
        },
        true,
      );
    });
    return () => page.evaluate(() => (globalThis as Menus).menus);
  }

  test('does not open for a drag, and does for a click, once it is no drag', async ({ page }) => {
    const menus = await openWithMenus(page);
    await drag(page, [20, 0], 'right');
    expect(await menus()).toEqual([]);
    expectNear((await readCamera(page)).target, targetAfter([20, 0]));
    await page.waitForTimeout(250);
    await page.mouse.click(61, 46, { button: 'right' });
    await expect.poll(menus).toEqual([{ prevented: false, at: [61, 46], before: 'pointerup' }]);
    expectNear((await readCamera(page)).target, targetAfter([20, 0]));
  });

  test("with Shift, and outside the picture, it is the browser's", async ({ page }) => {
    const menus = await openWithMenus(page);
    await page.keyboard.down('Shift');
    await page.mouse.click(61, 46, { button: 'right' });
    await page.keyboard.up('Shift');
    await page.mouse.click(400, 400, { button: 'right' });
    const seen = await menus();
    expect(seen.map(({ prevented, at }) => ({ prevented, at }))).toEqual([
      { prevented: false, at: [61, 46] },
      { prevented: false, at: [400, 400] },
    ]);
    expect((await readCamera(page)).target).toEqual([0, 0, 0]);
  });
});

test.describe('fingers', () => {
  test.use({ hasTouch: true });

  test('that scroll the page across the picture leave the camera as it was', async ({ page }) => {
    await open(
      page,
      `<div style="height: 300px"></div>${plain.replace('steps="30"', 'steps="8" style="width: 240px; height: 180px"')}${tall}`,
    );
    await settle(page);
    for (let i = 0; i < 3; i++) {
      const scrolled = await page.evaluate(() => scrollY);
      // A thumb goes up in a bow.
      await touch(page, [
        [
          [120, 420],
          [124, 415],
          [128, 408],
          [132, 398],
          [136, 385],
          [139, 370],
          [141, 350],
          [142, 330],
          [143, 300],
        ],
      ]);
      await expect.poll(() => page.evaluate(() => scrollY)).toBeGreaterThan(scrolled + 20);
      await page.evaluate(() => scrollTo(0, 0));
    }
    expect((await readCamera(page)).orbit).toEqual(plainOrbit);
    expect(await withElement(page, ({ cameraOrbit }) => cameraOrbit)).toBe('35deg 65deg 90');
  });

  test('two of them move what is seen, up and down too, and the page stays', async ({ page }) => {
    await open(page, plain + tall);
    await settle(page);
    await touch(page, [line([40, 60], [40, 24]), line([80, 60], [80, 24])]);
    const { target, orbit } = await readCamera(page);
    expect(await page.evaluate(() => scrollY)).toBe(0);
    expectNear(target, targetAfter([0, 36]), 0.5);
    expect(orbit.theta).toBe(plainOrbit.theta);
    expect(orbit.radius).toBeCloseTo(plainOrbit.radius, 0);
  });

  test('that pinch keep in its place what lies between them', async ({ page }) => {
    await open(page, plain + tall);
    await settle(page);
    await touch(page, [line([80, 45], [70, 45]), line([100, 45], [110, 45])]);
    const { target, orbit } = await readCamera(page);
    expect(orbit.radius).toBeCloseTo(plainOrbit.radius / 2, 0);
    expectNear(target, scale(targetAfter([30, 0]), -0.5), 0.5);
  });
});

test.describe('a script', () => {
  test('gets the place of the camera, and can set it again', async ({ page }) => {
    await open(page, `<volume-view src="${fieldUrl}" steps="40" alt="A field"></volume-view>`);
    const { orbit, target, eye, up, fieldOfView: angle } = await readCamera(page);
    const camera = orbitCamera(orbit, target, angle);
    expectNear(eye, camera.eye);
    expectNear(up, camera.up);
    const reported = await withElement(page, ({ cameraOrbit, cameraTarget }) => ({ cameraOrbit, cameraTarget }));
    expect(reported).toEqual({
      cameraOrbit: `30deg 75deg ${Number(orbit.radius.toFixed(5))}`,
      cameraTarget: target.map((x) => Number(x.toFixed(5))),
    });
    await page.locator('.picture').press('ArrowRight');
    await page.locator('.picture').press('Shift+ArrowUp');
    await readCamera(page);
    const turned = await withElement(page, ({ cameraOrbit }) => cameraOrbit);
    expect(turned).toMatch(/^22\.5deg 75deg /);
    expect(
      await page.locator('volume-view').getAttribute('camera-orbit'),
      'nothing is written into the page',
    ).toBeNull();

    const seen = await takePicture(page);
    const view = await withElement(page, (element) => element.getView());
    expect(Object.keys(view)).toEqual(['camera-orbit', 'camera-target', 'field-of-view']);
    await page.locator('.picture').press('Home');
    await settle(page);
    expect(compare(await takePicture(page), seen).worst).toBeGreaterThan(20);
    await setAttributes(page, view);
    expect(compare(await takePicture(page), seen).worst, 'rounded to a thousandth of a degree').toBeLessThanOrEqual(2);
  });

  test('that sets an attribute again gets there again', async ({ page }) => {
    await open(page, plain);
    await settle(page);
    await page.locator('.picture').press('ArrowRight');
    expect((await readCamera(page)).orbit.theta).toBeLessThan(plainOrbit.theta - 0.05);
    await withElement(page, (element) => {
      element.cameraOrbit = '35deg 65deg 90';
    });
    expect((await readCamera(page)).orbit).toEqual(plainOrbit);
    await forgetEvents(page);
    await setAttributes(page, { steps: '61' });
    expect((await seenEvents(page)).filter(({ type }) => type === 'camera-change')).toEqual([]);
  });

  test('gets a view from straight above, and from below', async ({ page }) => {
    await open(page, plain);
    for (const orbit of ['40deg 0deg 90', '-130deg 180deg 90']) {
      await setAttributes(page, { 'camera-orbit': orbit });
      expect((await withElement(page, (element) => element.getView()))['camera-orbit']).toBe(orbit);
    }
  });

  test("gets where a person went from an author's viewpoint", async ({ page }) => {
    const viewpoint =
      '<viewpoint position="0 80 0" orientation="0 0.70710678 0.70710678 3.14159265" fieldofview="0.5"></viewpoint>';
    await open(page, plain.replace('></volume-view>', `>${viewpoint}</volume-view>`));
    await settle(page);
    expect(await withElement(page, ({ cameraOrbit }) => cameraOrbit)).toBe('0deg 90deg 80');
    await page.locator('.picture').press('ArrowLeft');
    await settle(page);
    const { theta, phi, radius }: Orbit = (await readCamera(page)).orbit;
    expect([theta, phi, radius].map((x) => Number(x.toFixed(3)))).toEqual([0.131, 1.571, 80]);
    expect((await withElement(page, (element) => element.getView()))['camera-orbit']).toBe('7.5deg 90deg 80');
  });

  test("gets the editor's and the time line's changes as well", async ({ page }) => {
    await serve(page);
    await open(page, `<volume-view ${several(3)} opacity-factor="2"></volume-view>`);
    await settle(page);
    await withElement(page, (element) => element.next());
    await expect.poll(async () => (await withElement(page, (element) => element.getView())).time).toBe('1');
    await setAttributes(page, { 'transfer-function': '0 red 0, 1 blue 1', 'opacity-factor': '2', shading: 'lit' });
    expect(await withElement(page, (element) => element.getView()), 'not what the tag has already').toEqual({
      time: '1',
      'transfer-function': '0 red 0, 1 blue 1',
      shading: 'lit',
    });
  });
});
