// The author's own X3D in the element.
import type { Page } from '@playwright/test';
import { countGreen, plain, shape } from './helpers/green-shape.ts';
import { compare, expect, open, seenEvents, takePicture, keptTest as test, waitForEvent } from './helpers/harness.ts';
import { meanOf } from './helpers/pictures.ts';
import type { Picture } from './helpers/pictures.ts';

async function change(page: Page, act: (element: Element, text: string) => void, text = ''): Promise<Picture> {
  const since = (await seenEvents(page)).length;
  await page.locator('volume-view').evaluate(act, text);
  await waitForEvent(page, 'render', { since });
  return takePicture(page);
}

test.describe("the author's X3D", () => {
  test('is in the picture, within and before and behind the volume', async ({ page }) => {
    await open(page, plain.replace('></volume-view>', `>${shape('0 1 0')}</volume-view>`));
    const picture = await takePicture(page);
    // It sticks out at both ends of the volume (32 high), and is veiled by it in between.
    expect(countGreen(picture)).toBeGreaterThan(40);
    const [red, green, blue, alpha] = [0, 1, 2, 3].map((c) => picture.data[(45 * 120 + 60) * 4 + c]);
    expect(alpha).toBe(255);
    expect(green).toBeLessThan(250);
    expect(red + blue).toBeGreaterThan(10);
  });

  test('may be added, changed and removed at run time', async ({ page }) => {
    await open(page, plain);
    const bare = await takePicture(page);
    expect(countGreen(bare)).toBe(0);
    await page.evaluate((html) => {
      const template = document.createElement('template');
      template.innerHTML = html;
      document.querySelector('volume-view')!.append(template.content);
    }, shape('0 1 0'));
    await waitForEvent(page, 'render', { since: (await seenEvents(page)).length - 1 });
    await expect.poll(async () => countGreen(await takePicture(page))).toBeGreaterThan(40);
    const green = await takePicture(page);
    const blue = await change(page, (element) =>
      element.querySelector('#paint')!.setAttribute('emissivecolor', '0 0 1'),
    );
    expect(countGreen(blue)).toBe(0);
    expect(compare(blue, green).worst).toBeGreaterThan(200);
    const moved = await change(page, (element) =>
      element.querySelector('#place')!.setAttribute('translation', '12 0 0'),
    );
    expect(compare(moved, blue).worst).toBeGreaterThan(200);
    const removed = await change(page, (element) => element.querySelector('#place')!.remove());
    expect(compare(removed, bare).worst).toBe(0);
  });

  test('may be a light', async ({ page }) => {
    const lit =
      '<shape><appearance><material diffusecolor="0.3 0.3 0.3" ambientintensity="0"></material></appearance><box size="8 40 8"></box></shape>';
    await open(page, plain.replace('></volume-view>', `>${lit}</volume-view>`));
    const before = meanOf(await takePicture(page));
    await page.evaluate(() => {
      const light = document.createElement('directionallight');
      light.setAttribute('color', '0 0 1');
      light.setAttribute('direction', '0 -1 0');
      document.querySelector('volume-view')!.prepend(light);
    });
    await expect.poll(async () => meanOf(await takePicture(page))[2]).toBeGreaterThan(before[2] + 0.5);
    const after = meanOf(await takePicture(page));
    expect(Math.abs(after[0] - before[0])).toBeLessThan(0.1);
  });

  test.describe('that has a light without direction', () => {
    test.use({ allowedLines: /light> .*was left out of the picture: direction got/ });

    test('is drawn without that light, which the console says', async ({ page, lines }) => {
      const box =
        '<shape><appearance><material diffusecolor="0.3 0.3 0.3"></material></appearance><box size="8 40 8"></box></shape>';
      const lamp = (direction: string, kind = 'directional'): string =>
        `<${kind}light id="lamp" direction="${direction}" color="1 0 0"></${kind}light>`;
      const put = (light: string): Promise<Picture> =>
        change(page, (element, html) => (element.innerHTML = html), `<group>${light}${box}</group>`);
      const turn = (direction: string): Promise<Picture> =>
        change(page, (element, text) => element.querySelector('#lamp')!.setAttribute('direction', text), direction);
      const reported = (direction: string, kind = 'directional'): string =>
        `warning: <volume-view>: <${kind}light> (id "lamp") was left out of the picture: direction got "${direction}"; expected three numbers, not all of them 0, like "0 -1 0".`;
      const said = (): string[] => lines.splice(0).filter((line) => line.includes('left out'));
      await open(page, plain.replace('></volume-view>', ` shading="lit"><group>${box}</group></volume-view>`));
      const without = await takePicture(page);
      const shining = await put(lamp('1 0 0'));
      expect(compare(shining, without).worst, 'the light shines').toBeGreaterThan(20);
      expect(said()).toEqual([]);
      expect(compare(await put(lamp('0 0 0')), without).worst).toBe(0);
      expect(said()).toEqual([reported('0 0 0')]);
      expect(compare(await turn('1 0 0'), shining).worst, 'put right').toBe(0);
      expect(compare(await turn('left'), without).worst).toBe(0);
      expect(said()).toEqual([reported('left')]);
      expect(compare(await put(lamp('0', 'spot')), without).worst).toBe(0);
      expect(said()).toEqual([reported('0', 'spot')]);
    });
  });
});
