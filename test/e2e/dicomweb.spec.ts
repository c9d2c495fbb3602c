// A series on a DICOMweb server of another origin: with CORS, with a token by the property fetch, and without.
import { ctSlice } from '../helpers/dicom-bytes.ts';
import type { VolumeLabels } from '../../components/volume-labels/volume-labels.ts';
import { structureSetFields } from '../helpers/dicom-contours.ts';
import type { Point } from '../helpers/dicom-contours.ts';
import { segment, segmentationFields } from '../helpers/dicom-segmentation.ts';
import type { Segmentation } from '../helpers/dicom-segmentation.ts';
import { startDicomWeb } from '../helpers/dicomweb-server.ts';
import type { DicomWebServer, Faults } from '../helpers/dicomweb-server.ts';
import { expect, keptTest as test, open, settle, withElement } from './helpers/harness.ts';

const slices = Array.from({ length: 6 }, (_, k) => ({ fields: ctSlice(1 * k, {}, 1000 + 100 * k) }));
const running: DicomWebServer[] = [];
const start = async (faults: Faults): Promise<DicomWebServer> => {
  const server = await startDicomWeb(slices, faults);
  running.push(server);
  return server;
};
test.afterEach(async () => {
  await Promise.all(running.splice(0).map((server) => server.close()));
});
const view = (src = '', inside = ''): string =>
  `<main><h1>A series</h1><volume-view id="v" ${src} style="width: 60px; height: 45px" alt="A series" interaction="none">${inside}</volume-view></main>`;

/** Labels of the whole scan, with places of their own. */
const block: Segmentation = {
  type: 'BINARY',
  columns: 4,
  rows: 3,
  frames: slices.map((_, k) => ({ slice: k, segment: 1, pixels: Array<number>(12).fill(1) })),
  segments: [segment(1, 'Liver')],
  orientation: [1, 0, 0, 0, 1, 0],
  spacing: [0.75, 0.5, 1],
  positionOf: (k) => [-10, -20, k],
};
const planes: readonly Point[][] = slices.map((_, k) => [
  [-11, -21, k],
  [-7, -21, k],
  [-7, -17, k],
  [-11, -17, k],
]);
const error = /the list of the DICOMweb series/;

test('is shown where the server allows it', async ({ page }) => {
  const server = await start({ allowed: '*' });
  await open(page, view(`src="${server.url}"`));
  await settle(page);
  expect(
    await withElement(page, ({ volume }) => [volume!.dimensions, volume!.unit, volume!.source, volume!.format]),
  ).toEqual([[4, 3, 6], 'HU', { kind: 'DICOMweb', count: 6 }, 'DICOM, CT']);
});

for (const [what, fields] of [
  ['a segmentation', segmentationFields(block)],
  ['a structure set', structureSetFields([{ number: 1, name: 'Liver', contours: planes }])],
] as const)
  test(`has the labels of ${what} on such a server`, async ({ page }) => {
    const scan = await start({ allowed: '*' });
    const other = await startDicomWeb([{ fields }], { allowed: '*' });
    running.push(other);
    await open(page, view(`src="${scan.url}"`, `<volume-labels src="${other.url}"></volume-labels>`));
    await settle(page);
    const names = await page
      .locator('volume-labels')
      .evaluate((element) => (element as VolumeLabels).labels.map(({ name }) => name));
    expect(names.filter(Boolean)).toEqual(['Liver']);
    const pick = await withElement(page, (one) => one.pick(one.clientWidth / 2, one.clientHeight / 2));
    expect(pick?.labelName).toBe('Liver');
  });

test.describe('behind a token', () => {
  test.use({ allowedLines: /401|Failed to load resource/ });

  test('is shown with the function of the page, which a worker asks for each file, and not without', async ({
    page,
  }) => {
    const server = await start({ allowed: '*', token: 'Bearer 1234' });
    await open(page, view());
    const outcome = await withElement(
      page,
      async (one, url) => {
        const seen: string[] = [];
        one.src = url;
        const end = (type: string): Promise<CustomEvent<{ message: string }>> =>
          new Promise((resolve) => one.addEventListener(type, (event) => resolve(event as never), { once: true }));
        const first = (await end('error')).detail.message;
        one.fetch = (address, options) => {
          seen.push(address as string);
          return fetch(address, {
            ...options,
            headers: { ...Object.fromEntries(new Headers(options?.headers)), Authorization: 'Bearer 1234' },
          });
        };
        one.reload();
        await end('load');
        return { first, seen: seen.length, dimensions: one.volume!.dimensions };
      },
      { argument: server.url },
    );
    expect(outcome.first).toMatch(error);
    expect(outcome.first).toContain('401');
    expect(outcome.seen).toBe(7);
    expect(outcome.dimensions).toEqual([4, 3, 6]);
  });

  test('says in words what is wrong with the function', async ({ page }) => {
    const server = await start({ allowed: '*' });
    await open(page, view());
    const outcomes = await withElement(
      page,
      async (one, url) => {
        const told: string[] = [];
        for (const wrong of [() => Promise.reject(new Error('no token')), () => Promise.resolve('x'), 'x']) {
          one.fetch = wrong as never;
          one.src = `${url}?${told.length}`;
          told.push(
            await one.whenRendered().then(
              () => 'shown',
              (failure: Error) => failure.message,
            ),
          );
        }
        return told;
      },
      { argument: server.url },
    );
    expect(outcomes[0]).toMatch(/the function that the page has set as fetch has failed: Error: no token/);
    expect(outcomes[1]).toMatch(/gives no Response/);
    expect(outcomes[2]).toMatch(/fetch got string; expected a function/);
  });
});

test.describe('of another origin', () => {
  test.use({ allowedLines: /CORS|Failed to load resource/ });

  test('that allows nothing says what the server has to answer', async ({ page }) => {
    const server = await start({});
    await open(page, view());
    const failure = await withElement(
      page,
      async (one, url) => {
        one.src = url;
        const failed = await new Promise<{ code: string; message: string }>((resolve) =>
          one.addEventListener('error', (event) => resolve((event as CustomEvent).detail as never), { once: true }),
        );
        return [failed.code, failed.message];
      },
      { argument: server.url },
    );
    expect(failure[0]).toBe('source/cross-origin');
    expect(failure[1]).toMatch(error);
    expect(failure[1]).toMatch(/Access-Control-Allow-Origin/);
  });
});
