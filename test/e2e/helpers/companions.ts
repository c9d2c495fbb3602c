// The companions' page: a field, an editor and a legend, and what a person does to the editor.
import type { Locator, Page } from '@playwright/test';
import { parseTransferFunction } from '../../../src/optics/transfer/parse-transfer-function.ts';
import { expect, fieldUrl, open, settle, withElement } from './harness.ts';

/** What the page says of the field, whose values go from 0 to 255. */
export const said = '0 blue 0, 100 red 1%, 200 #ffff00 30%';
export const view = `<volume-view id="field" src="${fieldUrl}" transfer-function="${said}" steps="20" alt="A field"></volume-view>`;
export const editor =
  '<volume-transfer-function for="field" style="display: block; width: 400px"></volume-transfer-function>';
export const legend = '<volume-legend for="field" label="Strength"></volume-legend>';

export const handles = (page: Page): Locator => page.getByRole('slider', { name: /^Stop/ });
export const handle = (page: Page, number: number): Locator =>
  page.getByRole('slider', { name: new RegExp(`^Stop ${number} of`) });

interface Reported {
  type: string;
  transferFunction: string;
  bubbles: boolean;
}

/** Open a page with an editor and wait until it shows the volume; what it tells is kept. */
export async function openEditor(page: Page, body = view + editor): Promise<void> {
  await open(page, body);
  await page.evaluate(() => {
    const reported: Reported[] = ((window as unknown as { reported: Reported[] }).reported = []);
    const keep = (event: Event): void => {
      const { type, detail, bubbles } = event as CustomEvent<{ transferFunction: string }>;
      if ((event.target as Element).localName === 'volume-transfer-function')
        reported.push({ type, transferFunction: detail?.transferFunction, bubbles });
    };
    for (const type of ['input', 'change']) document.addEventListener(type, keep, true);
  });
  await expect(page.locator('volume-transfer-function .editor')).toBeVisible();
  await settle(page);
}

export const reported = (page: Page): Promise<Reported[]> =>
  page.evaluate(() => (window as unknown as { reported: Reported[] }).reported);

/** The stops that the volume has. */
export async function readStops(page: Page): Promise<{ value: number; opacity: number; color: readonly number[] }[]> {
  const text = await withElement(page, (element) => element.transferFunction ?? '');
  return [...parseTransferFunction(text, [0, 255])];
}

export async function readValues(page: Page): Promise<number[]> {
  return (await readStops(page)).map(({ value }) => value);
}

export async function middleOf(locator: Locator): Promise<{ x: number; y: number }> {
  const box = (await locator.boundingBox())!;
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
}

export async function drag(page: Page, locator: Locator, by: { x: number; y: number }): Promise<void> {
  const { x, y } = await middleOf(locator);
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (const part of [0.3, 0.7, 1]) await page.mouse.move(x + by.x * part, y + by.y * part);
  await page.mouse.up();
}
