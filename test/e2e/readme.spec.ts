// The way of a new user: what the README, first-steps.md, embedding.md and lesson.md of docs/guide print, copied into a folder of its own, word by word.
import { spawnSync } from 'node:child_process';
import { cpSync, mkdirSync, readFileSync, symlinkSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import type { Frame, Page } from '@playwright/test';
import { projectRoot } from '../../scripts/shared-data.mjs';
import { startStaticServer } from '../../scripts/static-server.mjs';
import { expect, fewPixels, networkLines, test } from './helpers/harness.ts';

/** The blocks of a language in a Markdown file, also in lists. */
function readBlocks(path: string, language: string): string[] {
  const text = readFileSync(join(projectRoot, path), 'utf8');
  return [...text.matchAll(new RegExp(`^( *)\`\`\`${language}\\n([^]*?)^ *\`\`\`$`, 'gm'))].map(([, indent, block]) =>
    block.replaceAll(new RegExp(`^${indent}`, 'gm'), ''),
  );
}

const firstPages = ['README.md', 'docs/guide/first-steps.md'];
const tags = firstPages.flatMap((path) => readBlocks(path, 'html'));
const frames = [
  ...tags.filter((block) => block.startsWith('<iframe')),
  // One is on another server, in a sandbox: embed.spec opens such a frame.
  ...readBlocks('docs/guide/embedding.md', 'html').filter((block) => !block.includes('https://')),
];
const lesson = readBlocks('docs/guide/lesson.md', 'html');
const script = tags.find((block) => block.includes('<script'))!.replace(/\n\n[^]*/, '\n');

/** A folder as a new user has it who follows the README: the build, and the files to try. */
function makeFolder(folder: string): string {
  mkdirSync(folder, { recursive: true });
  for (const name of ['demos', 'dist']) symlinkSync(join(projectRoot, name), join(folder, name));
  const copies = firstPages.map((path) => readBlocks(path, 'sh').find((block) => block.startsWith('cp '))!);
  for (const block of copies) {
    const { status, stderr } = spawnSync('sh', ['-ec', block], { cwd: folder, encoding: 'utf8' });
    expect(status, stderr).toBe(0);
  }
  return folder;
}

/** Open a page with a block in it, from a plain server of the folder. */
async function openBlock(page: Page, folder: string, block: string): Promise<() => void> {
  writeFileSync(
    join(folder, 'page.html'),
    block.startsWith('<!doctype')
      ? block
      : `<!doctype html>\n<html lang="en"><head><meta charset="utf-8"><title>Mine</title></head><body>\n${block}\n</body></html>\n`,
  );
  const server = await startStaticServer({ root: folder });
  await page.goto(`${server.url}/page.html`);
  return server.close;
}

/** The share of the picture in which something is seen, once it is there; an error that is shown fails the test. */
async function shareShown(frame: Page | Frame): Promise<number> {
  const view = frame.locator('volume-view');
  await expect(frame.getByRole('alert')).toHaveCount(0);
  return view.evaluate(async (element) => {
    const bitmap = await createImageBitmap(
      await (element as HTMLElementTagNameMap['volume-view']).toBlob({ width: 160, height: 120 }),
    );
    const context = new OffscreenCanvas(160, 120).getContext('2d')!;
    context.drawImage(bitmap, 0, 0);
    const { data } = context.getImageData(0, 0, 160, 120);
    return data.filter((alpha, i) => i % 4 === 3 && alpha > 64).length / (160 * 120);
  });
}

test.use({ ...fewPixels, viewport: { width: 320, height: 560 } });

test('the lesson has pages and tags to copy, up to five steps', () => {
  expect(lesson.map((block) => block.split('<volume-step').length - 1)).toEqual([0, 1, 3, 2, 5]);
});

for (const [index, block] of lesson.entries()) {
  test(`the lesson, ${index + 1}: each step as printed`, async ({ page }, testInfo) => {
    const isPage = block.startsWith('<!doctype');
    const close = await openBlock(page, makeFolder(testInfo.outputPath('mine')), isPage ? block : script + block);
    expect(await shareShown(page)).toBeGreaterThan(0.01);
    const titles = await page.locator('volume-step h2').allTextContents();
    for (const [i, name] of titles.entries()) {
      if (i > 0) await page.getByRole('button', { name: 'Next step' }).click();
      await expect(page.getByRole('heading', { name, level: 2 })).toBeVisible();
      await expect(page.getByRole('button', { name: `${i + 1}. ${name}` })).toHaveAttribute('aria-current', 'step');
      expect(await shareShown(page)).toBeGreaterThan(0.01);
    }
    await expect(page.locator('volume-tour [part=error]')).toHaveCount(0);
    close();
  });
}

test('the README and the first steps have a page, tags and a frame to copy', () => {
  expect(readBlocks('README.md', 'html')[0]).toContain('<script');
  expect(tags.length).toBeGreaterThanOrEqual(4);
  expect(frames.length).toBeGreaterThanOrEqual(4);
  expect(script).toContain('dist/volume-view.js');
});

for (const [index, block] of tags.filter((one) => !one.startsWith('<iframe')).entries()) {
  test(`tags ${index + 1} as printed: ${/src="([^"]*(?:gz|json))/.exec(block)?.[1]}`, async ({ page }, testInfo) => {
    const close = await openBlock(
      page,
      makeFolder(testInfo.outputPath('mine')),
      block.includes('<script') ? block : script + block,
    );
    expect(await shareShown(page)).toBeGreaterThan(0.05);
    for (const companion of block.match(/<volume-(?!view)[\w-]+/g) ?? [])
      await expect(page.locator(companion.slice(1))).toBeVisible();
    close();
  });
}

for (const [index, block] of frames.entries()) {
  test(`frame ${index + 1}, as printed`, async ({ page }, testInfo) => {
    const close = await openBlock(page, makeFolder(testInfo.outputPath('mine')), block);
    const box = (await page.locator('iframe').boundingBox())!;
    expect(box.height).toBeGreaterThanOrEqual(300);
    // The frame has its address only once it begins to load.
    await expect.poll(() => page.frame({ url: /embed\.html/ }) !== null).toBe(true);
    const frame = page.frame({ url: /embed\.html/ })!;
    expect(await shareShown(frame)).toBeGreaterThan(0.05);
    await expect(frame.getByRole('button').first()).toBeVisible();
    close();
  });
}

test.describe('a frame whose file is looked for in the wrong folder', () => {
  test.use({ allowedLines: networkLines });

  test('says in which, and what to write', async ({ page }, testInfo) => {
    const close = await openBlock(page, makeFolder(testInfo.outputPath('mine')), frames[0].replace('../', ''));
    const frame = page.frameLocator('iframe');
    await expect(frame.getByRole('alert')).toContainText('dist/head.nii.gz got HTTP status 404');
    await expect(frame.locator('.hint')).toHaveText(
      'Addresses count from the folder of this page, /dist/. If the file is in the folder above it, write src=../head.nii.gz',
    );
    close();
  });
});

test('from disk: the page that makes pages, and the page that it makes', async ({ page }, testInfo) => {
  const folder = testInfo.outputPath('dist');
  cpSync(join(projectRoot, 'dist'), folder, { recursive: true, filter: (path) => !/\/(esm|types)$/.test(path) });
  await page.goto(pathToFileURL(join(folder, 'from-disk.html')).href);
  await expect(page.getByRole('button', { name: 'Save' })).toBeDisabled();
  await page.getByLabel('Choose a file').setInputFiles(join(projectRoot, 'demos/data/ct-phantom.nii.gz'));
  await page.getByLabel('Say in words').fill('Torso <b>"1"</b> & more');
  expect(await shareShown(page)).toBeGreaterThan(0.05);
  const saved = page.waitForEvent('download');
  await page.getByRole('button', { name: 'Save' }).click();
  const download = await saved;
  expect(download.suggestedFilename()).toBe('ct-phantom.html');
  await download.saveAs(join(folder, 'ct-phantom.html'));
  await page.goto(pathToFileURL(join(folder, 'ct-phantom.html')).href);
  expect(await shareShown(page)).toBeGreaterThan(0.05);
  expect(await page.locator('volume-view').getAttribute('alt')).toBe('Torso <b>"1"</b> & more');
  expect(await page.locator('b').count()).toBe(0);
});

test('from disk: a file that is too large is refused in words', async ({ page }) => {
  await page.goto(pathToFileURL(join(projectRoot, 'dist/from-disk.html')).href);
  await page.getByLabel('Choose a file').evaluate((input: HTMLInputElement) => {
    // A file of 65 MiB in name alone.
    Object.defineProperty(input, 'files', { value: [{ name: 'huge.nii', size: 65 * 2 ** 20 }] });
    input.dispatchEvent(new Event('change'));
  });
  await expect(page.getByRole('status').first()).toHaveText(
    'huge.nii has 65 MiB; a page from disk can hold files of up to 64 MiB. Put this one on a web server.',
  );
});
