// view.getView(), links into a view, and `link-state`
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Page } from '@playwright/test';
import { projectRoot } from '../../scripts/shared-data.mjs';
import { attributesOf } from './helpers/reference.ts';
import {
  compare,
  expect,
  fieldUrl,
  open,
  setAttributes,
  settle,
  takePicture,
  test,
  withElement,
} from './helpers/harness.ts';
import { look, serve, urls } from './helpers/scans.ts';

const view = (more = ''): string =>
  `<volume-view id="heart" src="${fieldUrl}" ${attributesOf()} alt="A field" link-state ${more}></volume-view>`;
const getView = (page: Page): Promise<Record<string, string>> => withElement(page, (element) => element.getView());
const attributesNow = (page: Page): Promise<Record<string, string>> =>
  withElement(page, (element) =>
    Object.fromEntries([...element.attributes].map(({ name, value }) => [name, value] as const)),
  );
const go = async (page: Page, hash: string): Promise<void> => {
  await page.evaluate((to) => void (location.hash = to), hash);
};

/** Open the page again, at this hash, as somebody who follows a link does. */
async function follow(page: Page, hash: string): Promise<void> {
  const address = page.url().replace(/#.*/, '');
  await page.goto('about:blank');
  await page.goto(address + hash);
  await settle(page);
}

test('a fresh tag with what differs gives the same picture, and the same difference', async ({ page }) => {
  await open(page, view());
  expect(await getView(page), 'before the first picture').toEqual({});
  await settle(page);
  expect(await getView(page), 'nothing has changed').toEqual({});
  await setAttributes(page, { region: '-500 -2 -500 500 500 500', projection: 'max' });
  await page.locator('.picture').press('ArrowRight');
  await page.locator('.picture').press('Shift+ArrowUp');
  await settle(page);
  const seen = await takePicture(page);
  const changed = await getView(page);
  expect(new Set(Object.keys(changed))).toEqual(new Set(['camera-orbit', 'camera-target', 'projection', 'region']));
  await open(page, view());
  await settle(page);
  expect(compare(await takePicture(page), seen).worst).toBeGreaterThan(20);
  await setAttributes(page, changed);
  expect(compare(await takePicture(page), seen).worst, 'rounded to a thousandth of a degree').toBeLessThanOrEqual(2);
  expect(await getView(page)).toEqual(changed);
});

test('a link shows the view to somebody who follows it, and writes no address by itself', async ({ page }) => {
  await open(page, view());
  await settle(page);
  const address = page.url();
  const length = await page.evaluate(() => history.length);
  await setAttributes(page, { region: '-500 -2 -500 500 500 500' });
  await page.locator('.picture').press('ArrowRight');
  await settle(page);
  const seen = await takePicture(page);
  const link = await withElement(page, (element) => element.getLink());
  expect(link.startsWith(`${address}#heart?`)).toBe(true);
  expect(page.url()).toBe(address);
  expect(await page.evaluate(() => history.length)).toBe(length);
  await follow(page, new URL(link).hash);
  await expect.poll(async () => (await attributesNow(page)).region).toBe('-500 -2 -500 500 500 500');
  expect(compare(await takePicture(page), seen).worst).toBeLessThanOrEqual(2);
  expect(await withElement(page, (element) => element.getLink())).toBe(link);

  // Another link: what it does not name is as in the tag.
  await go(page, 'heart?projection=max');
  await expect.poll(() => attributesNow(page)).toMatchObject({ projection: 'max', 'camera-orbit': '35deg 65deg 90' });
  expect(await attributesNow(page)).not.toHaveProperty('region');
  await page.goBack();
  await expect.poll(async () => (await attributesNow(page)).region).toBe('-500 -2 -500 500 500 500');
  expect(await attributesNow(page)).not.toHaveProperty('projection');
});

test.describe('a link with something wrong', () => {
  test('is reported as the error of the attribute, and the value of the tag stays', async ({ page }) => {
    await open(page, view('region="-500 -2 -500 500 500 500"'));
    await settle(page);
    const tag = await attributesNow(page);
    const seen = await takePicture(page);
    await page.evaluate(() => {
      const errors: string[] = ((window as unknown as { errors: string[] }).errors = []);
      document.querySelector('volume-view')!.addEventListener('error', ({ detail }) => errors.push(detail.message));
    });
    const errors = (): Promise<string[]> => page.evaluate(() => (window as unknown as { errors: string[] }).errors);
    await go(page, 'heart?region=1%202&transfer-function=javascript:alert(1)&light-factor=2');
    await expect.poll(async () => (await errors()).length).toBe(2);
    expect((await errors()).map((one) => one.split(/[ :]/)[0])).toEqual(['region', 'transfer-function']);
    expect(await attributesNow(page)).toEqual({ ...tag, 'light-factor': '2' });
    await go(page, 'heart?');
    await expect.poll(() => attributesNow(page)).toEqual(tag);
    expect(compare(await takePicture(page), seen).worst).toBeLessThanOrEqual(1);
  });

  test('from a stranger changes nothing', async ({ page }) => {
    await open(page, view());
    await settle(page);
    const tag = await attributesNow(page);
    const requests: string[] = [];
    page.on('request', (request) => requests.push(request.url()));
    for (const hash of [
      'heart?src=/evil.nii&poster=/evil.png&id=x&style=color:red&onclick=alert(1)&crossorigin=x&alt=x&moment=x',
      'heart?__proto__=x&constructor=x&__proto__[src]=x',
      'heart?look=%E0%A4%A&%=%',
      'heart?x=javascript:alert(1)',
      '%E0%A4%A?look=bone',
      `heart?region=${'1'.repeat(9000)}`,
      'lung?look=skin',
    ]) {
      await go(page, hash);
      await page.waitForTimeout(50);
      expect(await attributesNow(page), hash).toEqual(tag);
    }
    expect(requests.filter((url) => url.includes('evil'))).toEqual([]);
  });
});

test('a link opens the step of a tour, and what differs from it', async ({ page }) => {
  const tour =
    '<volume-tour for="heart"><volume-step><h2>One</h2></volume-step><volume-step camera-orbit="-80deg 90deg 90" projection="max"><h2>Two</h2></volume-step></volume-tour>';
  await open(page, view() + tour);
  await settle(page);
  await page.getByRole('button', { name: 'Next step' }).click();
  await settle(page);
  const link = await withElement(page, (element) => element.getLink());
  expect(new URL(link).hash).toBe('#heart?step=2');
  await page.locator('.picture').press('ArrowRight');
  await settle(page);
  const seen = await takePicture(page);
  const turned = new URL(await withElement(page, (element) => element.getLink())).hash;
  expect(turned).toMatch(/^#heart\?step=2&camera-orbit=-87\.5deg\+90deg\+90$/);
  await follow(page, turned);
  await expect(page.getByRole('heading', { name: 'Two' })).toBeVisible();
  await expect.poll(async () => (await attributesNow(page)).projection).toBe('max');
  await expect.poll(async () => compare(await takePicture(page), seen).worst).toBeLessThanOrEqual(2);
});

test('a link has the scan', async ({ page }) => {
  await serve(page);
  await open(page, `<volume-view id="storm" link-state src="${urls(3).join(' ')}" ${look} alt="Scans"></volume-view>`);
  await settle(page);
  await withElement(page, (element) => element.next());
  await expect.poll(async () => (await getView(page)).time).toBe('1');
  expect(new URL(await withElement(page, (element) => element.getLink())).hash).toBe('#storm?time=1');
  await go(page, 'storm?time=2');
  await expect.poll(async () => withElement(page, (element) => element.scan?.index)).toBe(2);
});

test('a button of the controls copies a link', async ({ page, context }) => {
  await context.grantPermissions(['clipboard-read', 'clipboard-write']);
  await open(page, view('controls style="width: 400px; height: 300px"'));
  await settle(page);
  await page.locator('.picture').press('ArrowRight');
  await settle(page);
  const button = (name: string) => page.locator('volume-view').getByRole('button', { name, exact: true });
  await button('More').click();
  await button('Copy a link').click();
  await expect(page.locator('volume-view').getByText('Copied: a link to this view.')).toBeVisible();
  const text = await page.evaluate(() => navigator.clipboard.readText());
  expect(text).toBe(await withElement(page, (element) => element.getLink()));
  await setAttributes(page, { controlslist: 'nolink' });
  await button('More').click();
  await expect(button('Copy this view')).toBeVisible();
  await expect(button('Copy a link')).toHaveCount(0);
});

test('links work as the guide writes them', async ({ page }) => {
  const guide = readFileSync(join(projectRoot, 'docs/guide/links.md'), 'utf8');
  const [tag, link] = [...guide.matchAll(/^```html\n([^]*?)^```$/gm)].map(([, html]) => html);
  expect(tag).toContain('src="heart.nii.gz"');
  await open(page, `${tag.replace('heart.nii.gz', fieldUrl)}${link}`);
  await settle(page);
  await page.getByRole('link', { name: 'From above' }).click();
  await expect.poll(async () => (await attributesNow(page))['camera-orbit']).toBe('0deg 10deg auto');
  expect((await getView(page))['camera-orbit']).toBe('0deg 10deg auto');
});
