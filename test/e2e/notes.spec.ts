// <volume-note>
import type { Locator, Page } from '@playwright/test';
import { findFaults } from './helpers/axe.ts';
import { attributesOf } from './helpers/reference.ts';
import {
  expect,
  fewPixels,
  fieldUrl,
  forgetEvents,
  keptTest as test,
  open,
  settle,
  takePicture,
  test as ownPage,
  waitForEvent,
  withElement,
} from './helpers/harness.ts';

const size = 'style="width: 480px; height: 360px"';

/** A view with these notes between its tags. */
const view = (notes: string, changes: Record<string, string> = {}, more = ''): string =>
  `<volume-view src="${fieldUrl}" ${attributesOf(changes)} ${size} ${more} alt="A field">${notes}</volume-view>`;

const three = `<volume-note id="one" position="-8 4 3" label="First"><p>Text of the <a href="#x">first</a></p></volume-note>
  <volume-note id="two" position="9 2 -4" label="Second"><p>Text of the second</p></volume-note>
  <volume-note id="three" position="0 -6 8"><p>Text of the third</p></volume-note>`;

const note = (page: Page, name: string): Locator => page.getByRole('button', { name, exact: true });

/** Resolves when the camera has rested, and the notes know how well they are seen. */
async function rest(page: Page): Promise<void> {
  await settle(page);
  await expect
    .poll(() =>
      page.evaluate(() => [...document.querySelectorAll('volume-note')].every((one) => one.transmittance !== null)),
    )
    .toBe(true);
}

/** The middle of the n-th pin, in pixels of the view. */
const middleOfPin = (page: Page, n = 0): Promise<[number, number]> =>
  page.evaluate((n) => {
    const host = document.querySelector('volume-view')!;
    const [pin, box] = [host.shadowRoot!.querySelectorAll('.pin')[n], host].map((one) => one.getBoundingClientRect());
    return [pin.x + pin.width / 2 - box.x, pin.y + pin.height / 2 - box.y];
  }, n);

test.use(fewPixels);

test.describe('notes', () => {
  test('are buttons in the order of the page, and open with a click, a tap elsewhere, Enter and Escape', async ({
    page,
  }) => {
    await open(page, `${view(three)}<p id="elsewhere">Elsewhere</p>`);
    await rest(page);
    await expect(page.getByRole('group', { name: 'Notes' })).toMatchAriaSnapshot(`
      - group "Notes":
        - button "First"
        - button "Second"
        - button "Note 3"
    `);
    await page.evaluate(() => {
      const seen: unknown[] = ((window as unknown as { toggles: unknown[] }).toggles = []);
      document.addEventListener('note-toggle', (event) =>
        seen.push([(event.target as Element).id, (event as CustomEvent).detail]),
      );
    });
    await note(page, 'First').click();
    await expect(page.getByText('Text of the first')).toBeVisible();
    await expect(note(page, 'First')).toHaveAttribute('aria-expanded', 'true');
    await expect(page.locator('#one')).toHaveAttribute('open', '');
    await page.locator('#elsewhere').click();
    await expect(page.getByText('Text of the first')).toBeHidden();
    await note(page, 'Second').focus();
    await page.keyboard.press('Enter');
    await expect(page.getByText('Text of the second')).toBeVisible();
    await expect(page.getByRole('group', { name: 'Second' })).toMatchAriaSnapshot(`
      - group "Second":
        - paragraph: Text of the second
    `);
    await page.keyboard.press('Escape');
    await expect(page.getByText('Text of the second')).toBeHidden();
    await expect(note(page, 'Second')).toBeFocused();
    expect(await page.evaluate(() => (window as unknown as { toggles: unknown[] }).toggles)).toEqual([
      ['one', true],
      ['one', false],
      ['two', true],
      ['two', false],
    ]);
  });

  test('have no faults that axe finds, closed and open', async ({ page }) => {
    await open(page, `<main><h1>A volume</h1>${view(three)}</main>`);
    await rest(page);
    expect(await findFaults(page)).toEqual([]);
    await note(page, 'First').click();
    expect(await findFaults(page)).toEqual([]);
  });

  test('let Tab go from a note into its open text, and Escape back', async ({ page }) => {
    await open(page, view(three));
    await rest(page);
    await note(page, 'First').focus();
    await page.keyboard.press('Enter');
    await page.keyboard.press('Tab');
    await page.keyboard.press('Tab');
    await expect(page.getByRole('link', { name: 'first' })).toBeFocused();
    await page.keyboard.press('Escape');
    await expect(note(page, 'First')).toBeFocused();
  });

  test('stay open while the picture is turned', async ({ page }) => {
    await open(page, view(three));
    await rest(page);
    await note(page, 'First').click();
    await page.mouse.move(240, 300);
    await page.mouse.down();
    await page.mouse.move(300, 310, { steps: 4 });
    await page.mouse.up();
    await expect(page.getByText('Text of the first')).toBeVisible();
    await page.mouse.click(240, 340);
    await expect(page.getByText('Text of the first')).toBeHidden();
  });

  test('may stand in paragraphs, as editors of pages write them', async ({ page }) => {
    await open(page, view(`<p><span>${three.replaceAll(/<\/?p>/g, '')}</span></p>`));
    await rest(page);
    await note(page, 'Second').click();
    await expect(page.getByRole('group', { name: 'Second' })).toContainText('Text of the second');
    await expect(page.getByRole('group', { name: 'Second' })).toBeVisible();
  });

  test('follow the camera: the pin is where a pick of the picture finds the place, within a pixel', async ({
    page,
  }) => {
    await open(
      page,
      view('<volume-note position="0 0 0" label="There"><p>x</p></volume-note>', {
        'transfer-function': '0.3 #fff 0, 0.3 #fff 90%',
      }),
    );
    await settle(page);
    for (const [x, y] of [
      [240, 180],
      [200, 150],
      [262, 199],
    ]) {
      const world = await withElement(page, async (element, at) => (await element.pick(at[0], at[1]))?.world ?? null, {
        argument: [x, y],
      });
      expect(world).not.toBeNull();
      await page.evaluate(
        (at) => (document.querySelector('volume-note')!.position = at as [number, number, number]),
        world,
      );
      await expect
        .poll(async () => Math.hypot((await middleOfPin(page))[0] - x, (await middleOfPin(page))[1] - y))
        .toBeLessThan(1);
    }
  });

  test('say when other parts hide them: they step back, and keys still reach them', async ({ page }) => {
    const solid = { 'transfer-function': '0 #fff 0.99, 1 #fff 0.99' };
    await open(page, view('<volume-note position="0 0 0" label="Inside"><p>x</p></volume-note>', solid));
    await rest(page);
    const inside = note(page, 'Inside');
    await expect(inside).toHaveAccessibleDescription('Behind other parts');
    await expect(inside).toHaveCSS('opacity', '0');
    await page.evaluate(() => document.querySelector('volume-view')!.focus());
    await page.keyboard.press('Tab');
    await expect(inside).toBeFocused();
    await expect(inside).toHaveCSS('opacity', '1');
    await page.evaluate(() => document.querySelector('volume-note')!.setAttribute('hide', 'never'));
    await page.locator('volume-note').evaluate(() => (document.activeElement as HTMLElement).blur());
    await expect(inside).toHaveCSS('opacity', '0.6');
    // Clear again: nothing is in front of it.
    await page.evaluate(() =>
      document.querySelector('volume-view')!.setAttribute('transfer-function', '0 #fff 0, 1 #fff 0.1%'),
    );
    await expect(inside).toHaveAccessibleDescription('');
  });

  test('are looked at while the camera moves and never rests', async ({ page }) => {
    const solid = { 'transfer-function': '0 #fff 0.99, 1 #fff 0.99', 'camera-orbit': '0deg 90deg 90' };
    await open(page, view('<volume-note position="0 -40 0" label="Outer"><p>x</p></volume-note>', solid));
    await rest(page);
    const transmittance = (): Promise<number> =>
      page.evaluate(() => document.querySelector('volume-note')!.transmittance ?? NaN);
    const first = await transmittance();
    // The picture moves a little all the time, so that the camera never rests for long, as when it turns by itself.
    const stop = await page.evaluateHandle(() => {
      const host = document.querySelector('volume-view')! as unknown as Record<symbol, unknown>;
      const socket = host[Symbol.for('volume-view.socket')] as {
        place(view: object): void;
        view: { viewer: { scene: { getView(): { view: number[]; projection: number[] } } } };
      };
      let n = 0;
      return setInterval(() => {
        const { view, projection } = socket.view.viewer.scene.getView();
        const moved = [...projection];
        moved[8] += ++n % 2 ? 0.01 : -0.01;
        socket.place({ view, projection: moved });
      }, 20);
    });
    await page.evaluate(() => document.querySelector('volume-view')!.setAttribute('camera-orbit', '180deg 90deg 90'));
    await expect.poll(async () => Math.abs((await transmittance()) - first)).toBeGreaterThan(0.5);
    await stop.evaluate((timer) => clearInterval(timer as unknown as number));
  });

  ownPage('are looked at when the first picture takes longer than a camera rests', async ({ page }) => {
    await open(page, '<p>Nothing yet</p>');
    await page.evaluate(() => {
      const { clientWaitSync } = WebGL2RenderingContext.prototype;
      const since = new WeakMap<WebGLSync, number>();
      // As a slow GPU: each picture takes half a second.
      WebGL2RenderingContext.prototype.clientWaitSync = function (sync, ...more) {
        if (!since.has(sync)) since.set(sync, performance.now());
        return performance.now() - since.get(sync)! < 500
          ? this.TIMEOUT_EXPIRED
          : clientWaitSync.call(this, sync, ...more);
      };
    });
    await page.evaluate((html) => (document.body.innerHTML = html), view(three));
    await rest(page);
    expect(await page.evaluate(() => document.querySelector('volume-note')!.transmittance)).toBeGreaterThan(0);
  });

  test('measure what the picture shows: the opacity where the volume is cut behind the place', async ({ page }) => {
    // Seen along y from the front; the region ends at the height of the note.
    const attributes = { 'camera-orbit': '0deg 90deg 90', 'transfer-function': '0 #fff 1%, 1 #fff 4%', steps: 'auto' };
    await open(page, view('<volume-note position="1 -2 1" label="There"><p>x</p></volume-note>', attributes));
    await rest(page);
    const transmittance = await page.evaluate(() => document.querySelector('volume-note')!.transmittance!);
    expect(transmittance).toBeGreaterThan(0.2);
    expect(transmittance).toBeLessThan(0.9);
    const [x, y] = await middleOfPin(page);
    await page.evaluate(() =>
      document.querySelector('volume-view')!.setAttribute('region', '-500 -2 -500 500 500 500'),
    );
    await settle(page);
    const { data, width } = await takePicture(page, { width: 480, height: 360 });
    const alpha = data[4 * (Math.floor(y) * width + Math.floor(x)) + 3] / 255;
    expect(Math.abs(1 - alpha - transmittance)).toBeLessThan(0.006);
  });

  test('show errors of their attributes in words, once, and none when mended', async ({ page }) => {
    await open(page, view('<volume-note position="1 2" label="Wrong"></volume-note>'));
    await expect(page.locator('volume-view [part=error]')).toContainText(
      'position of <volume-note> got "1 2"; expected 3 numbers',
    );
    await page.evaluate(() => document.querySelector('volume-note')!.setAttribute('position', '1 2 3'));
    await expect(page.locator('volume-view [part=error]')).toHaveCount(0);
    await page.evaluate(() => document.querySelector('volume-note')!.setAttribute('hide', 'always'));
    await expect(page.locator('volume-view [part=error]')).toContainText('hide of <volume-note> got "always"');
    await page.evaluate(() => document.querySelector('volume-note')!.remove());
    await expect(page.locator('volume-view [part=error]')).toHaveCount(0);
    await page.evaluate(
      () => (document.querySelector('volume-view')!.innerHTML = '<volume-note of="3" label="Label"></volume-note>'),
    );
    await expect(page.locator('volume-view [part=error]')).toContainText('add <volume-labels> to the <volume-view>');
  });

  test('never read HTML from attributes', async ({ page }) => {
    const hostile = '&lt;img src=x onerror=&quot;window.hacked=1&quot;&gt;';
    await open(page, view(`<volume-note position="0 0 0" hide="never" label="${hostile}"><p>x</p></volume-note>`));
    await rest(page);
    await expect(page.getByRole('button', { name: '<img src=x' })).toBeVisible();
    expect(
      await page.evaluate(
        () => document.querySelector('volume-view')!.shadowRoot!.querySelectorAll('.notes img').length,
      ),
    ).toBe(0);
  });

  test('leave nothing when they go, and come back', async ({ page }) => {
    await open(page, view(three));
    await rest(page);
    await note(page, 'First').click();
    const left = await page.evaluate(async () => {
      const host = document.querySelector('volume-view')!;
      const notes = [...host.querySelectorAll('volume-note')];
      const slotted = notes.every((one) => one.slot.startsWith('volume-note-'));
      for (const one of notes) one.remove();
      await new Promise((resolve) => setTimeout(resolve, 300));
      const there = host.shadowRoot!.querySelectorAll('.notes, .note, .pin').length;
      const result = { slotted, there, slots: notes.map((one) => one.getAttribute('slot')) };
      host.append(...notes);
      return result;
    });
    expect(left).toEqual({ slotted: true, there: 0, slots: [null, null, null] });
    await expect(note(page, 'Second')).toBeVisible();
    await expect(page.getByText('Text of the first')).toBeVisible();
  });

  test('outlive a lost context', async ({ page }) => {
    await open(page, view(three));
    await rest(page);
    await forgetEvents(page);
    await page.evaluate(() => {
      const canvas = document.querySelector('volume-view')!.shadowRoot!.querySelector('canvas')!;
      const gl = (canvas.getContext('webgl2') ?? canvas.getContext('webgl')) as WebGLRenderingContext;
      gl.getExtension('WEBGL_lose_context')!.loseContext();
    });
    await waitForEvent(page, 'render');
    await settle(page);
    await note(page, 'Second').click();
    await expect(page.getByText('Text of the second')).toBeVisible();
    await page.evaluate(() => document.querySelector('volume-view')!.setAttribute('camera-orbit', '80deg 65deg 90'));
    await rest(page);
    await expect(page.locator('volume-view .pin')).toHaveCount(3);
  });

  test('in the text of a page, and their places, show each other', async ({ page }) => {
    await open(
      page,
      `${view('', {}, 'id="seen"')}<volume-note for="seen" hide="never" position="0 0 0" label="Middle"><p>A text of the page</p></volume-note>`,
    );
    await rest(page);
    const number = page.getByRole('button', { name: '1 Show in the picture: Middle' });
    await expect(page.getByText('A text of the page')).toBeVisible();
    await expect(number).toHaveText('1');
    await page.getByText('A text of the page').hover();
    await expect(page.locator('volume-view .pin')).toHaveClass(/active/);
    await page.mouse.move(400, 5);
    await expect(page.locator('volume-view .pin')).not.toHaveClass(/active/);
    await number.focus();
    await expect(page.locator('volume-view .pin')).toHaveClass(/active/);
    await page.locator('volume-view').evaluate((element: HTMLElement) => element.focus());
    await expect(page.locator('volume-view .pin')).not.toHaveClass(/active/);
    const background = (): Promise<string> =>
      page.locator('volume-note').evaluate((one) => getComputedStyle(one).backgroundColor);
    expect(await background()).toBe('rgba(0, 0, 0, 0)');
    await note(page, 'Middle').focus();
    await expect.poll(background).not.toBe('rgba(0, 0, 0, 0)');
  });

  test('are numbers and texts below the picture on paper', async ({ page }) => {
    await open(page, `${view(three)}<p id="after">After</p>`);
    await rest(page);
    await page.emulateMedia({ media: 'print' });
    await expect(page.getByText('Text of the second')).toBeVisible();
    const boxes = await page.evaluate(() => {
      const host = document.querySelector('volume-view')!;
      const rect = (one: Element): { top: number; bottom: number } => one.getBoundingClientRect();
      return {
        picture: rect(host.shadowRoot!.querySelector('.picture')!).bottom,
        first: rect(document.querySelector('#one p')!).top,
        third: rect(document.querySelector('#three p')!).top,
        after: rect(document.querySelector('#after')!).top,
      };
    });
    expect(boxes.first).toBeGreaterThan(boxes.picture);
    expect(boxes.third).toBeGreaterThan(boxes.first);
    expect(boxes.after).toBeGreaterThan(boxes.third);
    await page.emulateMedia({ media: null });
  });

  test('are at most 1,000', async ({ page }) => {
    await open(page, view(''));
    await settle(page);
    await page.evaluate(() => {
      const host = document.querySelector('volume-view')!;
      const all = Array.from({ length: 1001 }, (_, i) => {
        const one = document.createElement('volume-note');
        one.setAttribute('position', `${i % 20} ${i % 17} ${i % 13}`);
        return one;
      });
      host.append(...all);
    });
    await expect(page.locator('volume-view [part=error]')).toContainText('got more than 1000 notes');
    await expect.poll(() => page.locator('volume-view .pin').count()).toBe(1000);
  });

  test('cover no pin in a narrow view, and are not seen before the first picture', async ({ page }) => {
    const sides = [
      [-9, 0, 6],
      [-9, 0, -3],
      [9, 0, 5],
      [9, 0, -6],
      [0, 0, 0],
    ].map((at, i) => `<volume-note hide="never" position="${at.join(' ')}" label="A long name ${i}"></volume-note>`);
    await open(
      page,
      view(sides.join('')).replace(`src="${fieldUrl}"`, '').replace(size, 'style="width: 300px; height: 220px"'),
    );
    await expect(note(page, 'A long name 0')).toHaveCSS('opacity', '0');
    await page.evaluate((url) => document.querySelector('volume-view')!.setAttribute('src', url), fieldUrl);
    await rest(page);
    const look = (): Promise<object> =>
      page.evaluate(() => {
        const boxes = (name: string): DOMRect[] =>
          [...document.querySelector('volume-view')!.shadowRoot!.querySelectorAll(name)].map((one) =>
            one.getBoundingClientRect(),
          );
        const [pins, texts] = [boxes('.pin'), boxes('.note')];
        const touch = (a: DOMRect, b: DOMRect): boolean =>
          a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
        return { covered: texts.filter((text) => pins.some((pin) => touch(text, pin))).length, pins: pins.length };
      });
    // Texts glide to their places when the camera has come to rest.
    await expect.poll(look).toEqual({ covered: 0, pins: 5 });
  });

  test('are numbers where there is no room for all names; a screen reader gets number and name', async ({ page }) => {
    const many = Array.from(
      { length: 40 },
      (_, i) =>
        `<volume-note hide="never" position="${(i % 7) - 3} ${(i % 5) - 2} ${(i % 9) - 4}" label="Place ${i}"></volume-note>`,
    );
    await open(page, view(many.join('')));
    await rest(page);
    await expect(page.locator('volume-view .notes')).toHaveClass(/short/);
    const seventh = page.getByRole('button', { name: '7 Place 6', exact: true });
    expect((await seventh.boundingBox())!.width).toBeLessThan(30);
    await seventh.focus();
    await page.keyboard.press('Tab');
    await page.keyboard.press('Shift+Tab');
    expect((await seventh.boundingBox())!.width).toBeGreaterThan(50);
  });
});

const inPanes = (notes: string, more = ''): string =>
  `<main><h1>A volume</h1>${view(notes, {}, 'id="seen"')}
  <volume-slice-view id="axial" for="seen" thickness="3" style="width: 300px" ${more}></volume-slice-view>
  <volume-slice-view id="oblique" for="seen" type="oblique" normal="1 2 0.5" thickness="3" style="width: 300px"></volume-slice-view></main>`;

const inPane = `<volume-note id="one" position="-4 3 2" label="First"><p>Text of the first</p></volume-note>
  <volume-note id="two" position="5 1 2.5" label="Second"><p>Text of the second</p></volume-note>
  <volume-note id="far" position="1 1 -9" label="Far away"><p>x</p></volume-note>`;

/** How far the pin of a note is from the crosshair of a pane, CSS pixels of the screen. */
const missOf = (page: Page, pane: string, name: string): Promise<number> =>
  page.locator(pane).evaluate((host, name) => {
    const root = host.shadowRoot!;
    const pin = [...root.querySelectorAll<HTMLElement>('.pin')].find((one) => one.ariaLabel === name && !one.hidden);
    if (!pin) return Infinity;
    const [at, across, up] = [pin, root.querySelector('.across')!, root.querySelector('.up')!].map((one) =>
      one.getBoundingClientRect(),
    );
    return Math.hypot(up.x + (up.width - at.width) / 2 - at.x, across.y + (across.height - at.height) / 2 - at.y);
  }, name);

test.describe('notes in panes of slices', () => {
  test('are where the crosshair is when it is at their place, within a pixel, also in a page with zoom', async ({
    page,
  }) => {
    await open(page, inPanes(inPane, 'cursor="-4 3 2"'));
    await rest(page);
    for (const zoom of ['1', '2', '0.75']) {
      await page.evaluate((zoom) => (document.body.style.zoom = zoom), zoom);
      for (const pane of ['#axial', '#oblique'])
        await expect.poll(() => missOf(page, pane, 'First'), `${pane} at ${zoom}`).toBeLessThan(Number(zoom));
    }
    await page.evaluate(() => (document.body.style.zoom = ''));
  });

  test('open there, in one place, and the view shows which note it is', async ({ page }) => {
    await open(page, inPanes(inPane, 'cursor="-4 3 2"'));
    await rest(page);
    const axial = page.locator('#axial');
    // Those in the slice are buttons; others are not: they are in the view.
    await expect(axial.getByRole('group', { name: 'Notes' })).toMatchAriaSnapshot(`
      - group "Notes":
        - button "First"
        - button "Second"
    `);
    await expect(axial.getByRole('button', { name: 'Far away' })).toHaveCount(0);
    await axial.getByRole('button', { name: 'Second' }).click();
    await expect(axial.getByText('Text of the second')).toBeVisible();
    await expect(page.locator('#two')).toHaveAttribute('open', '');
    await expect(page.locator('#oblique').getByText('Text of the second')).toHaveCount(0);
    await expect(page.locator('#two p')).toBeHidden();
    await expect(page.locator('#seen .note.active')).toHaveText(/Second/);
    expect(await findFaults(page)).toEqual([]);
    await page.keyboard.press('Escape');
    await expect(axial.getByText('Text of the second')).toHaveCount(0);
    await expect(page.locator('#two')).not.toHaveAttribute('open');
    await axial.getByRole('button', { name: 'First' }).focus();
    await page.keyboard.press('Enter');
    await expect(axial.getByText('Text of the first')).toBeVisible();
    await page.locator('h1').click();
    await expect(axial.getByText('Text of the first')).toHaveCount(0);
    // The view's own button opens the text over the view's picture.
    await page.locator('#seen').getByRole('button', { name: 'First' }).click();
    await expect(page.locator('#one p')).toBeVisible();
    await expect(axial.getByText('Text of the first')).toHaveCount(0);
  });

  test('follow the slice, and go with the notes', async ({ page }) => {
    await open(page, inPanes(inPane, 'cursor="-4 3 2"'));
    await rest(page);
    const first = page.locator('#axial').getByRole('button', { name: 'First' });
    await expect(first).toBeVisible();
    await first.focus();
    await page.locator('#axial').evaluate((pane) => pane.setAttribute('cursor', '0 0 -9'));
    await expect(first).toHaveCount(0);
    await expect(page.locator('#axial').getByRole('button', { name: 'Far away' })).toBeVisible();
    // What had the focus has left the slice: the picture has it now.
    await expect(page.locator('#axial [part=picture]')).toBeFocused();
    await page.evaluate(() => {
      for (const one of document.querySelectorAll('volume-note')) one.remove();
    });
    await expect(page.locator('#axial .notes')).toHaveCount(0);
    await expect(page.locator('#oblique .notes')).toHaveCount(0);
  });
});
