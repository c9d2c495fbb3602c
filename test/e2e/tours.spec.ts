// <volume-tour> and <volume-step>
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Locator, Page } from '@playwright/test';
import { projectRoot } from '../../scripts/shared-data.mjs';
import { niftiBytes } from '../helpers/nifti-bytes.ts';
import { atlas } from './helpers/atlas.ts';
import { findFaults } from './helpers/axe.ts';
import { attributesOf, plainAttributes } from './helpers/reference.ts';
import {
  compare,
  expect,
  fewPixels,
  fieldUrl,
  forgetEvents,
  keptTest as test,
  open,
  settle,
  takePicture,
  waitForEvent,
} from './helpers/harness.ts';
import { meanOf } from './helpers/pictures.ts';
import { serveFiles } from './helpers/served-files.ts';

const size = 'style="width: 320px; height: 240px"';
const view = (id: string, changes: Record<string, string> = {}): string =>
  `<volume-view id="${id}" src="${fieldUrl}" ${attributesOf(changes)} ${size} alt="A field"><volume-note id="one" position="-8 4 3" label="One"><p>Text of a note</p></volume-note></volume-view>`;

/** What each step sets, in the order of the page. */
const settings: readonly Record<string, string>[] = [
  {},
  { 'camera-orbit': '-80deg 90deg 90', 'transfer-function': '0.15 #030 0, 0.4 #3c6 9%, 0.8 #cff 0.6', notes: 'one' },
  { region: '-500 -2 -500 500 500 500', alt: 'Half a field' },
  { 'camera-orbit': '170deg 40deg 90', 'opacity-factor': '3', projection: 'max' },
];
const names = ['First', 'Second', 'Third', 'Fourth'];
const write = (attributes: Record<string, string>): string =>
  Object.entries(attributes)
    .map(([name, value]) => `${name}="${value}"`)
    .join(' ');
const tourOf = (more = '', steps = settings): string =>
  `<volume-tour for="seen" ${more}>${steps.map((step, i) => `<volume-step id="step-${i + 1}" ${write(step)}><h2>${names[i]}</h2><p>Text ${i + 1}</p></volume-step>`).join('')}</volume-tour>`;
const lesson = (more = '', steps = settings): string => `${view('seen')}${tourOf(more, steps)}`;

const poster =
  '<img slot="poster" alt="Half a field on paper" width="40" height="30" src="data:image/gif;base64,R0lGODlhAQABAAAAACwAAAAAAQABAAA=">';

const button = (page: Page, name: string): Locator =>
  page.locator('volume-tour').getByRole('button', { name, exact: true });

/** The attributes of the view that matter, and which notes are open. */
const stateOf = (page: Page, id = 'seen'): Promise<Record<string, string | boolean>> =>
  page.evaluate((id) => {
    const element = document.getElementById(id)!;
    const own = element.getAttributeNames().filter((name) => !['id', 'class', 'style', 'src'].includes(name));
    return {
      ...Object.fromEntries(own.map((name) => [name, element.getAttribute(name)!])),
      isOpen: element.querySelector('volume-note')?.hasAttribute('open') ?? false,
    };
  }, id);

/** The state of a fresh tag with the attributes of a step. */
function stateIn(step: number): Record<string, string | boolean> {
  const { notes, ...attributes } = settings[step - 1] ?? {};
  return { ...plainAttributes, alt: 'A field', ...attributes, isOpen: notes === 'one' };
}

/** Open a step as a script does, and wait until all is there. */
async function goTo(page: Page, step: number): Promise<void> {
  await page.evaluate((step) => {
    document.querySelector('volume-tour')!.step = step;
  }, step);
  await expect.poll(() => stateOf(page)).toEqual(stateIn(step));
}

/** The events of the tour from now on. */
async function listen(page: Page): Promise<() => Promise<unknown[]>> {
  await page.evaluate(() => {
    const seen: unknown[] = ((window as unknown as { heard: unknown[] }).heard = []);
    for (const type of ['step-change', 'tour-complete', 'error'])
      document.querySelector('volume-tour')!.addEventListener(type, (event) => {
        const { detail } = event as CustomEvent<{ message?: string } | null>;
        seen.push([type, detail?.message ?? detail]);
      });
  });
  return () => page.evaluate(() => (window as unknown as { heard: unknown[] }).heard);
}

test.use(fewPixels);

test.describe('tours', () => {
  test('show one step at a time, and lead on by buttons and dots', async ({ page }) => {
    await open(page, lesson());
    await settle(page);
    await expect(page.getByText('Text 1')).toBeVisible();
    await expect(page.getByText('Text 2')).toBeHidden();
    await expect(page.locator('volume-tour')).toMatchAriaSnapshot(`
      - group "Tour":
        - button "Previous step" [disabled]
        - list:
          - listitem:
            - button "1. First"
          - listitem:
            - button "2. Second"
          - listitem:
            - button "3. Third"
          - listitem:
            - button "4. Fourth"
        - button "Next step"
        - button "Leave the tour"
      - heading "First" [level=2]
      - paragraph: Text 1
      - status
    `);
    await expect(button(page, '1. First')).toHaveAttribute('aria-current', 'step');
    const heard = await listen(page);
    await button(page, 'Next step').click();
    await expect(page.getByText('Text 2')).toBeVisible();
    await expect(page.getByText('Text 1')).toBeHidden();
    await expect(page.getByRole('heading', { name: 'Second' })).toBeFocused();
    await expect(page.locator('volume-tour').getByRole('status')).toHaveText('Step 2 of 4: Second');
    await expect(page.getByText('Text of a note')).toBeVisible();
    await expect.poll(() => stateOf(page)).toEqual(stateIn(2));
    await button(page, '4. Fourth').click();
    await expect(button(page, 'Next step')).toBeDisabled();
    await expect(page.getByText('Text of a note')).toBeHidden();
    await button(page, 'Previous step').click();
    await expect(page.getByRole('heading', { name: 'Third' })).toBeFocused();
    await expect(page.locator('volume-view .picture')).toHaveAccessibleName('Half a field');
    await button(page, 'Leave the tour').click();
    await expect(button(page, 'Start the tour')).toBeFocused();
    await expect(page.locator('volume-tour').getByRole('status')).toHaveText('The tour is closed.');
    await expect(page.getByText('Text 3')).toBeHidden();
    expect(await stateOf(page)).toEqual(stateIn(0));
    await button(page, 'Start the tour').click();
    await expect(page.getByRole('heading', { name: 'First' })).toBeFocused();
    const steps = [2, 4, 3, 0, 1].map((step) => ['step-change', { step, count: 4, id: step ? `step-${step}` : '' }]);
    expect(await heard()).toEqual([...steps.slice(0, 3), ['tour-complete', null], ...steps.slice(3)]);
  });

  test('are walked through by keys alone', async ({ page }) => {
    await open(page, lesson());
    await settle(page);
    await button(page, 'Next step').focus();
    await page.keyboard.press('Enter');
    for (const [key, name] of [
      ['ArrowRight', 'Third'],
      ['End', 'Fourth'],
      ['ArrowRight', 'Fourth'],
      ['ArrowLeft', 'Third'],
      ['Home', 'First'],
      ['ArrowLeft', 'First'],
    ]) {
      await page.keyboard.press(key);
      await expect(page.getByRole('heading', { name }), key).toBeFocused();
    }
    await page.keyboard.press('Escape');
    await expect(button(page, 'Start the tour')).toBeFocused();
    await page.keyboard.press('Enter');
    await expect(page.getByRole('heading', { name: 'First' })).toBeFocused();
    await page.evaluate(() => (document.documentElement.dir = 'rtl'));
    await page.keyboard.press('ArrowLeft');
    await expect(page.getByRole('heading', { name: 'Second' })).toBeFocused();
  });

  test('end in any order where a fresh tag with the attributes of the step is: attributes and pixels', async ({
    page,
  }) => {
    test.slow();
    await open(page, `${lesson('duration="60"')}<div id="fresh-one"></div>`);
    await settle(page, '#seen');
    // Each step after each other one, and leaving in between.
    const order = [2, 4, 1, 3, 2, 1, 4, 3, 1, 2, 0, 4, 2, 3, 4, 0, 3, 0, 1, 0];
    for (const step of order) await goTo(page, step);
    for (const [step, attributes] of settings.entries()) {
      await goTo(page, step + 1);
      await settle(page, '#seen');
      const { notes: _notes, ...changes } = attributes;
      await page.evaluate(
        (html) => (document.querySelector('#fresh-one')!.innerHTML = html),
        view('fresh', changes).replace(/<volume-note.*<\/volume-note>/, ''),
      );
      await settle(page, '#fresh');
      const [toured, fresh] = [
        await takePicture(page, { selector: '#seen', width: 240, height: 180 }),
        await takePicture(page, { selector: '#fresh', width: 240, height: 180 }),
      ];
      expect(compare(toured, fresh).worst, names[step]).toBeLessThanOrEqual(2);
      expect(meanOf(toured)[3], names[step]).toBeGreaterThan(1);
    }
  });

  test('mix colours on the way, and end with the text of the step', async ({ page }) => {
    await open(page, lesson('duration="400"'));
    await settle(page);
    const texts = await page.evaluate(async () => {
      const [tour, element] = [document.querySelector('volume-tour')!, document.querySelector('volume-view')!];
      const seen = new Set<string>();
      tour.step = 2;
      const began = performance.now();
      while (performance.now() - began < 900) {
        seen.add(element.getAttribute('transfer-function')!);
        await new Promise(requestAnimationFrame);
      }
      return [...seen];
    });
    expect(texts.length).toBeGreaterThan(2);
    expect(texts[0]).toBe(plainAttributes['transfer-function']);
    expect(texts.at(-1)).toBe(settings[1]['transfer-function']);
    for (const text of texts.slice(1, -1))
      expect(text).toMatch(/^0\.15 #\w{6} 0%, 0\.4 #\w{6} [\d.]+%, 0\.8 #\w{6} [\d.]+%$/);
  });

  test('jump where a reader wants less motion, and with duration="0"', async ({ page }) => {
    for (const [more, reducedMotion] of [
      ['duration="2000"', 'reduce'],
      ['duration="0"', null],
    ] as const) {
      await page.emulateMedia({ reducedMotion });
      await open(page, lesson(more));
      await settle(page);
      const [text, thetas] = await page.evaluate(async () => {
        const [tour, element] = [document.querySelector('volume-tour')!, document.querySelector('volume-view')!];
        const seen = new Set([element.camera!.orbit.theta]);
        tour.step = 2;
        await tour.updateComplete;
        const written = element.getAttribute('transfer-function');
        await element.updateComplete;
        for (const began = performance.now(); performance.now() - began < 500;) {
          await new Promise(requestAnimationFrame);
          seen.add(element.camera!.orbit.theta);
        }
        return [written, [...seen]] as const;
      });
      expect(text, more).toBe(settings[1]['transfer-function']);
      expect(thetas, more).toHaveLength(2);
      expect(Math.cos(thetas[1] + (80 * Math.PI) / 180), more).toBeCloseTo(1, 6);
    }
    await page.emulateMedia({ reducedMotion: null });
  });

  test('yield to a hand on the camera, also in the middle of a move, and take the step up again', async ({ page }) => {
    await open(page, lesson('duration="1000"'));
    await settle(page);
    await expect(button(page, 'Back to this step')).toHaveCount(0);
    await button(page, 'Next step').click();
    await page.mouse.move(160, 200);
    await page.mouse.down();
    await page.mouse.move(230, 205, { steps: 6 });
    await page.mouse.up();
    await expect(button(page, 'Back to this step')).toBeVisible();
    await settle(page);
    const orbit = (): Promise<string | null> => page.evaluate(() => document.querySelector('volume-view')!.cameraOrbit);
    expect(await orbit()).not.toBe(settings[1]['camera-orbit']);
    await button(page, 'Back to this step').click();
    await expect(button(page, 'Back to this step')).toHaveCount(0);
    await settle(page);
    expect(await orbit()).toBe(settings[1]['camera-orbit']);
    // The next step lets nothing of the hand stay.
    await page.mouse.move(160, 200);
    await page.mouse.down();
    await page.mouse.move(90, 195, { steps: 4 });
    await page.mouse.up();
    await button(page, '1. First').click();
    await settle(page);
    expect(await orbit()).toBe(plainAttributes['camera-orbit']);
  });

  test('restore the view when they are removed in the middle of a move, and go on when they are moved', async ({
    page,
  }) => {
    await open(page, `${lesson('duration="800"')}<div id="elsewhere"></div>`);
    await settle(page);
    await button(page, 'Next step').click();
    await page.evaluate(() => document.querySelector('#elsewhere')!.append(document.querySelector('volume-tour')!));
    await expect.poll(() => stateOf(page)).toEqual(stateIn(2));
    await button(page, '4. Fourth').click();
    await page.evaluate(() => {
      const tour = document.querySelector('volume-tour')!;
      (window as unknown as { tour: Element }).tour = tour;
      tour.remove();
    });
    await expect.poll(() => stateOf(page)).toEqual(stateIn(0));
    await page.waitForTimeout(600);
    expect(await stateOf(page)).toEqual(stateIn(0));
    await page.evaluate(() =>
      document.querySelector('#elsewhere')!.append((window as unknown as { tour: Element }).tour),
    );
    await expect.poll(() => stateOf(page)).toEqual(stateIn(4));
    await page.evaluate(() => document.querySelector('volume-view')!.remove());
    await expect(page.locator('volume-tour [part=hint]')).toContainText('seen');
    await button(page, '2. Second').click();
    await expect(page.getByText('Text 2')).toBeVisible();
  });

  test('go on when a note, the open step or another one is removed in the middle of a move', async ({ page }) => {
    await open(page, lesson('duration="800"'));
    await settle(page);
    const heard = await listen(page);
    const expectState = (step: number) => expect.poll(() => stateOf(page)).toEqual({ ...stateIn(step), isOpen: false });
    const remove = (selector: string) => page.evaluate((one) => document.querySelector(one)!.remove(), selector);
    await button(page, 'Next step').click();
    await remove('volume-note');
    await expectState(2);
    await button(page, '4. Fourth').click();
    await remove('#step-4');
    await expect(page.getByText('Text 3')).toBeVisible();
    await expectState(3);
    await button(page, '2. Second').click();
    await remove('#step-1');
    await expect(page.getByText('Text 3')).toBeVisible(); // It is the second one now.
    await expectState(3);
    await button(page, 'Leave the tour').click();
    await page.waitForTimeout(900);
    await expectState(0);
    const changes = (await heard()) as [type: string, detail: { step: number; id: string } | null][];
    expect(changes.flatMap(([type, detail]) => (type === 'step-change' ? [[detail!.step, detail!.id]] : []))).toEqual([
      [2, 'step-2'],
      [4, 'step-4'],
      [3, 'step-3'],
      [2, 'step-2'],
      [2, 'step-3'],
      [0, ''],
    ]);
  });

  test('outlive a lost context in the middle of a move, and a resize', async ({ page }) => {
    await open(page, lesson('duration="500"'));
    await settle(page);
    await forgetEvents(page);
    await button(page, 'Next step').click();
    await page.evaluate(() => {
      const element = document.querySelector('volume-view')!;
      element.style.width = '300px';
      const canvas = element.shadowRoot!.querySelector('canvas')!;
      const gl = (canvas.getContext('webgl2') ?? canvas.getContext('webgl')) as WebGLRenderingContext;
      gl.getExtension('WEBGL_lose_context')!.loseContext();
    });
    await waitForEvent(page, 'render');
    await settle(page);
    await expect.poll(() => stateOf(page)).toEqual(stateIn(2));
    await button(page, '1. First').click();
    await expect.poll(() => stateOf(page)).toEqual(stateIn(1));
  });

  test('say in words what they can not read, and go on with the rest', async ({ page }) => {
    await open(page, lesson('', [{}, { src: '/stranger.nii', 'opacity-factor': '2' }]));
    await settle(page);
    const problem = page.locator('volume-tour [part=error]');
    await expect(problem).toHaveText(
      '<volume-step> got the attribute src; it belongs on the <volume-view>, and is the same in all steps.',
    );
    const heard = await listen(page);
    await button(page, 'Next step').click();
    await expect(page.locator('volume-view')).toHaveAttribute('opacity-factor', '2');
    await expect(page.locator('volume-view')).toHaveAttribute('src', fieldUrl);
    const change = (selector: string, name: string, value: string | null): Promise<void> =>
      page.evaluate(
        ([selector, name, value]) => {
          const element = document.querySelector(selector!)!;
          if (value === null) element.removeAttribute(name!);
          else element.setAttribute(name!, value);
        },
        [selector, name, value],
      );
    await change('#step-2', 'src', null);
    await expect(problem).toHaveCount(0);
    await change('#step-2', 'onclick', 'window.hacked = 1');
    await change('#step-2', 'camera-orbitt', '0deg');
    await expect(problem).toHaveText(
      /got the attribute camera-orbitt; expected an attribute of <volume-view>, or labels, notes/,
    );
    await change('#step-2', 'camera-orbitt', null);
    await change('#step-2', 'notes', 'nobody');
    await expect(problem).toHaveText(/notes of <volume-step> got "nobody"; expected the id of a <volume-note>/);
    await change('#step-2', 'notes', '');
    await change('volume-tour', 'step', '9');
    await expect(problem).toHaveText(
      /step of <volume-tour> got "9"; expected the number of a step, 1 to 2, or 0 for none/,
    );
    await expect(page.getByText('Text 2')).toBeVisible();
    await change('volume-tour', 'step', '2');
    await change('volume-tour', 'duration', 'long');
    await expect(problem).toHaveText(/duration of <volume-tour> got "long"; expected milliseconds/);
    await change('volume-tour', 'duration', null);
    await expect(problem).toHaveCount(0);
    await change('volume-tour', 'for', 'nobody');
    await expect(page.locator('volume-tour [part=hint]')).toContainText('nobody');
    await expect.poll(() => stateOf(page)).toEqual(stateIn(0));
    expect(await page.evaluate(() => document.querySelector('volume-view')!.hasAttribute('onclick'))).toBe(false);
    expect((await heard()).filter((one) => (one as string[])[0] === 'error')).toHaveLength(4);
  });

  test('never read HTML from a heading', async ({ page }) => {
    await open(
      page,
      `${view('seen')}<volume-tour for="seen"><volume-step><h2>&lt;img src=x onerror="window.hacked=1"&gt;</h2></volume-step></volume-tour>`,
    );
    await expect(button(page, '1. <img src=x onerror="window.hacked=1">')).toBeVisible();
    expect(await page.evaluate(() => document.querySelector('volume-tour')!.shadowRoot!.querySelector('img'))).toBe(
      null,
    );
  });

  test('go on when steps are added and removed', async ({ page }) => {
    await open(page, lesson('step="4"'));
    await settle(page);
    await expect(page.getByText('Text 4')).toBeVisible();
    await page.evaluate(() => document.querySelectorAll('volume-step').forEach((one, i) => i > 1 && one.remove()));
    await expect(page.locator('volume-tour [part=error]')).toContainText('expected the number of a step, 1 to 2');
    await expect(page.getByText('Text 2')).toBeVisible();
    await page.evaluate(() => {
      document
        .querySelector('volume-tour')!
        .insertAdjacentHTML('beforeend', '<div><volume-step label="New"><p>Text of a new step</p></volume-step></div>');
      document.querySelector('volume-tour')!.step = 3;
    });
    await expect(page.getByText('Text of a new step')).toBeVisible();
    await expect(button(page, '3. New')).toHaveAttribute('aria-current', 'step');
    await expect(page.locator('volume-tour [part=error]')).toHaveCount(0);
  });

  test('of one view: one is open at a time', async ({ page }) => {
    await open(
      page,
      `${lesson()}<volume-tour id="second" for="seen" step="0"><volume-step rings="5" opacity-factor="2"><h2>Other</h2></volume-step></volume-tour>`,
    );
    await settle(page);
    await page.locator('volume-tour').first().getByRole('button', { name: 'Next step' }).click();
    await expect.poll(() => stateOf(page)).toEqual(stateIn(2));
    await page.locator('#second').getByRole('button', { name: 'Start the tour' }).click();
    await expect.poll(() => stateOf(page)).toEqual({ ...stateIn(0), rings: '5', 'opacity-factor': '2' });
    await expect(page.locator('volume-tour').first()).toHaveAttribute('step', '0');
    await page.keyboard.press('Escape');
    await expect.poll(() => stateOf(page)).toEqual(stateIn(0));
  });

  test('move a slice, and put it back', async ({ page }) => {
    await open(
      page,
      `${view('seen').replace('</volume-view>', '<volume-slice type="axial" at="2"></volume-slice></volume-view>')}${tourOf('', [{}, { slice: 'coronal -3' }])}`,
    );
    await settle(page);
    const slice = page.locator('volume-slice');
    await button(page, 'Next step').click();
    await expect(slice).toHaveAttribute('type', 'coronal');
    await expect(slice).toHaveAttribute('at', '-3');
    await button(page, 'Previous step').click();
    await expect(slice).toHaveAttribute('type', 'axial');
    await expect(slice).toHaveAttribute('at', '2');
  });

  test('show some labels, all, or none of them: attributes and pixels are those of a fresh tag', async ({ page }) => {
    const folder = '/test/e2e/pages/data/tour';
    await serveFiles(page, folder, { 'atlas.nii': Buffer.from(niftiBytes(atlas)) });
    const slow = 'interaction="none" steps="40" value-window="0 255" transfer-function="0 white 0, 60 white 40%"';
    const labelled = (id: string, attributes: string, slice: string): string =>
      `<volume-view id="${id}" src="${fieldUrl}" ${slow} camera-orbit="0deg 80deg auto" style="width: 90px; height: 68px" alt="A field"><volume-labels src="${folder}/atlas.nii" ${attributes}><volume-label value="3" color="red"></volume-label><volume-label value="7" color="blue"></volume-label></volume-labels><volume-slice ${slice}></volume-slice></volume-view>`;
    const steps: readonly (readonly [step: Record<string, string>, labels: string, slice: string])[] = [
      [{}, '', 'type="axial" at="2" hidden'],
      [{ labels: '3' }, 'only="3"', 'type="axial" at="2" hidden'],
      [{ labels: '7 ghost', slice: 'coronal -3' }, 'only="7 ghost"', 'type="coronal" at="-3"'],
      [{ labels: 'none', slice: 'none' }, 'hidden', 'type="axial" at="2" hidden'],
      [{ labels: 'all', slice: 'sagittal' }, '', 'type="sagittal"'],
    ];
    const settings = steps.map(([step]) => step);
    await open(
      page,
      `${labelled('seen', steps[0][1], steps[0][2])}<volume-tour for="seen" duration="0">${settings.map((step, i) => `<volume-step ${write(step)}><h2>Step ${i + 1}</h2></volume-step>`).join('')}</volume-tour><div id="fresh-one"></div>`,
    );
    await settle(page, '#seen');
    const attributes = (id: string): Promise<unknown> =>
      page.evaluate(
        (id) =>
          ['volume-labels', 'volume-slice'].map((name) => {
            const element = document.querySelector(`#${id} ${name}`)!;
            return Object.fromEntries(element.getAttributeNames().map((name) => [name, element.getAttribute(name)]));
          }),
        id,
      );
    const pictures: number[] = [];
    for (const step of [2, 3, 5, 4, 1]) {
      // What a person chooses in a list does not stay in the next step.
      await page.evaluate(() => (document.querySelector('volume-labels')!.hiddenLabels = [0, 3]));
      await page.evaluate((step) => {
        document.querySelector('volume-tour')!.step = step;
      }, step);
      const [, labels, slice] = steps[step - 1];
      await page.evaluate(
        (html) => (document.querySelector('#fresh-one')!.innerHTML = html),
        labelled('fresh', labels, slice),
      );
      await settle(page, '#fresh');
      await settle(page, '#seen');
      expect(await attributes('seen'), `step ${step}`).toEqual(await attributes('fresh'));
      const [toured, fresh] = [
        await takePicture(page, { selector: '#seen' }),
        await takePicture(page, { selector: '#fresh' }),
      ];
      expect(compare(toured, fresh).worst, `step ${step}`).toBeLessThanOrEqual(2);
      pictures[step] = meanOf(toured)[0] - meanOf(toured)[2];
    }
    // Red alone is redder than red and blue, and those than a plain field.
    expect(pictures[2] - pictures[4]).toBeGreaterThan(1);
    expect(pictures[3] - pictures[4]).toBeLessThan(-1);
    await expect(page.locator('volume-tour [part=error]')).toHaveCount(0);
  });

  test('have no faults that axe finds: open, turned and left', async ({ page }) => {
    await open(page, `<main><h1>A lesson</h1>${lesson()}</main>`);
    await settle(page);
    expect(await findFaults(page)).toEqual([]);
    await page.keyboard.press('Tab');
    await page.locator('volume-view').evaluate((element: HTMLElement) => element.focus());
    await page.keyboard.press('ArrowRight');
    await expect(button(page, 'Back to this step')).toBeVisible();
    expect(await findFaults(page)).toEqual([]);
    await button(page, 'Leave the tour').click();
    expect(await findFaults(page)).toEqual([]);
  });

  test('work as the guide writes them', async ({ page }) => {
    const guide = readFileSync(join(projectRoot, 'docs/guide/tours.md'), 'utf8');
    const [, html] = /^```html\n([^]*?)^```$/m.exec(guide)!;
    expect(html).toContain('src="head.nii.gz"');
    await open(page, html.replace('head.nii.gz', fieldUrl));
    await settle(page);
    await button(page, 'Next step').click();
    await expect(page.getByRole('heading', { name: 'What joins the halves' })).toBeFocused();
    await expect(page.locator('volume-view')).toHaveAttribute('region', '0 -120 -80 90 90 100');
    await button(page, 'Previous step').click();
    await expect(page.locator('volume-view')).not.toHaveAttribute('region');
    await expect(page.locator('volume-tour [part=error]')).toHaveCount(0);
  });

  test('are headings, texts and pictures on paper', async ({ page }) => {
    const pane = '<volume-slice-view for="seen" alt="A pane"></volume-slice-view>';
    await open(
      page,
      lesson().replace('<p>Text 2</p>', `<p>Text 2</p>${poster}`).replace('<p>Text 3</p>', `<p>Text 3</p>${pane}`),
    );
    await settle(page);
    const picture = page.getByRole('img', { name: 'Half a field on paper' });
    await button(page, 'Next step').click();
    await expect(picture).toHaveCount(0);
    await page.emulateMedia({ media: 'print' });
    for (const [i, name] of names.entries()) {
      await expect(page.getByRole('heading', { name })).toBeVisible();
      await expect(page.getByText(`Text ${i + 1}`)).toBeVisible();
    }
    await expect(picture).toBeVisible();
    await expect(page.locator('volume-slice-view')).toBeHidden(); // It has nothing to show of a closed step.
    await expect(button(page, 'Next step')).toBeHidden();
    await page.emulateMedia({ media: null });
    await expect(picture).toHaveCount(0);
  });
});

/** Where no element is: a pointer over the view or the tour holds a tour that plays. */
const moveAway = (page: Page): Promise<void> => page.mouse.move(1200, 700);

test.describe('tours that play', () => {
  const playing = (more: string): string => lesson(`${more} duration="0"`);
  const stepNow = (page: Page): Promise<number | null> =>
    page.evaluate(() => document.querySelector('volume-tour')!.step);
  /** Whether another step opens within the time of one and a half. */
  const goesOn = async (page: Page): Promise<boolean> => {
    const before = await stepNow(page);
    return page
      .waitForFunction((before) => document.querySelector('volume-tour')!.step !== before, before, { timeout: 1700 })
      .then(
        () => true,
        () => false,
      );
  };

  test('open one step after the other and begin again, quietly; a button pauses them', async ({ page }) => {
    await moveAway(page);
    await open(page, `<main><h1>A lesson</h1>${playing('autoplay dwell="1"')}</main>`);
    await settle(page);
    const heard = await listen(page);
    await expect.poll(() => stepNow(page)).toBe(4);
    await expect.poll(() => stepNow(page)).toBe(1);
    expect(await heard()).toContainEqual(['tour-complete', null]);
    // A person did not ask for it: no sentence interrupts a screen reader, and the focus stays.
    await expect(page.locator('volume-tour').getByRole('status')).toBeEmpty();
    await expect(page.locator('body')).toBeFocused();
    await button(page, 'Pause').click();
    await moveAway(page);
    expect(await goesOn(page)).toBe(false);
    expect(await page.evaluate(() => document.querySelector('volume-tour')!.paused)).toBe(true);
    expect(await findFaults(page)).toEqual([]);
    await button(page, 'Play').click();
    // The pointer and the focus are still at the button.
    expect(await goesOn(page)).toBe(true);
    await button(page, 'Leave the tour').click();
    await moveAway(page);
    expect(await goesOn(page)).toBe(false);
    await button(page, 'Start the tour').click();
    await moveAway(page);
    expect(await goesOn(page)).toBe(true);
  });

  test('wait while a person uses the view or the tour', async ({ page }) => {
    await moveAway(page);
    await open(page, playing('autoplay dwell="1"'));
    await settle(page);
    await page.locator('volume-view').hover();
    expect(await goesOn(page), 'pointer over the view').toBe(false);
    await moveAway(page);
    expect(await goesOn(page), 'pointer elsewhere').toBe(true);
    await button(page, 'Pause').focus();
    await page.keyboard.press('Tab');
    expect(await goesOn(page), 'keys in the tour').toBe(false);
    await page.evaluate(() => (document.activeElement as HTMLElement).blur());
    expect(await goesOn(page), 'keys elsewhere').toBe(true);
    await page.locator('volume-tour').hover({ position: { x: 200, y: 5 } });
    expect(await goesOn(page), 'pointer over the tour').toBe(false);
    await moveAway(page);
    await page.evaluate(() => (document.querySelector('volume-view')!.style.marginTop = '4000px'));
    await expect.poll(() => goesOn(page), 'the view is out of sight').toBe(false);
    await page.evaluate(() => (document.querySelector('volume-view')!.style.marginTop = ''));
    expect(await goesOn(page), 'the view is in sight').toBe(true);
    await page.evaluate(() => document.querySelector('volume-view')!.remove());
    expect(await goesOn(page), 'no view').toBe(false);
  });

  test('wait for a person who wants less motion', async ({ page }) => {
    await page.emulateMedia({ reducedMotion: 'reduce' });
    await moveAway(page);
    await open(page, playing('autoplay dwell="1"'));
    await settle(page);
    expect(await goesOn(page)).toBe(false);
    await button(page, 'Play').click();
    await moveAway(page);
    expect(await goesOn(page)).toBe(true);
    await page.emulateMedia({ reducedMotion: null });
    expect(await goesOn(page)).toBe(true);
    await page.emulateMedia({ reducedMotion: 'reduce' });
    await expect(button(page, 'Play')).toBeVisible();
    expect(await goesOn(page)).toBe(false);
    await page.emulateMedia({ reducedMotion: null });
    await expect(button(page, 'Pause')).toBeVisible();
  });

  test('play for scripts, each step for its own time, and say which time they can not read', async ({ page }) => {
    await moveAway(page);
    await open(page, playing('dwell="1"').replace('id="step-2"', 'id="step-2" dwell="30"'));
    await settle(page);
    await expect(button(page, 'Play')).toHaveCount(0);
    expect(await goesOn(page)).toBe(false);
    await page.evaluate(() => document.querySelector('volume-tour')!.play());
    await expect(button(page, 'Pause')).toBeVisible();
    expect(await goesOn(page)).toBe(true);
    expect(await goesOn(page), 'a step with a time of its own').toBe(false);
    await page.evaluate(() => document.querySelector('volume-tour')!.pause());
    await expect(button(page, 'Pause')).toHaveCount(0);
    await page.evaluate(() => document.querySelector('#step-2')!.setAttribute('dwell', '8000'));
    await expect(page.locator('volume-tour [part=error]')).toHaveText(
      'dwell of <volume-step> got "8000"; expected seconds, 1 to 3600.',
    );
  });
});

test.describe('tours that follow the page', () => {
  const article = (steps = settings): string =>
    `<style>.article { display: grid; grid-template-columns: 1fr 1fr } .article volume-view { position: sticky; top: 10px }
     @media (max-width: 600px) { .article { display: block } .article volume-view { top: 0; background: white } }</style>
     <main><h1>An article</h1><div class="article">${view('seen')}${tourOf('by="scroll" duration="0"', steps)}</div></main>`;
  /** Scroll until a text is at a share of the window's height. */
  const bring = (page: Page, text: string, share: number): Promise<void> =>
    page.getByText(text, { exact: true }).evaluate((element, share) => {
      const { top, height } = element.getBoundingClientRect();
      scrollBy(0, top + height / 2 - share * innerHeight);
    }, share);

  test('show all texts, and the step whose text is in the middle; they never scroll by themselves', async ({
    page,
  }) => {
    await open(page, article());
    await settle(page);
    await expect.poll(() => stateOf(page)).toEqual(stateIn(1));
    for (const [i, name] of names.entries()) {
      await expect(page.getByRole('heading', { name })).toBeVisible();
      await expect(page.getByText(`Text ${i + 1}`)).toBeVisible();
    }
    await expect(page.locator('volume-tour').getByRole('button')).toHaveCount(0);
    for (const step of [2, 3, 4, 2, 1]) {
      await bring(page, `Text ${step}`, 0.5);
      const before = await page.evaluate(() => scrollY);
      await expect.poll(() => stateOf(page)).toEqual(stateIn(step));
      await expect(page.locator(`#step-${step}:state(open)`)).toHaveCount(1);
      expect(await page.evaluate(() => scrollY)).toBe(before);
    }
    await expect(page.locator('volume-tour').getByRole('status')).toBeEmpty();
    await page.evaluate(() => scrollTo(0, 1e6)); // Past the middle of the last one.
    await expect.poll(() => stateOf(page)).toEqual(stateIn(4));
    expect(await findFaults(page)).toEqual([]);
  });

  test('take the middle of what a view over the text leaves free, on a phone', async ({ page }) => {
    await page.setViewportSize({ width: 390, height: 800 });
    await open(page, article());
    await settle(page);
    // The view is 240 high: the middle of the rest is at 520, of 800.
    await bring(page, 'Text 2', 0.65);
    await expect.poll(() => stateOf(page)).toEqual(stateIn(2));
    await bring(page, 'Text 3', 0.65);
    await expect.poll(() => stateOf(page)).toEqual(stateIn(3));
    await page.setViewportSize({ width: 390, height: 500 });
    await bring(page, 'Text 2', 0.74);
    await expect.poll(() => stateOf(page)).toEqual(stateIn(2));
    await page.setViewportSize({ width: 1280, height: 720 });
  });

  test('scroll to the step that a script opens, and bring back a view that a person has turned', async ({ page }) => {
    await open(page, article());
    await settle(page);
    await page.evaluate(() => {
      document.querySelector('volume-tour')!.step = 4;
    });
    await expect(page.getByText('Text 4')).toBeInViewport();
    await expect.poll(() => stateOf(page)).toEqual(stateIn(4));
    const { x, y } = (await page.locator('volume-view').boundingBox())!;
    await page.mouse.move(x + 160, y + 200);
    await page.mouse.down();
    await page.mouse.move(x + 230, y + 205, { steps: 4 });
    await page.mouse.up();
    await expect(button(page, 'Back to this step')).toBeInViewport();
    const before = await page.evaluate(() => scrollY);
    await button(page, 'Back to this step').click();
    await expect(button(page, 'Back to this step')).toHaveCount(0);
    await settle(page);
    expect(await page.evaluate(() => document.querySelector('volume-view')!.cameraOrbit)).toBe(
      settings[3]['camera-orbit'],
    );
    expect(await page.evaluate(() => scrollY)).toBe(before);
    await page.evaluate(() => document.querySelector('volume-tour')!.setAttribute('by', 'wheel'));
    await expect(page.locator('volume-tour [part=error]')).toHaveText(
      'by of <volume-tour> got "wheel"; expected scroll.',
    );
  });
});

test.describe('tours without scripts', () => {
  const css = readFileSync(join(projectRoot, 'scripts/zip/volume-view.css'), 'utf8');

  test('are headings, texts and pictures', async ({ browser }) => {
    const page = await browser.newPage({ javaScriptEnabled: false });
    await page.setContent(
      `<!doctype html><title>Test</title><style>${css}</style>${lesson().replace('<p>Text 2</p>', `<p>Text 2</p>${poster}`)}`,
    );
    for (const [i, name] of names.entries()) {
      await expect(page.getByRole('heading', { name })).toBeVisible();
      await expect(page.getByText(`Text ${i + 1}`)).toBeVisible();
    }
    await expect(page.getByRole('img', { name: 'Half a field on paper' })).toBeVisible();
    await page.close();
  });

  test('show their first step before the script has come, with the picture to come; all texts if they follow the page', async ({
    browser,
  }) => {
    const page = await browser.newPage();
    const html = (more: string): string =>
      `<!doctype html><title>Test</title><style>${css}</style>${lesson(more).replace('<p>Text 1</p>', `<p>Text 1</p>${poster}`)}`;
    await page.setContent(html(''));
    await expect(page.getByText('Text 1')).toBeVisible();
    await expect(page.getByText('Text 2')).toBeHidden();
    await expect(page.getByRole('img', { name: 'Half a field on paper' })).toHaveCount(0);
    await page.setContent(html('by="scroll"'));
    await expect(page.getByText('Text 4')).toBeVisible();
    await page.close();
  });
});
