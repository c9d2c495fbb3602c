// What a pointer does is the same wherever CSS shows the element: scaled, zoomed, turned, sheared, mirrored, in perspective, by itself or around it.
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Page } from '@playwright/test';
import { projectRoot } from '../../scripts/shared-data.mjs';
import { expect, fewPixels, fieldUrl, open, settle, test, withElement } from './helpers/harness.ts';
import { attributesOf } from './helpers/reference.ts';
import { line, touch } from './helpers/touch.ts';

test.use({ ...fewPixels, viewport: { width: 1300, height: 1000 }, hasTouch: true });

/** How a page shows what is in two elements, one in the other, and the same as one matrix: where it shows a place of the inner one. Both have their origin at their corner. */
interface Showing {
  readonly outer?: string;
  readonly inner?: string;
  /** Of the root, or the body. */
  readonly html?: string;
  readonly body?: string;
  /** As CSS writes it. */
  readonly matrix: string;
}

const showings: Readonly<Record<string, Showing>> = {
  scale: { outer: 'transform: scale(1.5)', matrix: 'scale(1.5)' },
  'a small scale': { outer: 'transform: translate(40px, 30px) scale(0.6)', matrix: 'translate(40px, 30px) scale(0.6)' },
  zoom: { outer: 'zoom: 1.5', matrix: 'scale(1.5)' },
  'zoom of the root': { html: 'zoom: 1.25', matrix: 'scale(1.25)' },
  'zoom of the body': { body: 'zoom: 0.8', matrix: 'scale(0.8)' },
  'a quarter turn': {
    outer: 'transform: translate(900px, 0) rotate(90deg)',
    matrix: 'translate(900px, 0) rotate(90deg)',
  },
  'a turn': {
    outer: 'transform: translate(300px, 40px) rotate(30deg) scale(0.8, 1.1)',
    matrix: 'translate(300px, 40px) rotate(30deg) scale(0.8, 1.1)',
  },
  shear: { outer: 'transform: translate(20px, 0) skewX(20deg)', matrix: 'translate(20px, 0) skewX(20deg)' },
  mirror: { outer: 'transform: translate(700px, 0) scaleX(-1)', matrix: 'translate(700px, 0) scaleX(-1)' },
  'properties of their own': {
    outer: 'translate: 300px 50px; rotate: 20deg; scale: 1.3 0.7',
    matrix: 'translate(300px, 50px) rotate(20deg) scale(1.3, 0.7)',
  },
  'one in the other': {
    outer: 'zoom: 1.2',
    inner: 'transform: translate(60px, 160px) rotate(-15deg) scale(0.7)',
    matrix: 'scale(1.2) translate(60px, 160px) rotate(-15deg) scale(0.7)',
  },
  perspective: {
    outer: 'transform: translate(80px, 60px) perspective(1500px) rotateY(25deg) rotateX(10deg)',
    matrix: 'translate(80px, 60px) perspective(1500px) rotateY(25deg) rotateX(10deg)',
  },
  // As reveal.js has them: https://github.com/hakimel/reveal.js, layout()
  'a slide of reveal.js': {
    outer:
      'position: absolute; left: 50%; top: 50%; width: 960px; height: 700px; transform-origin: 50% 50%; transform: translate(-50%, -50%) scale(0.9)',
    matrix: 'translate(650px, 500px) scale(0.9) translate(-480px, -350px)',
  },
};

type Place = readonly [x: number, y: number];

async function show(page: Page, { html = '', body = '', outer = '', inner = '' }: Partial<Showing>): Promise<void> {
  await page.evaluate(
    (styles) => {
      const [root, around, first, second] = [
        document.documentElement,
        document.body,
        document.querySelector<HTMLElement>('#outer')!,
        document.querySelector<HTMLElement>('#inner')!,
      ];
      root.style.cssText = styles[0];
      around.style.cssText = styles[1];
      first.style.cssText = `transform-origin: 0 0; width: 700px; ${styles[2]}`;
      second.style.cssText = `position: relative; transform-origin: 0 0; ${styles[3]}`;
    },
    [html, body, outer, inner],
  );
}

/** Where a page shows places of an element, by the matrix that it is said to have. */
function toPage(page: Page, selector: string, places: readonly Place[], matrix: string): Promise<Place[]> {
  return page.locator(selector).evaluate(
    (element, [own, css]) => {
      let [left, top] = [0, 0];
      // The offsets of layout know nothing of transforms and zooms.
      for (
        let one = element as HTMLElement | null;
        one && one.id !== 'inner';
        one = one.offsetParent as HTMLElement | null
      ) {
        left += one.offsetLeft + one.clientLeft;
        top += one.offsetTop + one.clientTop;
      }
      return own.map(([x, y]) => {
        const point = new DOMMatrix(css).transformPoint(new DOMPoint(left + x, top + y));
        return [point.x / point.w, point.y / point.w] as const;
      });
    },
    [places, matrix] as const,
  );
}

async function drag(page: Page, places: readonly Place[], button: 'left' | 'right' = 'left'): Promise<void> {
  await page.mouse.move(...places[0]);
  await page.mouse.down({ button });
  for (const place of places.slice(1)) await page.mouse.move(...place);
  await page.mouse.up({ button });
}

/** Do something plainly, and then as each page shows it; the numbers that come of it are the same. @param tolerance - of a pixel or so, which pages round */
async function compareAll(
  page: Page,
  act: (to: (selector: string, places: readonly Place[]) => Promise<Place[]>) => Promise<readonly number[]>,
  tolerance: number,
): Promise<readonly number[]> {
  const run = async (showing: Showing): Promise<readonly number[]> => {
    await show(page, showing);
    return act((selector, places) => toPage(page, selector, places, showing.matrix));
  };
  const plain = await run({ matrix: 'none' });
  expect(plain.every(Number.isFinite), String(plain)).toBe(true);
  for (const [name, showing] of Object.entries(showings)) {
    const got = await run(showing);
    expect(got.length, name).toBe(plain.length);
    got.forEach((value, i) =>
      expect.soft(Math.abs(value - plain[i]), `${name}: ${value} for ${plain[i]}`).toBeLessThan(tolerance),
    );
  }
  return plain;
}

const page2 = (body: string): string =>
  `<div id="outer"><div id="inner" style="position: relative">${body}</div></div>`;

test.describe('a pane', () => {
  const pane =
    '<volume-slice-view id="pane" src="/test/fixtures/nifti/conflict.nii" at="1.5" style="width: 300px; height: 300px"></volume-slice-view>';
  const script = '<script type="module" src="/dist/volume-slice-view.js"></script>';
  const whenDrawn = (page: Page): Promise<unknown> =>
    page.evaluate(() =>
      customElements
        .whenDefined('volume-slice-view')
        .then(() => document.querySelector('volume-slice-view')!.whenRendered()),
    );
  const cursorOf = async (page: Page): Promise<readonly number[]> => {
    await whenDrawn(page);
    return page.evaluate(() => [...document.querySelector('volume-slice-view')!.cursor!]);
  };

  // World places and values: nibabel 5.3, affine and array of the file at own pixels of 0.08 mm, the patient's right on the left.
  const clicks = [
    { at: [160, 150], world: [-0.8, 0, 1.5], value: 175 },
    { at: [190, 120], world: [-3.2, 2.4, 1.5], value: 177 },
    { at: [90, 210], world: [4.8, -4.8, 1.5], value: 174 },
  ] as const;

  test('has its crosshair where it is clicked', async ({ page }) => {
    await open(page, page2(pane), { script });
    await whenDrawn(page);
    const values: number[] = [];
    const plain = await compareAll(
      page,
      async (to) => {
        const cursors: number[] = [];
        for (const { at, value } of clicks) {
          const [place] = await to('#pane', [at]);
          await page.mouse.click(...place);
          cursors.push(...(await cursorOf(page)));
          values.push(Number((await page.locator('#pane [part=value]').textContent())!.trim()) - value);
        }
        return cursors;
      },
      0.17,
    );
    plain.forEach((value, i) =>
      expect(Math.abs(value - clicks.flatMap(({ world }) => [...world])[i])).toBeLessThan(0.09),
    );
    expect(
      values.every((difference) => difference === 0),
      'and shows the value there',
    ).toBe(true);
  });

  test("in a shadow root of the author's has its crosshair where it is clicked", async ({ page }) => {
    await open(page, page2('<div id="host" style="padding: 7px 0 0 11px"></div>'), { script });
    await page.evaluate((html) => {
      const root = document.querySelector('#host')!.attachShadow({ mode: 'open' });
      root.innerHTML = `<div style="border: 3px solid; width: 300px">${html}</div>`;
    }, pane);
    const inRoot = page.locator('volume-slice-view');
    const drawn = (): Promise<readonly number[]> =>
      inRoot.evaluate(async (element) => {
        await customElements.whenDefined('volume-slice-view');
        const view = element as HTMLElementTagNameMap['volume-slice-view'];
        await view.whenRendered();
        return [...(view.cursor ?? [])];
      });
    await drawn();
    const plain = await compareAll(
      page,
      async (to) => {
        const cursors: number[] = [];
        for (const { at } of clicks) {
          const [place] = await to('#pane', [at]);
          await page.mouse.click(...place);
          cursors.push(...(await drawn()));
        }
        return cursors;
      },
      0.17,
    );
    plain.forEach((value, i) =>
      expect(Math.abs(value - clicks.flatMap(({ world }) => [...world])[i])).toBeLessThan(0.09),
    );
  });

  test('is dragged, windowed, moved, zoomed and pinched by its own pixels', async ({ page }) => {
    await open(page, page2(pane), { script });
    await whenDrawn(page);
    await compareAll(
      page,
      async (to) => {
        const [middle, aside, corner, far, shifted] = await to('#pane', [
          [150, 150],
          [200, 120],
          [60, 80],
          [240, 220],
          [230, 150],
        ]);
        await page.mouse.dblclick(...middle);
        await page.mouse.click(...middle);
        await drag(page, [middle, aside], 'right');
        await whenDrawn(page);
        const [width, level] = (await page.locator('#pane [part=window]').textContent())!.match(/[\d.]+/g)!.map(Number);
        // What lies at a place of the pane stays there.
        await page.mouse.move(...corner);
        await page.keyboard.down('Control');
        await page.mouse.wheel(0, -300);
        await page.keyboard.up('Control');
        await page.mouse.click(...far);
        const zoomed = await cursorOf(page);
        await page.keyboard.down('Shift');
        await drag(page, [middle, shifted]);
        await page.keyboard.up('Shift');
        await page.mouse.click(...far);
        const moved = await cursorOf(page);
        await page.mouse.dblclick(...middle);
        const [left, right, left2, right2] = await to('#pane', [
          [100, 150],
          [200, 150],
          [50, 120],
          [250, 180],
        ]);
        await touch(page, [line(left, left2), line(right, right2)]);
        await page.mouse.click(...far);
        const pinched = await cursorOf(page);
        await page.mouse.dblclick(...middle);
        return [width / 10, level / 10, ...zoomed, ...moved, ...pinched];
      },
      0.25,
    );
  });
});

test('a view is picked, turned, zoomed and pointed at by its own pixels, and so are handles in it', async ({
  page,
}) => {
  test.setTimeout(180_000);
  const view = `<volume-view id="view" pickable src="${fieldUrl}" ${attributesOf({ 'transfer-function': '0 #003 0.999, 0.4 #c63 0.999, 1 #ffc 0.999', steps: '20' })} alt="A field" style="width: 300px; height: 200px; border: 5px solid"></volume-view>`;
  await open(
    page,
    page2(
      `${view}<volume-clip for="view" type="plane" normal="0 1 0" at="0"></volume-clip><volume-readout for="view" style="width: 300px"></volume-readout>`,
    ),
  );
  await settle(page);
  await page.waitForFunction(() => document.querySelector('volume-view')!.shadowRoot!.querySelector('.handle'));
  await page.evaluate(() =>
    document
      .querySelector('volume-view')!
      .addEventListener('volume-pick', (event) =>
        Object.assign(window, { picked: (event as CustomEvent).detail ?? 'nothing' }),
      ),
  );
  const numbersOf = (): Promise<number[]> =>
    withElement(page, (element) => [...element.camera!.eye, ...element.camera!.target].map((x) => x / 20));
  await page.emulateMedia({ reducedMotion: 'reduce' });
  const plain = await compareAll(
    page,
    async (to) => {
      await withElement(page, async (element) => {
        await customElements.whenDefined('volume-clip');
        Object.assign(window, { picked: null });
        document.querySelector('volume-clip')!.at = 0;
        element.cameraOrbit = element.cameraTarget = null;
        element.setAttribute('camera-orbit', '30deg 70deg 90');
        element.setAttribute('camera-target', '0 0 0');
        await document.querySelector('volume-clip')!.updateComplete;
        await element.whenRendered();
      });
      const [, place, , corner] = await to('#view', [
        [150, 100],
        [110, 75],
        [190, 70],
        [60, 40],
      ]);
      await page.mouse.click(...place);
      await page.waitForFunction(() => (window as never as { picked: unknown }).picked);
      const picked = await page.evaluate(() => (window as never as { picked: { world: number[] } }).picked.world);
      await page.mouse.move(place[0] + 1, place[1]);
      await page.mouse.move(...place);
      const reported = async (): Promise<number> =>
        Number(/-?[\d.]+/.exec((await page.locator('volume-readout').textContent()) ?? '')?.[0]);
      const marker = await page
        .locator('#view [part=marker]')
        .evaluate(({ style }) => [parseFloat(style.left), parseFloat(style.top)]);
      const value = await reported();
      // The handle is where its own pixels are, and goes along with the pointer.
      const handle = (await page
        .locator('#view .handle')
        .first()
        .evaluate(({ style }) => [parseFloat(style.left), parseFloat(style.top)])) as unknown as Place;
      const grabbed = await to('#view', [handle, [handle[0] + 30, handle[1] + 12]]);
      await drag(page, grabbed);
      const at = await page.evaluate(() => document.querySelector('volume-clip')!.at!);
      await page.evaluate(async () => {
        document.querySelector('volume-clip')!.at = 0;
        await document.querySelector('volume-clip')!.updateComplete;
      });
      await settle(page);
      const attached = await to('#view', [
        [20, 180],
        [70, 150],
      ]);
      await drag(page, attached);
      await settle(page);
      const turned = await numbersOf();
      await page.mouse.move(...corner);
      await page.mouse.wheel(0, -300);
      await settle(page);
      const zoomed = await numbersOf();
      expect(zoomed).not.toEqual(turned);
      return [
        ...picked.map((x) => x / 4),
        ...marker.map((x) => x / 4),
        Number.isFinite(value) ? value : 0,
        at / 4,
        ...turned,
        ...zoomed,
      ];
    },
    0.6,
  );
  expect(plain.slice(0, 3).some((x) => x !== 0)).toBe(true);
});

test.describe('an editor', () => {
  const view = (attributes: string): string =>
    `<volume-view id="field" src="${fieldUrl}" steps="20" alt="A field" ${attributes}></volume-view>`;
  const attribute = (page: Page, name: string): Promise<string> =>
    withElement(page, (element, asked) => element.getAttribute(asked) ?? '', { argument: name });
  const numbers = (text: string): number[] => (text.match(/(?<![#\w])-?\d[\d.]*/g) ?? []).map(Number);

  /** Put another editor in the place of the one there, which knows nothing of what was edited before, and wait until all of it stands still. */
  const renewEditor = async (page: Page, attributes: Readonly<Record<string, string | null>>): Promise<void> => {
    await withElement(
      page,
      async (element, changes) => {
        for (const [name, value] of Object.entries(changes)) {
          if (value === null) element.removeAttribute(name);
          else element.setAttribute(name, value);
        }
        await element.whenRendered();
        const editor = document.querySelector('volume-transfer-function')!;
        const other = editor.cloneNode() as typeof editor;
        editor.replaceWith(other);
        for (let still = 0, last = ''; still < 10;) {
          await new Promise(requestAnimationFrame);
          const now = other.shadowRoot!.innerHTML;
          const histogram = other.shadowRoot!.querySelector<HTMLCanvasElement>('.plane canvas');
          const isCounted =
            !histogram ||
            histogram
              .getContext('2d')!
              .getImageData(0, 0, histogram.width, histogram.height)
              .data.some((x) => x > 0);
          still = now === last && isCounted && other.shadowRoot!.querySelector('.plot') ? still + 1 : 0;
          last = now;
        }
      },
      { argument: attributes },
    );
  };

  test('of stops takes, drags and adds them by its own pixels', async ({ page }) => {
    await open(
      page,
      page2(
        `${view('')}<volume-transfer-function for="field" style="display: block; width: 400px"></volume-transfer-function>`,
      ),
    );
    await expect(page.locator('volume-transfer-function .editor')).toBeVisible();
    const plain = await compareAll(
      page,
      async (to) => {
        await renewEditor(page, { 'transfer-function': '0 blue 0, 100 red 1%, 200 #ffff00 30%' });
        await expect(page.locator('volume-transfer-function .handle')).toHaveCount(3);
        const taken = await page
          .locator('volume-transfer-function .handle')
          .nth(1)
          .evaluate((handle) => {
            const [share, height] = ['--x', '--y'].map((name) =>
              parseFloat((handle as HTMLElement).style.getPropertyValue(name)),
            );
            const { clientWidth, clientHeight } = handle.closest('.plot')!;
            return [share * clientWidth, (1 - height) * clientHeight] as const;
          });
        expect(taken.every(Number.isFinite), String(taken)).toBe(true);
        await drag(page, await to('.plot', [taken, [taken[0] + 20, taken[1] - 20], [taken[0] + 60, taken[1] - 50]]));
        const [free] = await to('.plot', [[40, 30]]);
        await page.mouse.dblclick(...free);
        return numbers(await attribute(page, 'transfer-function')).map((x) => x / 255);
      },
      0.03,
    );
    expect(plain.length, 'one more stop').toBeGreaterThan(6);
  });

  test('of values and gradients draws and moves by its own pixels', async ({ page }) => {
    await open(
      page,
      page2(
        `${view('transfer-function="0 blue 0, 255 red 30%"')}<volume-transfer-function for="field" mode="2d" style="display: block; width: 400px"></volume-transfer-function>`,
      ),
    );
    await expect(page.locator('.plane')).toBeVisible();
    const plain = await compareAll(
      page,
      async (to) => {
        await renewEditor(page, { 'transfer-function-2d': null });
        await drag(
          page,
          await to('.plane', [
            [60, 200],
            [100, 150],
            [200, 60],
          ]),
        );
        await drag(
          page,
          await to('.plane', [
            [130, 130],
            [150, 130],
            [210, 120],
          ]),
        );
        return numbers(await attribute(page, 'transfer-function-2d'))
          .slice(0, 4)
          .map((x) => x / 100);
      },
      0.05,
    );
    expect(plain.length).toBe(4);
  });
});

// Files that listen to pointers, or ask where something stands in the page, and don't ask src/page/pointer-place.ts. Each with what it needs no place for.
const placeless: Readonly<Record<string, string>> = {
  'src/page/pointer-place.ts': 'it is what all others ask',
  'src/viewer/camera/right-button.ts':
    'how far a hand has gone, in the pixels of the page; the menu opens where the browser says',
  'src/viewer/scenes/visibility.ts': 'whether the mouse is over an element',
  'src/viewer/loading/brick-drawing.ts': 'whether a press is in another view',
  'src/viewer/view/auto-rotation.ts': 'whether a hand is on the picture',
  'components/volume-view/orientation-marker.ts': 'buttons',
  'components/volume-view/view-controls.ts': 'whether a press is beside a list',
  'components/volume-timeline/volume-timeline.ts': 'buttons',
  'components/volume-readout/volume-readout.ts': 'a button',
  'components/volume-measure/volume-measure.ts': 'buttons; places of a view come from its pick',
  'components/volume-transfer-function/transfer-function-panels.ts': 'buttons',
  'components/volume-transfer-function/transfer-function-patch-fields.ts': 'buttons',
  'components/volume-transfer-function/transfer-function-plane.ts': 'hands its events to patch-input.ts',
  'components/volume-transfer-function/volume-transfer-function.ts': 'hands its events to stop-input.ts',
  'components/volume-view/volume-view-parts.ts': 'a button',
  'components/volume-view/view-controls-parts.ts': 'buttons',
  'components/volume-view/view-authoring.ts': 'buttons, and whether a finger has pressed',
  'components/volume-label-list/volume-label-list.ts': 'buttons',
  'components/volume-note/volume-note.ts': 'a button, and whether the mouse is over the text',
  'src/viewer/notes/note-layer.ts':
    'how far a press has moved, in the pixels of the page, and whether it is outside of a note',
  'src/viewer/notes/note-mark.ts': 'buttons, and whether the mouse is over them',
  'src/viewer/notes/pane-notes.ts': 'buttons, and whether the mouse is over them',
  'components/volume-question/volume-question-parts.ts': 'buttons',
  'components/volume-tour/volume-tour-parts.ts': 'buttons',
  'components/volume-tour/tour-view.ts': 'whether a hand has used the view',
  'components/volume-drop/volume-drop.ts':
    'where its frame and its view stand in the window, and whether files are dragged over them',
  'components/volume-view/volume-view-members.ts': 'hands points of the page to its pick',
  'components/volume-tour/tour-autoplay.ts': 'whether the mouse is over the tour or its view',
  'components/volume-tour/tour-scroll.ts': 'where its steps stand in the window',
  'components/internal/view-notices.ts': 'a button, and a press elsewhere that closes its text',
};

/** Files that ask where something stands in the window, not where a pointer is in an element. */
const measuresWindow = [
  'src/page/pointer-place.ts',
  'components/volume-tour/tour-scroll.ts',
  'components/volume-drop/volume-drop.ts',
];

/** Imports of what turns a pointer into a place, by itself or for a chart or a camera. */
const asks = /from '[./\w]*\/(?:pointer-place|share-of-chart|camera-moves)\.ts'/;

test('all files that listen to pointers ask one place where they are, or need no place', () => {
  const listens =
    /'(?:pointer(?!s')|mouse|touch|drag|gesture)[a-z]+'|\bpointer(?:enter|leave|down|move|up)\b|'(?:click|dblclick|wheel|contextmenu|auxclick)'|@(?:pointer\w+|mouse\w+|touch\w+|click|dblclick|wheel|contextmenu)=/;
  const measures =
    /\b(?:client|page|offset|layer|screen|movement)[XY]\b|getBoundingClientRect|getClientRects|elements?FromPoint/;
  const files = ['src', 'components'].flatMap((folder) =>
    readdirSync(join(projectRoot, folder), { recursive: true, encoding: 'utf8' })
      .filter((name) => name.endsWith('.ts'))
      .map((name) => `${folder}/${name}`),
  );
  const listening: string[] = [];
  for (const file of files) {
    const text = readFileSync(join(projectRoot, file), 'utf8').replace(/\/\*[\s\S]*?\*\/|\/\/.*/g, '');
    if (!listens.test(text) && !measures.test(text)) continue;
    listening.push(file);
    expect
      .soft(
        asks.test(text) || file in placeless,
        `${file} listens to pointers, or measures in the page: use placeInElement of src/page/pointer-place.ts, or say above why it needs no place`,
      )
      .toBe(true);
    if (/getBoundingClientRect|getClientRects|elements?FromPoint|\b(?:page|offset|layer|screen)[XY]\b/.test(text))
      expect.soft(measuresWindow, `${file} measures in the page by itself`).toContain(file);
  }
  expect(listening.length).toBeGreaterThan(15);
  expect(
    Object.keys(placeless).filter((file) => !listening.includes(file)),
    'said of files that do not listen any more',
  ).toEqual([]);
});

test('the place that is seen at a point of the page is the same however the page shows the view', async ({ page }) => {
  const view = `<volume-view id="view" src="${fieldUrl}" ${attributesOf({ 'transfer-function': '0.2 #003 0, 0.5 #c63 0.05, 1 #ffc 0.3', steps: '20' })} alt="A field" style="width: 300px; height: 200px; border: 5px solid"><volume-note position="0 0 0" hide="never"></volume-note></volume-view>`;
  await open(page, page2(view));
  await settle(page);
  const plain = await compareAll(
    page,
    async (to) => {
      const places = await to('#view', [
        [150, 100],
        [130, 85],
        [175, 120],
      ]);
      const found = await withElement(
        page,
        (element, points) => Promise.all(points.map(([x, y]) => element.positionFromPoint(x, y))),
        { argument: places },
      );
      // Half of the light of a ray that is opaque enough is left; pages round pixels.
      return found.flatMap((one) => (one ? [...one.position, 20 * one.value, 20 * one.transmittance] : [NaN]));
    },
    0.6,
  );
  expect(plain[4] / 20).toBeGreaterThan(0.45);
  expect(plain[4] / 20).toBeLessThan(0.99);
  // A note at this place measures the same light, and its pin stands at this pixel.
  await show(page, {});
  const [place] = await toPage(page, '#view', [[130, 85]], 'none');
  const transmittance = await withElement(
    page,
    async (element, [x, y]) => {
      const found = (await element.positionFromPoint(x, y))!;
      document.querySelector('volume-note')!.position = found.position;
      return found.transmittance;
    },
    { argument: place },
  );
  await expect
    .poll(() => page.evaluate(() => document.querySelector('volume-note')!.transmittance))
    .toBeCloseTo(transmittance, 6);
  const pin = (await page.locator('#view .pin').boundingBox())!;
  expect(Math.abs(pin.x + pin.width / 2 - place[0])).toBeLessThan(1);
  expect(Math.abs(pin.y + pin.height / 2 - place[1])).toBeLessThan(1);
  const corner = await toPage(
    page,
    '#view',
    [
      [1, 1],
      [-20, 50],
    ],
    'none',
  );
  const nothing = await withElement(
    page,
    (element, points) => Promise.all(points.map(([x, y]) => element.positionFromPoint(x, y))),
    { argument: corner },
  );
  expect(nothing).toEqual([null, null]);
});
