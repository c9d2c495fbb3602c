// <volume-question>
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Locator, Page } from '@playwright/test';
import { projectRoot } from '../../scripts/shared-data.mjs';
import { findFaults } from './helpers/axe.ts';
import { attributesOf } from './helpers/reference.ts';
import {
  expect,
  fewPixels,
  fieldUrl,
  open as openPage,
  settle,
  keptTest as test,
  test as freshTest,
} from './helpers/harness.ts';
import { line, touch } from './helpers/touch.ts';

test.use(fewPixels);

const size = 'style="width: 320px; height: 240px"';
const view = `<volume-view id="seen" src="${fieldUrl}" ${attributesOf({ 'transfer-function': '0.15 #003 0, 0.4 #c63 0.3, 0.8 #ffc 0.8' })} ${size} alt="A field"></volume-view>`;
const ask = (attributes: string, inner = '', id = 'q'): string =>
  `<volume-question id="${id}" for="seen" ${attributes}><h2>A question</h2>${inner}</volume-question>`;
const list = '<ul><li>Left</li><li correct>Right <em>one</em></li><li>Middle</li></ul>';
const said = '<p slot="hint">A hint</p><p slot="right">Well done</p><p slot="wrong">Look again</p>';

const open = (page: Page, body: string): Promise<void> => openPage(page, `<main><h1>A lesson</h1>${body}</main>`);
const question = (page: Page, id = 'q'): Locator => page.locator(`#${id}`);
const button = (page: Page, name: string): Locator => question(page).getByRole('button', { name, exact: true });
const statusOf = (page: Page): Locator => question(page).getByRole('status');

/** The `answer` events that reach the page from now on. */
async function listen(page: Page): Promise<() => Promise<unknown[]>> {
  await page.evaluate(() => {
    const seen: unknown[] = ((window as unknown as { heard: unknown[] }).heard = []);
    document.body.addEventListener('answer', (event) => seen.push((event as CustomEvent).detail));
    for (const one of document.querySelectorAll('volume-question'))
      one.addEventListener('error', (event) =>
        seen.push((event as unknown as CustomEvent<{ message: string }>).detail.message),
      );
  });
  return () => page.evaluate(() => (window as unknown as { heard: unknown[] }).heard);
}

/** Ask for the place that is seen in the middle of the picture. */
const findMiddle = (page: Page, radius = 1.5): Promise<number[]> =>
  page.evaluate(async (radius) => {
    const [element, asked] = [document.querySelector('volume-view')!, document.querySelector('volume-question')!];
    const { left, top, width, height } = element.getBoundingClientRect();
    const found = (await element.positionFromPoint(left + width / 2, top + height / 2))!;
    asked.setAttribute('position', found.position.join(' '));
    asked.setAttribute('radius', String(radius));
    await asked.updateComplete;
    return [...found.position];
  }, radius);

/** A place in the picture, CSS pixels from its middle. */
async function clickAt(page: Page, x: number, y: number): Promise<void> {
  const box = (await page.locator('volume-view').boundingBox())!;
  await page.mouse.click(box.x + box.width / 2 + x, box.y + box.height / 2 + y);
}

test.describe('questions', () => {
  test('let readers choose, by keys alone, with tries, hints and what the author says', async ({ page }) => {
    await open(page, view + ask('tries="3"', list + said));
    await settle(page);
    await expect(question(page)).toMatchAriaSnapshot(`
      - heading "A question" [level=2]
      - radiogroup "A question":
        - radio "Left"
        - radio "Right one"
        - radio "Middle"
      - button "Answer"
      - button "Hint"
      - status
    `);
    expect(await findFaults(page)).toEqual([]);
    const heard = await listen(page);
    await button(page, 'Answer').focus();
    await page.keyboard.press('Enter');
    await expect(statusOf(page)).toHaveText('Give an answer first.');
    await page.keyboard.press('Space');
    await expect(page.getByRole('radio', { name: 'Left' })).toBeChecked();
    await page.keyboard.press('Enter');
    await expect(statusOf(page)).toHaveText('Not right. Tries left: 2. A hint Look again');
    await expect(page.getByText('Look again').first()).toBeVisible();
    await expect(page.getByText('Well done')).toBeHidden();
    // The box has its own spaces, whatever the page gives to paragraphs.
    const margins = [page.getByText('A hint').first(), page.getByText('Look again').first()].map((one) =>
      one.evaluate((text) => getComputedStyle(text).marginBlock),
    );
    expect(await Promise.all(margins)).toEqual(['0px', '0px']);
    await page.keyboard.press('ArrowDown');
    await page.keyboard.press('Enter');
    await expect(statusOf(page)).toHaveText('Right. Well done');
    await expect(question(page).locator('[part=feedback]')).toBeFocused();
    await expect(page.getByText('Well done').first()).toBeVisible();
    await expect(page.getByRole('radio', { name: 'Left' })).toBeDisabled();
    expect(await heard()).toEqual([
      { id: 'q', response: 'Left', chosen: [0], correct: false, tries: 1 },
      { id: 'q', response: 'Right one', chosen: [1], correct: true, tries: 2 },
    ]);
    expect(await findFaults(page)).toEqual([]);
  });

  test('want all of several right answers, and show them after the last try', async ({ page }) => {
    const several = '<ol><li correct>One</li><li correct>Two</li><li>Three</li></ol>';
    await open(page, view + ask('tries="1"', several));
    await settle(page);
    await expect(question(page)).toMatchAriaSnapshot(`
      - group "A question":
        - checkbox "One"
        - checkbox "Two"
        - checkbox "Three"
    `);
    await page.getByRole('checkbox', { name: 'One' }).check();
    await button(page, 'Answer').click();
    await expect(question(page).getByText('Right answer: One, Two')).toBeVisible();
    await expect(button(page, 'Answer')).toHaveCount(0);
    await page.evaluate(() => document.querySelector('volume-question')!.reset());
    await expect(page.getByRole('checkbox', { name: 'One' })).not.toBeChecked();
    for (const name of ['One', 'Two']) await page.getByRole('checkbox', { name }).check();
    await button(page, 'Answer').click();
    await expect(question(page).getByText('Right.', { exact: true }).first()).toBeVisible();
  });

  test('find a place by a click, through what is translucent, and not by a drag', async ({ page }) => {
    await open(page, view + ask('type="find" position="0 0 0" radius="1" tries="3"', said));
    await settle(page);
    const heard = await listen(page);
    const middle = await findMiddle(page);
    await clickAt(page, -158, -118);
    await expect(statusOf(page)).toHaveText('Nothing is seen there');
    await clickAt(page, 40, 20);
    await expect(statusOf(page)).toContainText('Not right. Tries left: 2.');
    await expect(page.locator('volume-view').getByRole('button', { name: 'Your answer' })).toBeVisible();
    await page.mouse.move(200, 100);
    await page.mouse.down();
    await page.mouse.move(160, 120, { steps: 4 });
    await page.mouse.up();
    expect(await heard()).toHaveLength(1);
    await page.evaluate(() => document.querySelector('volume-view')!.setAttribute('camera-orbit', '35deg 65deg 90'));
    await settle(page);
    await clickAt(page, 0, 0);
    await expect(statusOf(page)).toHaveText('Right. Well done');
    const [, { response, ...rest }] = (await heard()) as [unknown, { response: string }];
    expect(rest).toEqual({ id: 'q', chosen: [], correct: true, tries: 2 });
    response.split(' ').forEach((text, i) => expect(Math.abs(Number(text) - middle[i])).toBeLessThan(0.5));
    await clickAt(page, 40, 20);
    await page.waitForTimeout(300);
    expect(await heard()).toHaveLength(2);
  });

  test('find a place by keys alone: a crosshair says what is under it', async ({ page }) => {
    await open(page, view + ask('type="find" position="0 0 0" radius="1" tries="2"', said));
    await settle(page);
    await findMiddle(page);
    await expect(question(page)).toMatchAriaSnapshot(`
      - heading "A question" [level=2]
      - paragraph: Click the place in the picture.
      - button "Crosshair"
      - button "Hint"
      - status
    `);
    await button(page, 'Crosshair').focus();
    await page.keyboard.press('Enter');
    const crosshair = page.getByRole('application', { name: 'Crosshair' });
    await expect(crosshair).toBeFocused();
    const under = page.locator('volume-view .aim [role=status]');
    await expect(under).toHaveText(/^[\d.]+\. 50% from the left, 50% from the top$/);
    expect(await findFaults(page)).toEqual([]);
    const camera = await page.evaluate(() => document.querySelector('volume-view')!.camera!.eye);
    await page.keyboard.press('Shift+ArrowRight');
    await page.keyboard.press('ArrowDown');
    await expect(under).toHaveText(/63% from the left, 52% from the top$/);
    expect(await page.evaluate(() => document.querySelector('volume-view')!.camera!.eye)).toEqual(camera);
    await page.keyboard.press('Enter');
    await expect(statusOf(page)).toContainText('Not right. Tries left: 1.');
    await expect(crosshair).toBeFocused();
    await page.keyboard.press('Escape');
    await expect(button(page, 'Crosshair')).toBeFocused();
    await page.keyboard.press('Enter');
    await page.keyboard.press('Enter');
    await expect(statusOf(page)).toHaveText('Right. Well done');
    await expect(question(page).locator('[part=feedback]')).toBeFocused();
    await expect(crosshair).toHaveCount(0);
  });

  test('show the right place after the last try', async ({ page }) => {
    await open(page, view + ask('type="find" position="0 0 0" radius="0.01" tries="1"'));
    await settle(page);
    const mark = page.locator('volume-view').getByRole('button', { name: 'Right place' });
    await expect(mark).toHaveCount(0);
    await clickAt(page, 60, 30);
    await expect(mark).toBeVisible();
  });

  test('let readers name a marked place, whatever its accents', async ({ page }) => {
    await open(page, view + ask('type="label" position="0 0 0" answer="Hémisphère, half"', said));
    await settle(page);
    const mark = page.locator('volume-view').getByRole('button', { name: 'This place' });
    await expect(mark).toBeVisible();
    await expect(question(page)).toMatchAriaSnapshot(`
      - heading "A question" [level=2]
      - textbox "A question"
      - button "Answer"
      - button "Hint"
      - status
    `);
    expect(await findFaults(page)).toEqual([]);
    await mark.click();
    await expect(page.getByRole('textbox')).toBeFocused();
    await page.keyboard.type('hemi');
    await page.keyboard.press('Enter');
    await expect(statusOf(page)).toContainText('Not right.');
    await page.getByRole('textbox').fill(' HEMISPHERE');
    await page.keyboard.press('Enter');
    await expect(statusOf(page)).toHaveText('Right. Well done');
  });

  test('let readers read a value', async ({ page }) => {
    await open(page, view + ask('type="value" answer="0.5" tolerance="0.1" unit="g/cm³" tries="2"'));
    await settle(page);
    await expect(question(page)).toMatchAriaSnapshot(`
      - heading "A question" [level=2]
      - textbox "A question"
      - text: g/cm³
      - button "Answer"
      - status
    `);
    await page.getByRole('textbox').fill('0,7');
    await page.keyboard.press('Enter');
    await expect(statusOf(page)).toContainText('Tries left: 1.');
    await page.getByRole('textbox').fill('0,6');
    await page.keyboard.press('Enter');
    await expect(statusOf(page)).toHaveText('Right.');
  });

  test('have their marks and clicks only while their step is open, and a score in the tour', async ({ page }) => {
    await open(
      page,
      `${view}<volume-tour for="seen"><volume-step><h2>One</h2>${ask('type="label" position="0 0 0" answer="a"')}</volume-step><volume-step><h2>Two</h2>${ask('', list, 'other')}</volume-step></volume-tour>`,
    );
    await settle(page);
    const mark = page.locator('volume-view').getByRole('button', { name: 'This place' });
    await expect(mark).toBeVisible();
    await page.locator('volume-tour').getByRole('button', { name: 'Next step' }).click();
    await expect(mark).toHaveCount(0);
    const other = question(page, 'other');
    await other.getByRole('radio', { name: 'Right one' }).check();
    await other.getByRole('button', { name: 'Answer' }).click();
    await expect(other.locator('[part=score]')).toHaveText('Right answers so far: 1 of 2');
    await page.locator('volume-tour').getByRole('button', { name: 'Previous step' }).click();
    await page.getByRole('textbox').fill('a');
    await page.keyboard.press('Enter');
    await expect(question(page).locator('[part=score]')).toHaveText('Right answers so far: 2 of 2');
    await expect(other.locator('[part=score]')).toHaveText('Right answers so far: 2 of 2');
  });

  test('find a place of a radar by a click: its heights are those before the exaggeration', async ({ page }) => {
    const radar = `<volume-view id="seen" src="/demos/data/storm-radar-island.json" vertical-exaggeration="4" rings="none" camera-target="-20000 -50000 6000" camera-orbit="190deg 62deg 30%" interaction="none" steps="60" ${size} alt="A storm"></volume-view>`;
    await open(page, radar + ask('type="find" latitude="0" longitude="0" height="9000" radius="3000" tries="3"', said));
    await settle(page);
    const heard = await listen(page);
    // The strongest echo, and the weakest one.
    const [strong, weak] = await page.evaluate(async () => {
      const element = document.querySelector('volume-view')!;
      const { left, top, width, height } = element.getBoundingClientRect();
      const all = [];
      for (let x = left + 10; x < left + width; x += 10)
        for (let y = top + 10; y < top + height; y += 10) {
          const found = await element.positionFromPoint(x, y);
          if (found) all.push({ x, y, value: found.value, position: [...found.position] });
        }
      all.sort((one, other) => other.value - one.value);
      return [all[0], all.at(-1)!];
    });
    expect(strong.value).toBeGreaterThan(weak.value + 20);
    const [east, north, up] = strong.position;
    expect(up).toBeLessThan(18000);
    // The radar stands at 0 degrees north and east, 450 m high, on a sphere of 6371 km: the azimuthal equidistant projection, backwards.
    const [angle, azimuth] = [Math.hypot(east, north) / 6371000, Math.atan2(east, north)];
    const degrees = 180 / Math.PI;
    const latitude = degrees * Math.asin(Math.sin(angle) * Math.cos(azimuth));
    const longitude = degrees * Math.atan2(Math.sin(angle) * Math.sin(azimuth), Math.cos(angle));
    await page.evaluate(
      ([latitude, longitude, height]) =>
        Object.assign(document.querySelector('volume-question')!, { latitude, longitude, height }),
      [latitude, longitude, up + 450],
    );
    await page.mouse.click(weak.x, weak.y);
    await expect(statusOf(page)).toContainText('Not right. Tries left: 2.');
    await page.mouse.click(strong.x, strong.y);
    await expect(statusOf(page)).toHaveText('Right. Well done');
    const [, { response }] = (await heard()) as [unknown, { response: string }];
    // A pixel is 700 m wide there, and a click is at a whole one.
    response.split(' ').forEach((text, i) => expect(Math.abs(Number(text) - strong.position[i])).toBeLessThan(700));
    // The mark is where the reader has clicked: heights are exaggerated there.
    const pin = (await page.locator('volume-view [part~="note-pin"]').boundingBox())!;
    expect(Math.hypot(pin.x + pin.width / 2 - strong.x, pin.y + pin.height / 2 - strong.y)).toBeLessThan(2);
  });

  test('of a tour that follows the page: a click answers the one of the open step', async ({ page }) => {
    const step = (id: string): string =>
      `<volume-step style="display: block; min-block-size: 700px"><h2>${id}</h2>${ask('type="find" position="0 0 0" radius="100"', '', id)}${ask('type="label" position="0 0 0" answer="a"', '', `${id}-name`)}</volume-step>`;
    await open(
      page,
      `<div style="display: grid; grid-template-columns: 340px 1fr">${view.replace('width:', 'position: sticky; top: 0; width:')}<volume-tour for="seen" by="scroll">${step('one')}${step('two')}</volume-tour></div>`,
    );
    await settle(page);
    const marks = page.locator('volume-view').getByRole('button', { name: 'This place' });
    await expect(marks).toHaveCount(1);
    await page.locator('#two').evaluate((element) => element.scrollIntoView({ block: 'center' }));
    await expect
      .poll(() => page.locator('volume-tour').evaluate((tour) => (tour as HTMLElement & { step: number }).step))
      .toBe(2);
    await expect(marks).toHaveCount(1);
    await marks.click();
    await expect(question(page, 'two-name').getByRole('textbox')).toBeFocused();
    await clickAt(page, 40, 20);
    await expect(question(page, 'two').locator('[part=feedback]')).toBeVisible();
    await expect(question(page, 'one').locator('[part=feedback]')).toHaveCount(0);
  });

  test('do nothing that hostile texts ask for, and say in words what is wrong', async ({ page }) => {
    const evil = '&quot;&gt;&lt;img src=x onerror=&quot;window.hit=1&quot;&gt;';
    await open(
      page,
      view +
        ask(`type="value" answer="1" unit="${evil}" tries="1"`) +
        ask(`type="${evil}"`, '', 'wrong') +
        ask('tries="1"', `<ul><li>${evil}</li><li correct>b</li></ul>`, 'third'),
    );
    await settle(page);
    await expect(question(page, 'wrong').getByRole('alert')).toContainText('type of <volume-question> got ""><img');
    await expect(question(page, 'wrong').getByRole('button')).toHaveCount(0);
    await page.getByRole('radio', { name: 'onerror' }).check();
    await question(page, 'third').getByRole('button', { name: 'Answer' }).click();
    await expect(question(page, 'third').locator('[part=feedback]')).toBeVisible();
    expect(await page.evaluate(() => (window as unknown as { hit?: number }).hit)).toBe(undefined);
    expect(await page.locator('volume-question img').count()).toBe(0);
    await page.evaluate(() => document.querySelector('#wrong')!.setAttribute('type', 'label'));
    await expect(question(page, 'wrong').getByRole('alert')).toContainText('answer of <volume-question> got ""');
  });

  test('stay within a phone, from right to left, and have no faults in the dark', async ({ page }) => {
    await page.setViewportSize({ width: 390, height: 800 });
    await page.emulateMedia({ colorScheme: 'dark' });
    await open(
      page,
      `<style>body { background: #14161a; color: #eee }</style>${view}${ask('', list + said)}${ask('type="value" answer="1" unit="dBZ"', '', 'second')}`,
    );
    await page.evaluate(() => {
      document.documentElement.dir = 'rtl';
      document.documentElement.lang = 'ar';
    });
    await settle(page);
    await expect(question(page).getByRole('button', { name: 'أجب' })).toBeVisible();
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(390);
    expect(await findFaults(page)).toEqual([]);
    await page.emulateMedia({ colorScheme: null });
    await page.setViewportSize({ width: 1280, height: 720 });
    await page.evaluate(() => (document.documentElement.lang = 'en'));
  });

  test('work as the guide writes them', async ({ page }) => {
    const guide = readFileSync(join(projectRoot, 'docs/guide/questions.md'), 'utf8');
    const snippets = [...guide.matchAll(/^```html\n([^]*?)^```$/gm)].map(([, html]) => html);
    expect(snippets).toHaveLength(4);
    await open(page, snippets.join('').replace('head.nii.gz', fieldUrl));
    await settle(page);
    await expect(page.locator('volume-question').nth(3).getByRole('textbox')).toBeVisible();
    await expect(page.locator('volume-question [part=error]')).toHaveCount(0);
    await page.getByRole('radio', { name: 'White matter' }).check();
    await page.getByRole('button', { name: 'Answer' }).first().click();
    await expect(page.getByText('Yes: fat around its fibres').first()).toBeVisible();
    await page.getByRole('textbox', { name: 'What is at this place?' }).fill('Left Thalamus');
    await page.keyboard.press('Enter');
    await page.getByRole('textbox', { name: 'What is the value' }).fill('130');
    await page.keyboard.press('Enter');
    await expect(page.locator('volume-question').nth(3).locator('[part=score]')).toHaveText(
      'Right answers so far: 3 of 4',
    );
  });
});

freshTest('answers survive a reload only with remember, and a page without storage', async ({ page }) => {
  await open(page, view + ask('remember', list) + ask('', list, 'other'));
  await settle(page);
  for (const id of ['q', 'other']) {
    await question(page, id).getByRole('radio', { name: 'Right one' }).check();
    await question(page, id).getByRole('button', { name: 'Answer' }).click();
    await expect(question(page, id).locator('[part=feedback]')).toBeVisible();
  }
  await page.reload();
  await expect(question(page).locator('[part=feedback]')).toBeVisible();
  await expect(question(page).getByRole('radio', { name: 'Right one' })).toBeChecked();
  await expect(question(page, 'other').getByRole('button', { name: 'Answer' })).toBeVisible();
  await page.evaluate(() => document.querySelector('volume-question')!.reset());
  await page.reload();
  await expect(button(page, 'Answer')).toBeVisible();
  await page.addInitScript(() =>
    Object.defineProperty(window, 'localStorage', {
      get() {
        throw new DOMException('no', 'SecurityError');
      },
    }),
  );
  await page.reload();
  await page.getByRole('radio', { name: 'Right one' }).first().check();
  await button(page, 'Answer').click();
  await expect(question(page).locator('[part=feedback]')).toBeVisible();
});

freshTest(
  'without scripts a question is a heading and a list, and on paper no button is left',
  async ({ browser, page }) => {
    await open(page, view + ask('', list + said));
    await settle(page);
    await page.emulateMedia({ media: 'print' });
    await expect(button(page, 'Answer')).toBeHidden();
    await expect(question(page).locator('[part=answer]', { hasText: 'Right one' })).toBeVisible();
    const plain = await browser.newPage({ javaScriptEnabled: false });
    const css = readFileSync(join(projectRoot, 'dist/volume-view.css'), 'utf8');
    await plain.setContent(`<style>${css}</style>${ask('', list + said)}`);
    await expect(plain.locator('body')).toMatchAriaSnapshot(`
    - heading "A question" [level=2]
    - list:
      - listitem: Left
      - listitem:
        - text: Right
        - emphasis: one
      - listitem: Middle
  `);
    await expect(plain.getByText('Well done')).toBeHidden();
    await plain.close();
  },
);

freshTest.describe('questions on a phone', () => {
  freshTest.use({ viewport: { width: 390, height: 800 }, hasTouch: true, isMobile: true });

  freshTest('find a place by a tap, and neither by a turn nor by two fingers', async ({ page }) => {
    await open(page, view + ask('type="find" position="0 0 0" radius="1" tries="3"', said));
    await settle(page);
    const heard = await listen(page);
    await findMiddle(page);
    const { x, y, width, height } = (await page.locator('volume-view').boundingBox())!;
    const [across, down] = [x + width / 2, y + height / 2];
    await touch(page, [line([across - 40, down], [across + 30, down])]);
    await touch(page, [line([across - 20, down], [across - 50, down]), line([across + 20, down], [across + 50, down])]);
    await settle(page);
    expect(await heard()).toEqual([]);
    await page.evaluate(() => document.querySelector('volume-view')!.setAttribute('camera-orbit', '35deg 65deg 90'));
    await settle(page);
    await page.touchscreen.tap(across + 40, down + 20);
    await expect(statusOf(page)).toContainText('Not right. Tries left: 2.');
    await page.touchscreen.tap(across, down);
    await expect(statusOf(page)).toHaveText('Right. Well done');
    await expect(question(page).locator('[part=feedback]')).toBeInViewport();
    expect((await heard()).map((one) => (one as { correct: boolean }).correct)).toEqual([false, true]);
  });
});
