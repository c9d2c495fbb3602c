import type { Page } from '@playwright/test';
import { orbitCamera } from '../../src/optics/rays/camera.ts';
import type { Orbit } from '../../src/optics/rays/camera.ts';
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
  waitForEvent,
  withElement,
} from './helpers/harness.ts';
import { attributesOf, drawReference, plainOrbit } from './helpers/reference.ts';
import { line, touch } from './helpers/touch.ts';

const plain = `<volume-view src="${fieldUrl}" ${attributesOf()} alt="A field"></volume-view>`;
const tall = '<div style="height: 3000px"></div>';

/** The orbit at rest after what a test did since it last forgot the events. */
async function readOrbit(page: Page): Promise<Orbit> {
  await waitForEvent(page, 'camera-change');
  await settle(page);
  const moves = (await seenEvents(page)).filter(({ type }) => type === 'camera-change');
  return (moves.at(-1)!.detail as { orbit: Orbit }).orbit;
}

async function openAndForget(page: Page, body = plain): Promise<void> {
  await open(page, body);
  await settle(page);
  await forgetEvents(page);
}

/** The picture on the canvas is that of an orbit. */
async function expectPictureFrom(page: Page, orbit: Orbit): Promise<void> {
  const camera = orbitCamera(orbit, [0, 0, 0], (32 * Math.PI) / 180);
  expectSamePicture(await takePicture(page), drawReference({ camera }));
}

test.describe('keyboard', () => {
  const turns: Record<string, (now: Orbit) => void> = {
    ArrowLeft: ({ theta }) => expect(theta).toBeGreaterThan(plainOrbit.theta + 0.05),
    ArrowRight: ({ theta }) => expect(theta).toBeLessThan(plainOrbit.theta - 0.05),
    ArrowUp: ({ phi }) => expect(phi).toBeGreaterThan(plainOrbit.phi + 0.05),
    ArrowDown: ({ phi }) => expect(phi).toBeLessThan(plainOrbit.phi - 0.05),
    '+': ({ radius }) => expect(radius).toBeLessThan(plainOrbit.radius * 0.95),
    '-': ({ radius }) => expect(radius).toBeGreaterThan(plainOrbit.radius * 1.05),
  };
  test.describe('one key after the other', () => {
    const sharedPage = sharePage(plain);

    for (const [key, check] of Object.entries(turns))
      test(`${key} moves the camera, 0 brings it back`, async () => {
        const page = sharedPage();
        await page.mouse.click(400, 400); // Beside the element, where Tab begins anew.
        await page.keyboard.press('Tab');
        await page.keyboard.press(key);
        const orbit = await readOrbit(page);
        check(orbit);
        await expectPictureFrom(page, orbit);
        await page.keyboard.press('0');
        await settle(page);
        await expectPictureFrom(page, plainOrbit);
      });
  });

  test('other keys, and shortcuts of the browser, are left alone', async ({ page }) => {
    await openAndForget(page, plain + tall);
    await page.keyboard.press('Tab');
    await page.keyboard.press('a');
    await page.keyboard.press('Control+ArrowLeft');
    await page.keyboard.press('Space');
    await expect.poll(() => page.evaluate(() => scrollY)).toBeGreaterThan(0);
    expect(await seenEvents(page)).toEqual([]);
  });

  test('the camera glides, and with reduced motion it is there at once', async ({ page }) => {
    await openAndForget(page);
    await page.locator('.picture').press('ArrowLeft');
    const goal = await readOrbit(page);
    expect((await seenEvents(page)).filter(({ type }) => type === 'camera-change').length).toBeGreaterThan(2);
    await setAttributes(page, { 'camera-orbit': '35deg 65deg 90' });
    await page.emulateMedia({ reducedMotion: 'reduce' });
    await settle(page);
    await setAttributes(page, { 'camera-orbit': '35deg 65deg 91' });
    await forgetEvents(page);
    await page.locator('.picture').press('ArrowLeft');
    expect((await readOrbit(page)).theta).toBeCloseTo(goal.theta, 10);
    expect((await seenEvents(page)).filter(({ type }) => type === 'camera-change')).toHaveLength(1);
  });
});

test.describe('mouse', () => {
  test('a drag turns the volume with the hand, a double click brings it back', async ({ page }) => {
    await openAndForget(page);
    await page.mouse.move(60, 45);
    await page.mouse.down();
    await page.mouse.move(80, 35, { steps: 4 });
    await page.mouse.up();
    const orbit = await readOrbit(page);
    // To the right, so the eye goes to the left; up, so the eye goes down.
    expect(orbit.theta).toBeLessThan(plainOrbit.theta - 0.2);
    expect(orbit.phi).toBeGreaterThan(plainOrbit.phi + 0.1);
    expect(orbit.radius).toBeCloseTo(plainOrbit.radius, 6);
    await expectPictureFrom(page, orbit);
    await page.mouse.dblclick(60, 45);
    await settle(page);
    await expectPictureFrom(page, plainOrbit);
  });

  test('a drag that leaves the element goes on, and ends outside', async ({ page }) => {
    await openAndForget(page);
    await page.mouse.move(60, 45);
    await page.mouse.down();
    await page.mouse.move(400, 45, { steps: 4 });
    await page.mouse.up();
    const orbit = await readOrbit(page);
    expect(orbit.theta).toBeLessThan(plainOrbit.theta - 5);
    await forgetEvents(page);
    await page.mouse.move(60, 45);
    await page.mouse.move(90, 60);
    await settle(page);
    expect(await seenEvents(page)).toEqual([]);
  });

  test('the wheel scrolls the page; after a click, or with Ctrl, it zooms', async ({ page }) => {
    await openAndForget(page, plain + tall);
    const scrolled = (): Promise<number> => page.evaluate(() => scrollY);
    await page.mouse.move(60, 45);
    await page.mouse.wheel(0, 30);
    await expect.poll(scrolled).toBe(30);
    expect(await seenEvents(page)).toEqual([]);

    await page.keyboard.down('Control');
    await page.mouse.wheel(0, -100);
    await page.keyboard.up('Control');
    const near = await readOrbit(page);
    expect(near.radius).toBeLessThan(plainOrbit.radius * 0.95);
    expect(await scrolled()).toBe(30);

    await page.mouse.click(60, 20);
    await forgetEvents(page);
    await page.mouse.wheel(0, 200);
    expect((await readOrbit(page)).radius).toBeGreaterThan(near.radius * 1.1);
    expect(await scrolled()).toBe(30);

    // Away and back again: the page's wheel.
    await page.mouse.move(400, 400);
    await page.mouse.move(60, 20);
    await forgetEvents(page);
    await page.mouse.wheel(0, 25);
    await expect.poll(scrolled).toBe(55);
    expect(await seenEvents(page)).toEqual([]);
  });

  test('where the wheel can not zoom further, it scrolls the page, in both directions; with Ctrl the page stays as it is', async ({
    page,
  }) => {
    await openAndForget(page, `<div style="height: 300px"></div>${plain}${tall}`);
    await withElement(page, (element) => {
      Object.assign(element, { minCameraOrbit: 'auto auto 80', maxCameraOrbit: 'auto auto 100' });
      return element.whenRendered();
    });
    const scrollTo = (y: number): Promise<void> => page.evaluate((top) => window.scrollTo(0, top), y);
    const scrolled = (): Promise<number> => page.evaluate(() => scrollY);
    const radius = (): Promise<number> =>
      withElement(page, async (element) => {
        await element.whenRendered();
        return element.camera!.orbit.radius;
      });
    for (const [pixels, limit] of [
      [200, 100],
      [-200, 80],
    ] as const) {
      await scrollTo(250);
      const box = (await page.locator('volume-view').boundingBox())!;
      await page.mouse.move(box.x + 60, box.y + 20);
      await page.mouse.down();
      await page.mouse.up();
      for (let i = 0; i < 3 && Math.abs((await radius()) - limit) > 1e-6; i++) {
        await page.mouse.wheel(0, pixels);
        await expect.poll(radius).not.toBeCloseTo(90, 6);
      }
      expect(await radius()).toBeCloseTo(limit, 6);
      expect(await scrolled(), 'it zoomed, and the page stood').toBe(250);
      await page.keyboard.down('Control');
      const zoom = await page.evaluate(() => [devicePixelRatio, visualViewport!.scale]);
      const isKept = page.evaluate(
        () =>
          new Promise((resolve) =>
            addEventListener('wheel', (event) => resolve(event.defaultPrevented), { once: true }),
          ),
      );
      await page.mouse.wheel(0, pixels);
      expect(await isKept, 'a pinch').toBe(true);
      await page.keyboard.up('Control');
      expect(await page.evaluate(() => [devicePixelRatio, visualViewport!.scale])).toEqual(zoom);
      expect(await scrolled()).toBe(250);
      await page.mouse.wheel(0, pixels / 2);
      await expect.poll(scrolled).toBe(250 + pixels / 2);
      expect(await radius()).toBeCloseTo(limit, 6);
    }
  });

  test('a press gives the element the focus', async ({ page }) => {
    await openAndForget(page);
    await page.mouse.click(60, 45);
    const focused = await withElement(page, (element) => element.shadowRoot!.activeElement?.getAttribute('part'));
    expect(focused).toBe('picture');
  });
});

test.describe('touch', () => {
  test.use({ hasTouch: true });

  test('a finger that goes sideways turns', async ({ page }) => {
    await openAndForget(page, plain + tall);
    await touch(page, [line([40, 45], [100, 45])]);
    expect((await readOrbit(page)).theta).toBeLessThan(plainOrbit.theta - 0.3);
    expect(await page.evaluate(() => scrollY)).toBe(0);
  });

  test('a finger that goes up scrolls the page', async ({ page }) => {
    await openAndForget(page, plain + tall);
    await touch(page, [line([60, 85], [60, 5])]);
    await expect.poll(() => page.evaluate(() => scrollY)).toBeGreaterThan(20);
    await settle(page);
    const { theta } =
      (await seenEvents(page))
        .filter(({ type }) => type === 'camera-change')
        .map(({ detail }) => (detail as { orbit: Orbit }).orbit)
        .at(-1) ?? plainOrbit;
    expect(theta).toBeCloseTo(plainOrbit.theta, 2);
  });

  test('two fingers zoom', async ({ page }) => {
    await openAndForget(page, plain + tall);
    await touch(page, [line([50, 45], [20, 45]), line([70, 45], [100, 45])]);
    const orbit = await readOrbit(page);
    expect(orbit.radius).toBeLessThan(plainOrbit.radius * 0.5);
    expect(orbit.theta).toBeCloseTo(plainOrbit.theta, 6);
  });
});

test.describe('attributes', () => {
  test('interaction="none" leaves mouse, wheel and keys to the page', async ({ page }) => {
    await openAndForget(page, plain.replace('<volume-view', '<volume-view interaction="none"') + tall);
    expect(await page.locator('.picture').getAttribute('tabindex')).toBeNull();
    await page.mouse.move(60, 45);
    await page.mouse.down();
    await page.mouse.move(80, 45);
    await page.mouse.up();
    await page.mouse.wheel(0, 40);
    await expect.poll(() => page.evaluate(() => scrollY)).toBe(40);
    await page.keyboard.press('Tab');
    await page.keyboard.press('+');
    expect(await seenEvents(page)).toEqual([]);
    await setAttributes(page, { interaction: null });
    await page.locator('.picture').press('+');
    expect((await readOrbit(page)).radius).toBeLessThan(plainOrbit.radius);
  });

  test('camera-orbit, camera-target and field-of-view place the camera', async ({ page }) => {
    await openAndForget(page);
    const degrees = Math.PI / 180;
    const cases = [
      { orbit: [-120, 20, 80], target: [0, 0, 0], fov: 32 },
      { orbit: [200, 150, 100], target: [4, -3, 6], fov: 32 },
      { orbit: [35, 65, 45], target: [0, 0, 0], fov: 60 },
      { orbit: [10, 0, 90], target: [0, 0, 0], fov: 32 },
    ] as const;
    for (const {
      orbit: [theta, phi, radius],
      target,
      fov,
    } of cases) {
      await setAttributes(page, {
        'camera-orbit': `${theta * degrees}rad ${phi}deg ${radius}`,
        'camera-target': target.join(' '),
        'field-of-view': `${fov}deg`,
      });
      const camera = orbitCamera({ theta: theta * degrees, phi: phi * degrees, radius }, target, fov * degrees);
      expectSamePicture(await takePicture(page), drawReference({ camera }));
    }
    // Nobody moved it but the page.
    expect((await seenEvents(page)).filter(({ type }) => type === 'camera-change')).toEqual([]);
  });

  test('parts that are auto, or left out, show all that is seen', async ({ page }) => {
    await openAndForget(page);
    await setAttributes(page, { 'camera-orbit': null, 'camera-target': null, 'field-of-view': null });
    const whole = await takePicture(page);
    await setAttributes(page, { 'camera-orbit': 'auto auto auto', 'camera-target': 'auto', 'field-of-view': 'auto' });
    expect(compare(await takePicture(page), whole).worst).toBe(0);
    // A percentage is that of the volume's sphere, whatever is seen of it.
    await setAttributes(page, { 'camera-orbit': 'auto auto 100%' });
    const box = await takePicture(page);
    await setAttributes(page, { 'camera-orbit': 'auto auto 50%' });
    expect(compare(await takePicture(page), box).worst).toBeGreaterThan(20);
    await setAttributes(page, { 'camera-orbit': 'auto auto auto' });
    expect(compare(await takePicture(page), whole).worst).toBe(0);
  });

  test('a child viewpoint wins, and turning starts from it', async ({ page }) => {
    // Eye at y = 80 looking along -y, z up: a turn about x by 90 degrees, then about z by 180.
    const viewpoint =
      '<viewpoint position="0 80 0" orientation="0 0.70710678 0.70710678 3.14159265" fieldofview="0.5"></viewpoint>';
    await openAndForget(page, plain.replace('></volume-view>', `>${viewpoint}</volume-view>`));
    const camera = { eye: [0, 80, 0], target: [0, 0, 0], up: [0, 0, 1], fieldOfView: 0.5 } as const;
    expectSamePicture(await takePicture(page), drawReference({ camera }));
    await setAttributes(page, { 'camera-orbit': '90deg 30deg 60' });
    expectSamePicture(await takePicture(page), drawReference({ camera }));
    await page.locator('.picture').press('ArrowLeft');
    const orbit = await readOrbit(page);
    expect(orbit.radius).toBeCloseTo(80, 3);
    const turned = orbitCamera({ theta: Math.PI / 24, phi: Math.PI / 2, radius: 80 }, [0, 0, 0], 0.5);
    expectSamePicture(await takePicture(page), drawReference({ camera: turned }));
    await page.locator('.picture').press('0');
    await settle(page);
    expectSamePicture(await takePicture(page), drawReference({ camera }));
  });

  test('a viewpoint that changes, or goes, is followed', async ({ page }) => {
    const viewpoint =
      '<viewpoint position="0 80 0" orientation="0 0.70710678 0.70710678 3.14159265" fieldofview="0.5"></viewpoint>';
    await openAndForget(page, plain.replace('></volume-view>', `>${viewpoint}</volume-view>`));
    await page.locator('volume-view > viewpoint').evaluate((element) => element.setAttribute('position', '0 60 0'));
    await waitForEvent(page, 'render');
    const camera = { eye: [0, 60, 0], target: [0, 0, 0], up: [0, 0, 1], fieldOfView: 0.5 } as const;
    expectSamePicture(await takePicture(page), drawReference({ camera }));
    await forgetEvents(page);
    await page.locator('volume-view > viewpoint').evaluate((element) => element.remove());
    await waitForEvent(page, 'render');
    await expectPictureFrom(page, plainOrbit);
  });
  test('a viewpoint in a transform stands, turns and has its centre where the transform puts it; the next one takes its place', async ({
    page,
  }) => {
    // The transform turns z up into y, so the eye is at y = 80 above the centre of rotation at y = 20, and looks along -y with z up.
    const inner =
      '<viewpoint position="0 0 70" centerofrotation="0 0 10" orientation="0 0 1 3.14159265" fieldofview="0.5"></viewpoint>';
    const transform = `<group><transform translation="0 10 0" rotation="1 0 0 -1.57079633">${inner}</transform></group>`;
    const next =
      '<viewpoint position="0 60 0" orientation="0 0.70710678 0.70710678 3.14159265" fieldofview="0.5"></viewpoint>';
    await openAndForget(page, plain.replace('></volume-view>', `>${transform}${next}</volume-view>`));
    const camera = { eye: [0, 80, 0], target: [0, 0, 0], up: [0, 0, 1], fieldOfView: 0.5 } as const;
    expectSamePicture(await takePicture(page), drawReference({ camera }));
    await page.locator('.picture').press('ArrowLeft');
    expect((await readOrbit(page)).radius).toBeCloseTo(60, 3);
    expectSamePicture(
      await takePicture(page),
      drawReference({ camera: orbitCamera({ theta: Math.PI / 24, phi: Math.PI / 2, radius: 60 }, [0, 20, 0], 0.5) }),
    );
    await forgetEvents(page);
    await page.locator('volume-view > group').evaluate((element) => element.remove());
    await waitForEvent(page, 'render');
    expectSamePicture(await takePicture(page), drawReference({ camera: { ...camera, eye: [0, 60, 0] } }));
  });
});
