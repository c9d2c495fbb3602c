import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, test } from './helpers/harness.ts';

// The gallery of packages/archive, with a list of a hundred thousand scans.

const gallery = readFileSync(
  join(import.meta.dirname, '../../packages/archive/src/volume_view_archive/gallery.html'),
  'utf8',
);
const [scans, perPage] = [100_000, 120];
const scanAt = (i: number): object => ({
  id: String(i).padStart(16, '0'),
  title: i === 7 ? '<img src=x onerror="document.title=1">' : `Scan ${i}`,
  page: `${i}/index.html`,
  format: i % 1000 === 7 ? 'NRRD' : 'NIfTI-1',
  unit: 'HU',
  dimensions: [4, 3, i % 500],
  ...(i === scans - 1 && { time: '2024-03-01T12:05:09Z', radar: { name: 'Testfeld', moment: 'DBZH' } }),
});

test('a gallery of a hundred thousand scans asks for one page of its list, and for all words when it is searched', async ({
  page,
}) => {
  const asked: string[] = [];
  await page.route('**/site/**', (route) => {
    const [, name] = new URL(route.request().url()).pathname.split('/site/');
    if (name === 'index.html') return route.fulfill({ contentType: 'text/html', body: gallery });
    asked.push(name);
    const [, number] = /page-(\d+)/.exec(name) ?? [];
    const first = (Number(number) - 1) * perPage;
    if (number)
      return route.fulfill({
        json: Array.from({ length: Math.min(perPage, scans - first) }, (_, i) => scanAt(first + i)),
      });
    if (name.endsWith('words.json'))
      return route.fulfill({
        json: Array.from(
          { length: scans },
          (_, i) => `scan ${i} ${i % 1000 === 7 ? 'nrrd' : 'nifti-1'} 4x3x${i % 500}`,
        ),
      });
    return route.fulfill({ json: { scans, pages: Math.ceil(scans / perPage), perPage } });
  });
  await page.goto('/site/index.html');
  await expect(page.getByRole('status')).toHaveText('100,000 scans');
  await expect(page.getByRole('listitem')).toHaveCount(perPage);
  await expect(page.getByRole('link').first()).toHaveText('Testfeld, DBZH');
  await expect(page.getByRole('listitem').first()).toContainText(
    '2024-03-01 12:05 UTCScan 99999, NIfTI-1, 4 × 3 × 499, HU',
  );
  await expect(page.getByRole('link').nth(1)).toHaveText('Scan 99998');
  await expect(page.getByText('Page 1 of 834')).toBeVisible();
  expect(asked.length, asked.join()).toBeLessThanOrEqual(3);
  await page.getByRole('searchbox').fill('NRRD, 4 × 3 × 7');
  await page.getByRole('button', { name: 'Search' }).click();
  await expect(page.getByRole('status')).toHaveText('100 of 100,000 scans');
  await expect(page.getByRole('listitem')).toHaveCount(24);
  // What a file says is text.
  for (let i = 0; i < 4; i++) await page.getByRole('button', { name: 'Next' }).click();
  await expect(page.getByRole('link').last()).toContainText('<img src=x');
  expect(await page.title()).toBe('Scans');
  await page.goBack();
  await expect(page.getByRole('listitem')).toHaveCount(24);
  await page.getByRole('searchbox').fill('nothing 4x3x7');
  await page.keyboard.press('Enter');
  await expect(page.getByRole('status')).toHaveText('0 of 100,000 scans: none has all of these words');
  await expect(page.getByRole('navigation')).toBeHidden();

  // Two columns on a phone.
  await page.setViewportSize({ width: 390, height: 700 });
  await page.goBack();
  await expect(page.getByRole('listitem')).toHaveCount(24);
  const tops = await page
    .getByRole('listitem')
    .evaluateAll((cards) => cards.slice(0, 3).map((card) => Math.round(card.getBoundingClientRect().top)));
  expect(tops[1]).toBe(tops[0]);
  expect(tops[2]).toBeGreaterThan(tops[0]);
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(390);
});
