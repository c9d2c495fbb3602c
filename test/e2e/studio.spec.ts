// The studio as a teacher uses it, with pointer and keys: from a folder of DICOM to a lesson in a course.
import { mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import type { Download, Page } from '@playwright/test';
import { unzipSync } from 'fflate';
import { projectRoot } from '../../scripts/shared-data.mjs';
import { dicomHead, dicomSecret } from '../helpers/dicom-head.ts';
import { findFaults } from './helpers/axe.ts';
import { expect, fewPixels, test } from './helpers/harness.ts';

test.use(fewPixels);

const address = '/packages/studio/dist/index.html';

/** Drags a folder of the disk over the drop area, and drops it there, by the browser's own events. */
async function dropFolder(page: Page, files: Readonly<Record<string, Uint8Array>>): Promise<void> {
  const folder = test.info().outputPath(`${dicomSecret}-study`);
  rmSync(folder, { recursive: true, force: true });
  for (const [path, bytes] of Object.entries(files)) {
    mkdirSync(dirname(join(folder, path)), { recursive: true });
    writeFileSync(join(folder, path), bytes);
  }
  const area = page.locator('volume-drop');
  // Its buttons come with the view that takes the files: what is dropped before has no place to go.
  await expect(area.getByRole('button').first()).toBeVisible();
  const box = (await area.boundingBox())!;
  const session = await page.context().newCDPSession(page);
  const place = { x: box.x + box.width / 2, y: box.y + box.height / 2 };
  const data = { items: [], files: [folder], dragOperationsMask: 1 };
  for (const type of ['dragEnter', 'dragOver', 'drop'] as const)
    await session.send('Input.dispatchDragEvent', { type, ...place, data });
}

/** The picture has its volume; that it is refined takes longer, and is not waited for. */
const loaded = (page: Page): Promise<unknown> =>
  page.waitForFunction(() => document.querySelector<HTMLElement & { volume: unknown }>('#picture')?.volume);

const orbitOf = (page: Page): Promise<string | null> =>
  page.evaluate(() => document.querySelector<HTMLElement & { cameraOrbit: string | null }>('#picture')!.cameraOrbit);

/** All that the page's databases hold, as text: bytes as Latin-1. */
const keptTexts = (page: Page): Promise<string> =>
  page.evaluate(async () => {
    const texts: string[] = [];
    const visit = (value: unknown): void => {
      if (value instanceof Uint8Array) texts.push(new TextDecoder('latin1').decode(value));
      else if (typeof value === 'object' && value !== null)
        Object.entries(value).forEach((entry) => entry.forEach(visit));
      else texts.push(String(value));
    };
    const database = await new Promise<IDBDatabase>((resolve, reject) => {
      const request = indexedDB.open('volume-view-studio');
      request.onsuccess = () => resolve(request.result);
      request.onerror = () => reject(request.error);
    });
    for (const name of database.objectStoreNames)
      visit(
        await new Promise((resolve) => {
          const request = database.transaction(name).objectStore(name).getAll();
          request.onsuccess = () => resolve(request.result);
        }),
      );
    database.close();
    return texts.join('\n');
  });

/** A learning management system with the package in a frame. @param files - of the package */
async function play(page: Page, files: Readonly<Record<string, Uint8Array>>): Promise<void> {
  const types: Record<string, string> = { html: 'text/html', js: 'text/javascript', css: 'text/css' };
  const scorm = readFileSync(join(projectRoot, 'node_modules/scorm-again/dist/scorm12.min.js'), 'utf8');
  const lms = `<!doctype html><title>LMS</title><script>${scorm}</script>
<script>window.API = new Scorm12API({ autocommit: false, logLevel: 5 });</script>
<iframe src="package/index.html" style="width: 800px; height: 650px"></iframe>`;
  await page.route('**/course/**', (route) => {
    const path = new URL(route.request().url()).pathname.replace('/course/', '');
    if (path === 'lms.html') return route.fulfill({ body: lms, contentType: 'text/html' });
    const bytes = files[path.replace('package/', '')];
    const contentType = types[path.split('.').at(-1)!] ?? 'application/octet-stream';
    return bytes ? route.fulfill({ body: Buffer.from(bytes), contentType }) : route.fulfill({ status: 404 });
  });
  await page.goto('/course/lms.html');
}

test.use({ viewport: { width: 940, height: 620 } });

test('from a folder of DICOM to a lesson of five steps and two questions, played in a course with a score', async ({
  page,
}) => {
  test.setTimeout(300_000); // Quiet it takes 40 s; beside another test in software GL up to three times that.
  await page.goto(address);
  await expect(page.getByRole('heading', { name: 'Make a lesson from a scan' })).toBeVisible();
  await dropFolder(page, dicomHead());
  await page.getByRole('button', { name: 'Begin the lesson' }).click();
  await loaded(page);
  expect(await findFaults(page)).toEqual([]);

  // Five steps: the focus is in the title of the new one. The camera turns by keys and by the pointer.
  const addStep = async (title: string): Promise<void> => {
    await page.getByRole('button', { name: 'Add a step from this view' }).click();
    await page.keyboard.type(title);
  };
  await addStep('From outside');
  await page.keyboard.press('Tab');
  await page.keyboard.type('The skull is a shell.');
  await page.locator('#picture').getByRole('img').focus();
  for (let i = 0; i < 4; i++) await page.keyboard.press('ArrowRight');
  const isTurned = page.getByText('The picture is not the view of this step any more.');
  await expect(isTurned).toBeVisible();
  await addStep('From the side');
  await page.getByRole('tab', { name: 'Cut' }).click();
  await page.locator('#region-1').focus();
  for (let i = 0; i < 60; i++) await page.keyboard.press('ArrowRight');
  await page.getByRole('tab', { name: 'Steps' }).click();
  await addStep('Opened');
  const box = (await page.locator('#picture').boundingBox())!;
  await page.mouse.move(box.x + 300, box.y + 300);
  await page.mouse.down();
  await page.mouse.move(box.x + 380, box.y + 320, { steps: 4 });
  await page.mouse.up();
  await expect(isTurned).toBeVisible();
  await addStep('What is inside?');
  await page.getByRole('button', { name: 'Choose an answer' }).click();
  await page.keyboard.type('What does the skull hold?');
  await page.getByRole('textbox', { name: 'Answer 1' }).fill('The brain');
  await page.getByRole('textbox', { name: 'Answer 2' }).fill('Air');
  await addStep('How dense is bone?');
  await page.getByRole('button', { name: 'Read a value' }).click();
  await page.keyboard.type('What is the value of bone?');
  await page.getByRole('textbox', { name: 'Right value' }).fill('900');
  await page.getByRole('textbox', { name: 'Right within' }).fill('200');

  // A note, by a click on the picture.
  await page.getByRole('tab', { name: 'Notes' }).click();
  await page.getByRole('button', { name: 'Place a note…' }).click();
  await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
  await expect(page.getByRole('textbox', { name: 'Name' })).toBeFocused();
  await page.keyboard.type('Skull');
  await expect(page.locator('#picture').getByRole('button', { name: 'Skull' })).toBeAttached();

  // Undo of everything, and the picture follows: typing, the place, and then a step with its questions.
  const steps = page.locator('.cards > li');
  for (let i = 0; i < 2; i++) await page.keyboard.press('Control+z');
  await expect(page.locator('#picture volume-note')).toHaveCount(0);
  await page.keyboard.press('Control+Shift+z');
  await page.keyboard.press('Control+Shift+z');
  await expect(page.locator('#picture volume-note')).toHaveAttribute('label', 'Skull');
  await page.getByRole('tab', { name: 'Steps' }).click();
  await page.getByRole('button', { name: '1. From outside' }).click();
  const outside = await orbitOf(page);
  await page.getByRole('button', { name: '2. From the side' }).click();
  await expect.poll(() => orbitOf(page)).not.toBe(outside);
  const picture = page.locator('#picture');
  await expect(picture).not.toHaveAttribute('region', /./);
  await page.getByRole('button', { name: 'Delete this step' }).click();
  await expect(steps).toHaveCount(4);
  await expect(picture).toHaveAttribute('region', /./);
  await page.keyboard.press('Control+z');
  await expect(steps).toHaveCount(5);
  await expect(picture).not.toHaveAttribute('region', /./);
  await page.getByRole('button', { name: '5. How dense is bone?' }).click();
  await page.getByRole('button', { name: 'Move up' }).click();
  await expect(steps.nth(3)).toContainText('How dense is bone?');
  await expect(page.getByRole('button', { name: 'Move up' })).toBeFocused();

  // All of it is there after a reload.
  await expect(page.locator('#keeping')).toHaveText('Kept in this browser');
  await page.reload();
  await expect(steps).toHaveCount(5);
  await expect(steps.nth(3)).toContainText('How dense is bone?');
  await page.keyboard.press('Control+z');
  await expect(steps.nth(4)).toContainText('How dense is bone?');

  // What is missing is said; then the package is written.
  await page.getByRole('button', { name: 'Export' }).click();
  const dialog = page.getByRole('dialog', { name: 'Take the lesson with you' });
  await expect(dialog.getByText('Say who made the data.')).toBeVisible();
  await expect(page.getByRole('button', { name: 'Download' })).toBeDisabled();
  await dialog.getByRole('textbox', { name: 'Title of the lesson' }).fill('The skull');
  await dialog.getByRole('textbox', { name: 'Who made the data' }).fill('Made by a program');
  await dialog.getByRole('textbox', { name: 'Licence of the data' }).fill('CC0 1.0');
  const take = async (kind: RegExp): Promise<Download> => {
    await page.getByRole('radio', { name: kind }).check();
    if (kind.source.includes('sites'))
      await dialog.getByRole('textbox', { name: 'Address' }).fill('https://example.org/skull/');
    const [file] = await Promise.all([
      page.waitForEvent('download'),
      page.getByRole('button', { name: 'Download' }).click(),
    ]);
    return file;
  };
  const single = await take(/One file/);
  expect(single.suggestedFilename()).toBe('the-skull.html');
  const embed = await take(/For other sites/);
  expect(embed.suggestedFilename()).toBe('the-skull-embed.zip');
  const folder = unzipSync(new Uint8Array(readFileSync(await embed.path())));
  expect(JSON.parse(new TextDecoder().decode(folder['oembed.json']))).toMatchObject({
    thumbnail_url: 'https://example.org/skull/data/poster.webp',
    thumbnail_width: 800,
    thumbnail_height: 600,
  });
  writeFileSync(test.info().outputPath('poster.webp'), folder['data/poster.webp']);
  const download = await take(/SCORM 1\.2/);
  expect(download.suggestedFilename()).toBe('the-skull-scorm.zip');
  const packed = await download.path();
  const files = unzipSync(new Uint8Array(readFileSync(packed)));

  // No name, date or identifier of the DICOM files is in the package, or in what the browser keeps.
  const texts = [
    await keptTexts(page),
    readFileSync(await single.path(), 'latin1'),
    ...[...Object.entries(files), ...Object.entries(folder)].flatMap(([path, bytes]) => [
      path,
      Buffer.from(bytes).toString('latin1'),
    ]),
  ];
  expect(texts.filter((text) => /Geheim|1\.2\.840\.99999|19870605/.test(text))).toEqual([]);
  expect(texts[0]).toContain('How dense is bone?');

  // The studio opens what it wrote.
  await page.getByRole('button', { name: 'Close', exact: true }).click();
  await page.getByRole('button', { name: 'Start again' }).click();
  await page.getByRole('button', { name: 'Remove and start again' }).click();
  const [chooser] = await Promise.all([
    page.waitForEvent('filechooser'),
    page.getByRole('button', { name: 'Open a lesson…' }).click(),
  ]);
  await chooser.setFiles(packed);
  await expect(steps).toHaveCount(5);
  await expect(page.getByRole('textbox', { name: 'Title of the lesson' })).toHaveValue('The skull');

  // A learner in a course.
  await play(page, files);
  const lesson = page.frameLocator('iframe');
  await expect(lesson.getByRole('heading', { name: 'From outside' })).toBeVisible();
  for (let i = 0; i < 3; i++) await lesson.getByRole('button', { name: 'Next' }).click();
  await lesson.getByRole('radio', { name: 'The brain' }).check();
  await lesson.getByRole('button', { name: 'Answer' }).click();
  await lesson.getByRole('button', { name: 'Next' }).click();
  await lesson.getByRole('textbox').fill('850');
  await lesson.getByRole('button', { name: 'Answer' }).click();
  await expect
    .poll(() =>
      page.evaluate(() => JSON.parse(JSON.stringify((window as unknown as { API: { cmi: unknown } }).API.cmi)).core),
    )
    .toMatchObject({ lesson_status: 'completed', score: { raw: '100' } });
});
