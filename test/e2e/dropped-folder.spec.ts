// A folder of the disk that is dropped on a picture, as the browser gives it: not made by a script.
import { mkdirSync, rmSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import type { Page } from '@playwright/test';
import { ctSlice, dicomBytes } from '../helpers/dicom-bytes.ts';
import type { DicomFields } from '../helpers/dicom-bytes.ts';
import { expect, fieldUrl, open, settle, test, withElement } from './helpers/harness.ts';

const secret = /geheim/i;

/** Writes files below a folder of the test; @returns the folder that a person would drop. */
function writeFolder(files: Readonly<Record<string, Uint8Array>>): string {
  const folder = test.info().outputPath('Geheim-study');
  rmSync(folder, { recursive: true, force: true });
  for (const [path, bytes] of Object.entries(files)) {
    const file = join(folder, path);
    mkdirSync(dirname(file), { recursive: true });
    writeFileSync(file, bytes);
  }
  return folder;
}

/** Series in subfolders, the files of each called as scanners do. */
function writeSeries(folder: string, count: number, fields: DicomFields): Record<string, Uint8Array> {
  return Object.fromEntries(
    Array.from({ length: count }, (_, k) => [
      `${folder}/Geheim/IM${String(k).padStart(4, '0')}`,
      dicomBytes(ctSlice(5 * k, fields, 100 + 20 * k)),
    ]),
  );
}

/** Drags a path of the disk over an element, and drops it there, by the browser's own events. */
async function dropPath(page: Page, path: string, selector = '#v'): Promise<void> {
  const box = (await page.locator(selector).boundingBox())!;
  const session = await page.context().newCDPSession(page);
  const place = { x: box.x + box.width / 2, y: box.y + box.height / 2 };
  const data = { items: [], files: [path], dragOperationsMask: 1 };
  for (const type of ['dragEnter', 'dragOver', 'drop'] as const)
    await session.send('Input.dispatchDragEvent', { type, ...place, data });
}

const tags = `<main><volume-view id="v" src="${fieldUrl}" alt="A scan"></volume-view><volume-drop for="v"></volume-drop></main>`;

async function openPage(page: Page): Promise<string[]> {
  const said: string[] = [];
  page.on('console', (message) => said.push(message.text()));
  await open(page, tags);
  await page.waitForFunction(() => customElements.get('volume-drop') !== undefined);
  await settle(page, '#v');
  await page.evaluate(() => {
    const events: string[] = [];
    Object.assign(window, { events });
    const view = document.querySelector('volume-view')!;
    for (const type of ['load', 'progress', 'error'])
      view.addEventListener(type, (event) => {
        const { detail } = event as CustomEvent;
        events.push(`${type} ${JSON.stringify(detail)} ${detail?.message ?? ''}`);
      });
  });
  return said;
}

const status = (page: Page) => page.locator('volume-drop [part=status]');

test('two series in subfolders of a dropped folder are listed, and their paths are nowhere', async ({ page }) => {
  const said = await openPage(page);
  const folder = writeFolder({
    ...writeSeries('A', 4, { SeriesNumber: '2', SeriesInstanceUID: '1.2.1' }),
    ...writeSeries('B/deeper', 3, { SeriesNumber: '5', SeriesInstanceUID: '1.2.2', Modality: 'MR' }),
    DICOMDIR: dicomBytes({ SOPClassUID: '1.2.840.10008.1.3.10' }),
    'Geheim.txt': new TextEncoder().encode('Dear Sir'),
  });
  await dropPath(page, folder);
  await expect(status(page)).toHaveText('DICOM, CT, 4 × 3 × 4 voxels. Files: 9.');
  await expect(page.getByRole('radio')).toHaveCount(2);
  await page.getByRole('radio', { name: 'MR · Series 5' }).check();
  await expect(status(page)).toHaveText('DICOM, MR, 4 × 3 × 3 voxels. Files: 9.');
  const seen = await page.evaluate(() => {
    const texts: string[] = [document.title, ...(window as unknown as { events: string[] }).events];
    const visit = (root: Document | ShadowRoot): void => {
      texts.push(root instanceof Document ? root.documentElement.outerHTML : root.innerHTML);
      for (const one of root.querySelectorAll('*')) if (one.shadowRoot) visit(one.shadowRoot);
    };
    visit(document);
    const { volume } = document.querySelector('volume-view')!;
    texts.push(JSON.stringify({ ...volume, samples: undefined }));
    return texts;
  });
  expect([...seen, ...said].filter((text) => secret.test(text))).toEqual([]);
});

test('a header in a dropped folder finds its data in a folder inside', async ({ page }) => {
  await openPage(page);
  const header = (file: string): Uint8Array =>
    new TextEncoder().encode(
      `ObjectType = Image\nNDims = 3\nDimSize = 2 2 2\nElementType = MET_UCHAR\nElementDataFile = ${file}\n`,
    );
  const folder = writeFolder({
    'Geheim.mhd': header('data/Geheim.raw'),
    'data/Geheim.raw': Uint8Array.from([0, 1, 2, 3, 4, 5, 6, 7]),
    'old/Geheim.raw': new Uint8Array(8),
  });
  await dropPath(page, folder);
  await expect(status(page)).toContainText('2 × 2 × 2 voxels');
  expect(await withElement(page, (view) => view.volume!.range)).toEqual([0, 7]);
});

test('a damaged file of a dropped folder is no data, and its number is said', async ({ page }) => {
  await openPage(page);
  const files = writeSeries('A', 5, { SeriesInstanceUID: '1.2.1' });
  const last = 'A/Geheim/IM0004';
  const folder = writeFolder({ ...files, [last]: files[last].slice(0, -6) });
  await dropPath(page, folder);
  await expect(status(page)).toContainText('4 × 3 × 5 voxels. Files: 5.');
  const left = await withElement(page, (view) => view.volume!.left!);
  expect(left[0]).toMatch(/^file 5 of 5: damaged, and its place shown as no data/);
  expect(left.join(' ')).not.toMatch(secret);
});
