// <volume-surface> and <volume-terrain>: in the picture, clipped, picked, refused in words, and gone again.
import type { Page } from '@playwright/test';
import { ballPly, octahedronGltf } from '../helpers/meshes.ts';
import { hgtBytes } from '../helpers/terrain.ts';
import {
  compare,
  expect,
  fewPixels,
  fieldUrl,
  open,
  seenEvents,
  setAttributes,
  settle,
  takePicture,
  test,
  waitForEvent,
  withElement,
} from './helpers/harness.ts';
import type { CameraState } from '../../src/viewer/view/write-camera.ts';
import type { Picture } from './helpers/pictures.ts';
import { serveFiles } from './helpers/served-files.ts';

test.use(fewPixels);

const folder = '/test/e2e/pages/data/surfaces';
const files: Record<string, Buffer> = {
  'ball.ply': Buffer.from(ballPly([0, 0, 0], 9)),
  'large.ply': Buffer.from(ballPly([10, 4, 0], 12)),
  'eight.gltf': Buffer.from(octahedronGltf(0.009)),
  'broken.stl': Buffer.from('solid a\nfacet normal 0 0 1\nouter loop\nvertex nan 0 0\n'),
  'N10E020.hgt': Buffer.from(
    hgtBytes((north, east) => 300 + 2000 * Math.max(0, 1 - 6 * Math.hypot(north - 0.5, east - 0.5))),
  ),
};
const view = (inside: string, src = fieldUrl): string =>
  `<main><h1>Surfaces</h1><volume-view id="v" src="${src}" transfer-function="0 white 0, 60 white 3%" value-window="0 255" steps="40" interaction="none" camera-orbit="0deg 90deg auto" alt="A field">${inside}</volume-view>`;

const serve = (page: Page): Promise<readonly string[]> => serveFiles(page, folder, files);

/** The number of files that the page's own thread reads from now on: a worker has a fetch of its own. */
async function watchReading(page: Page): Promise<() => Promise<number>> {
  await page.evaluate(() => {
    const native = globalThis.fetch;
    const watched = Object.assign(globalThis, { filesRead: 0 });
    globalThis.fetch = (...args) => {
      watched.filesRead++;
      return native(...args);
    };
  });
  return () => page.evaluate(() => (globalThis as unknown as { filesRead: number }).filesRead);
}

/** Pixels that are far more orange than blue. */
const countOrange = ({ data }: Picture): number => {
  let count = 0;
  for (let at = 0; at < data.length; at += 4) count += Number(data[at] - data[at + 2] > 80);
  return count;
};
const pickMiddle = (page: Page): Promise<unknown> =>
  withElement(page, async (one) => {
    const pick = await one.pick(one.clientWidth / 2, one.clientHeight / 2);
    return (
      pick && [
        pick.surface?.type,
        pick.surface?.element.localName,
        pick.surface && pick.world.map((x) => Math.round(x)),
        pick.color,
      ]
    );
  });

test.describe('surfaces', () => {
  test('are framed in the same way whether their file comes before the volume or after the first picture, and move no camera of a reader', async ({
    page,
  }) => {
    await serve(page);
    const frame = (inside: string): string =>
      view(inside).replace('interaction="none" camera-orbit="0deg 90deg auto"', 'region="-10 -10 -10 10 10 10"');
    const surface = `<volume-surface src="${folder}/large.ply"></volume-surface>`;
    const camera = (): Promise<CameraState> => withElement(page, ({ camera }) => camera!);
    await open(page, frame(surface));
    await settle(page);
    const early = await camera();
    // Now the file of the surface waits until the volume is in the picture.
    for (const isMoved of [false, true]) {
      let give = (): void => {};
      const given = new Promise<void>((resolve) => (give = resolve));
      await page.route(`**${folder}/large.ply`, (route) => given.then(() => route.fallback()), { times: 1 });
      await open(page, frame(surface));
      await waitForEvent(page, 'render');
      const alone = await camera();
      expect(alone).not.toEqual(early);
      if (isMoved) {
        await page.keyboard.press('Tab');
        // On a slow machine the first press may come before the keys are listened to.
        await expect
          .poll(async () => {
            await page.keyboard.press('ArrowLeft');
            return (await seenEvents(page)).map(({ type }) => type);
          })
          .toContain('camera-change');
      }
      give();
      await settle(page);
      const { orbit } = await camera();
      if (isMoved) {
        expect(orbit.theta).not.toBe(alone.orbit.theta);
        expect(orbit.radius).toBe(alone.orbit.radius);
      } else expect(await camera()).toEqual(early);
    }
  });

  test('stand in the volume, are cut by ClipPlanes and picked; what is wrong is said, and nothing is lost', async ({
    page,
  }) => {
    const asked = await serve(page);
    await open(page, view(''));
    await settle(page);
    expect(asked.filter((path) => /surface|terrain/.test(path))).toEqual([]);
    expect(await pickMiddle(page)).toEqual([undefined, undefined, undefined, '#ffffff']);
    const reading = await watchReading(page);
    await withElement(
      page,
      (one, url) => {
        const surface = document.createElement('volume-surface');
        surface.setAttribute('src', url);
        surface.setAttribute('color', '#ff8800');
        one.append(surface);
      },
      { argument: `${folder}/ball.ply` },
    );
    await expect
      .poll(() =>
        page
          .locator('volume-surface')
          .evaluate((one: HTMLElementTagNameMap['volume-surface']) => one.info?.triangles ?? 0),
      )
      .toBe(528);
    expect(await reading(), 'read in a worker').toBe(0);
    await settle(page);
    const orange = countOrange(await takePicture(page));
    expect(orange).toBeGreaterThan(300);
    // From the front: its nearest place.
    expect(await pickMiddle(page)).toEqual([
      'surface',
      'volume-surface',
      [0, 9, 0].map((x) => expect.closeTo(x, 0)),
      '#ff8800',
    ]);

    await withElement(page, (one) => one.insertAdjacentHTML('beforeend', '<clipplane plane="0 0 1 0"></clipplane>'));
    await settle(page);
    expect(countOrange(await takePicture(page))).toBeLessThan(0.6 * orange);
    await page.locator('clipplane').evaluate((one) => one.remove());

    // A glTF of 9 mm, which is in metres with y up.
    await page.locator('volume-surface').evaluate((one, url) => one.setAttribute('src', url), `${folder}/eight.gltf`);
    await expect
      .poll(() =>
        page
          .locator('volume-surface')
          .evaluate((one: HTMLElementTagNameMap['volume-surface']) => one.info?.triangles ?? 0),
      )
      .toBe(8);
    await settle(page);
    expect(await pickMiddle(page)).toEqual([
      'surface',
      'volume-surface',
      [0, 9, 0].map((x) => expect.closeTo(x, 0)),
      '#ff8800',
    ]);

    const reported = page.locator('volume-surface').evaluate(
      (one) =>
        new Promise((resolve) =>
          one.addEventListener('error', (event) => resolve((event as CustomEvent<{ code: string }>).detail.code), {
            once: true,
          }),
        ),
    );
    await page.locator('volume-surface').evaluate((one, url) => one.setAttribute('src', url), `${folder}/broken.stl`);
    expect(await reported).toBe('format/corrupt');
    await expect(page.locator('volume-view .error')).toContainText('the STL');
    expect(await pickMiddle(page)).toEqual(expect.arrayContaining(['surface'])); // The last good one.
    await page.locator('volume-surface').evaluate((one) => one.setAttribute('opacity', '0.5'));
    await expect(page.locator('volume-view .error')).toContainText('opacity of <volume-surface> got 0.5; expected 1');

    await page.locator('volume-surface').evaluate((one) => one.remove());
    await settle(page);
    expect(countOrange(await takePicture(page))).toBe(0);
    await expect(page.locator('volume-view .error')).toHaveCount(0);
  });

  test('with cut-with-volume are cut by what cuts the volume, in the picture and for picks, and are whole again without', async ({
    page,
  }) => {
    await serve(page);
    await open(
      page,
      view(`<volume-surface src="${folder}/ball.ply" color="#ff8800"></volume-surface>`).replace(
        '0, 60 white 3%',
        '0, 300 white 0',
      ),
    );
    const surface = page.locator('volume-surface');
    await expect
      .poll(() => surface.evaluate((one: HTMLElementTagNameMap['volume-surface']) => one.info?.triangles ?? 0))
      .toBe(528);
    await settle(page);
    const whole = await takePicture(page);
    const { width, height } = whole;
    /** How many pixels of the left and of the right half of the picture are not the background. */
    const covered = ({ data }: Picture): [left: number, right: number] => {
      const counts: [number, number] = [0, 0];
      for (let i = 0; i < width * height; i++) counts[Number(i % width >= width / 2)] += Number(data[4 * i + 3] > 0);
      return counts;
    };
    const [left, right] = covered(whole);
    expect(Math.min(left, right)).toBeGreaterThan(150);

    // From the front the left half of the picture is the right one of the world.
    const cutAt = async (attributes: Record<string, string | null>): Promise<Picture> => {
      await setAttributes(page, attributes);
      return takePicture(page);
    };
    const bare = await cutAt({ cutout: '0 -99 -99 99 99 99' });
    expect(compare(bare, whole).worst, 'by default it is laid bare').toBe(0);
    await surface.evaluate((one: HTMLElementTagNameMap['volume-surface']) => (one.cutWithVolume = true));
    const cut = await takePicture(page);
    const [leftLeft, rightLeft] = covered(cut);
    expect(leftLeft, 'the background shows, but for the edge of the cut').toBeLessThan(0.06 * left);
    expect(rightLeft / right).toBeCloseTo(1, 1);
    expect(
      await withElement(page, async (one) => {
        const picks = await Promise.all(
          [0.47, 0.53].map((across) => one.pick(across * one.clientWidth, one.clientHeight / 2)),
        );
        return picks.map((pick) => pick?.surface?.type ?? null);
      }),
      'a ray goes through what is cut away',
    ).toEqual([null, 'surface']);
    // The same part by the region, and by a plane elsewhere in the page.
    expect(compare(await cutAt({ cutout: null, region: '-99 -99 -99 0 99 99' }), cut).worst).toBeLessThan(60); // Edges of triangles that another side of a cut divides.
    await setAttributes(page, { region: null });
    await page.evaluate(async () => {
      document.body.insertAdjacentHTML('beforeend', '<volume-clip for="v" normal="-1 0 0" at="0"></volume-clip>');
      await customElements.whenDefined('volume-clip').then(() => document.querySelector('volume-clip')!.updateComplete);
    });
    expect(covered(await takePicture(page))).toEqual([leftLeft, rightLeft]);
    // All of it is cut away, and some of it again.
    await page.evaluate(() => (document.querySelector('volume-clip')!.at = 10));
    await page.evaluate(() => document.querySelector('volume-clip')!.updateComplete);
    expect(covered(await takePicture(page))).toEqual([0, 0]);
    expect(await surface.evaluate((one: HTMLElementTagNameMap['volume-surface']) => one.info?.triangles)).toBe(528);
    await page.evaluate(() => document.querySelector('volume-clip')!.remove());
    expect(compare(await takePicture(page), whole).worst).toBe(0);
    await setAttributes(page, { cutout: '0 -99 -99 99 99 99' });
    expect(compare(await takePicture(page), cut).worst).toBe(0);
    await surface.evaluate((one: HTMLElementTagNameMap['volume-surface']) => (one.cutWithVolume = false));
    expect(compare(await takePicture(page), whole).worst).toBe(0);
  });

  test('of terrain lie under a radar alone, at its heights', async ({ page }) => {
    await serve(page);
    const terrain = `<volume-terrain src="${folder}/N10E020.hgt" color="#ff8800"></volume-terrain>`;
    await open(page, view(terrain));
    await expect(page.locator('volume-view .error')).toContainText("not a radar's");
    await page.route('**/over-land.json', async (route) => {
      const manifest = (await (
        await route.fetch({ url: new URL('/demos/data/storm-radar-1500.json', page.url()).href })
      ).json()) as object;
      await route.fulfill({ json: { ...manifest, site: { latitude: 10.5, longitude: 20.5, height: 800 } } });
    });
    const reading = await watchReading(page);
    await withElement(page, (one) => {
      one.setAttribute('camera-orbit', '0deg 0deg 12%');
      one.setAttribute('rings', 'none');
      one.setAttribute('src', '/demos/data/over-land.json');
    });
    const info = await page.locator('volume-terrain').evaluate(
      (one: HTMLElementTagNameMap['volume-terrain']) =>
        new Promise<HTMLElementTagNameMap['volume-terrain']['info']>((resolve) => {
          if (one.info) resolve(one.info);
          else one.addEventListener('load', () => resolve(one.info), { once: true });
        }),
    );
    expect(info!.heights).toEqual([300, 2300]);
    expect(await reading(), 'the radar and the terrain, each read in a worker').toBe(0);
    expect(info!.error).toBeLessThan(20);
    await settle(page);
    expect(countOrange(await takePicture(page))).toBeGreaterThan(1000);
    // The mountain under the antenna is higher than that; heights are five times as high.
    const picked = await withElement(page, async (one) => {
      const pick = await one.pick(one.clientWidth / 2, one.clientHeight / 2, { at: 'surface' });
      return (
        pick?.surface && {
          type: pick.surface.type,
          sea: pick.surface.radar!.heightAboveSea,
          latitude: pick.surface.radar!.latitude,
        }
      );
    });
    expect(picked!.type).toBe('terrain');
    expect(Math.abs(picked!.sea! - 2300)).toBeLessThan(30);
    expect(Math.abs(picked!.latitude! - 10.5)).toBeLessThan(0.01);
    // Under no radar it would lie anywhere.
    await withElement(page, (one, src) => one.setAttribute('src', src), { argument: fieldUrl });
    await expect(page.locator('volume-view .error')).toContainText("not a radar's");
    expect(
      await page.locator('volume-terrain').evaluate((one: HTMLElementTagNameMap['volume-terrain']) => one.info),
    ).toBe(null);
  });
});

test.describe('behind a token', () => {
  test.use({ allowedLines: /401|Failed to load resource|its box is/ });

  for (const [where, hasWorkers] of [
    ['a worker', true],
    ['the page, where there are no workers', false],
  ] as const)
    test(`a surface that is read in ${where} is fetched as the page fetches the volume`, async ({ page }) => {
      await serve(page);
      await page.route(`**${folder}/*`, async (route) => {
        const { authorization } = await route.request().allHeaders();
        return authorization === 'Bearer 1234' ? route.fallback() : route.fulfill({ status: 401 });
      });
      if (!hasWorkers) await page.addInitScript(() => Reflect.deleteProperty(globalThis, 'Worker'));
      await open(page, view(''));
      const triangles = await withElement(
        page,
        (one, url) => {
          one.fetch = (address, options) =>
            fetch(address, {
              ...options,
              headers: { ...Object.fromEntries(new Headers(options?.headers)), Authorization: 'Bearer 1234' },
            });
          const surface = document.createElement('volume-surface');
          surface.setAttribute('src', url);
          one.append(surface);
          return new Promise<number>((resolve, reject) => {
            surface.addEventListener('load', () => resolve(surface.info!.triangles));
            one.addEventListener('error', ({ detail }) => reject(new Error(detail.message)));
          });
        },
        { argument: `${folder}/ball.ply` },
      );
      expect(triangles).toBe(528);
    });
});
