import { existsSync } from 'node:fs';
import { findSharedData } from '../../scripts/shared-data.mjs';
import type { ErrorDetail } from '../../src/index.ts';
import {
  expect,
  fewPixels,
  keptTest as test,
  open,
  setAttributes,
  settle,
  sharePage,
  takePicture,
  test as newPageTest,
  waitForEvent,
  withElement,
} from './helpers/harness.ts';
import { meanOf } from './helpers/pictures.ts';

test.use(fewPixels);

const fixtures: Record<string, { url: string; format: RegExp; moments: number; rms?: number }> = {
  ODIM_H5: { url: '/test/fixtures/radar/odim-2.2.h5', format: /^ODIM_H5 2\.2/, moments: 1 },
  'CfRadial 1, classic': { url: '/test/fixtures/radar/cfradial1-classic.nc', format: /^CfRadial/, moments: 1 },
  'CfRadial 1, NetCDF-4': { url: '/test/fixtures/radar/cfradial1-nc4.nc', format: /^CfRadial/, moments: 1 },
  'CfRadial 2': { url: '/test/fixtures/radar/cfradial2.nc', format: /^CfRadial.?2/, moments: 1 },
  'NEXRAD, message 31': { url: '/test/fixtures/nexrad/message-31.ar2v', format: /^NEXRAD/, moments: 1 },
  // Eight radials of half a beam, 45 degrees apart, are needles in 120 pixels: no number of steps leaves 3 there.
  'NEXRAD, message 1, gzip': { url: '/test/fixtures/nexrad/message-1.gz', format: /^NEXRAD/, moments: 1, rms: 4 },
  'a mosaic with its manifest': { url: '/demos/data/storm-radar-1510.json', format: /polar mosaic/, moments: 1 },
};

const looks = 'transfer-function="-40 #08f 8%, 90 #f80 30%" camera-orbit="200deg 50deg 100%" max-error="3"';

test.describe('of each format', () => {
  const sharedPage = sharePage(`<volume-view ${looks}></volume-view>`);

  for (const [name, { url, format, moments, rms = 3 }] of Object.entries(fixtures))
    test(`${name} is drawn in its own geometry`, async () => {
      const page = sharedPage();
      await setAttributes(page, { src: url });
      const { volume, error } = await withElement(page, (element) => ({
        volume: element.volume,
        error: element.renderStats?.error ?? null,
      }));
      expect(volume!.format).toMatch(format);
      expect(volume!.moments!.length).toBeGreaterThanOrEqual(moments);
      expect(volume!.moments).toContain(volume!.moment);
      expect(meanOf(await takePicture(page))[3]).toBeGreaterThan(0.1);
      expect(error!.rms).toBeLessThanOrEqual(rms);
    });
});

/** One of each kind; all of them are read by the unit tests. */
const shared = [
  'odim_au40_captainsflat/40_20181220_060630.pvol.h5',
  'odim_belgium_20190606/bewid.pvol.hdf',
  'nexrad/KLBB20160601_150025_V06',
  'nexrad/KLIX20050828_180149.gz',
  'cfradial_klbb_converted/KLBB20160601_150025_cfradial1.nc',
  'cfradial_pyart/example_cfradial_cr_raster.nc',
];

const isThere = (file: string): boolean => existsSync(findSharedData(`/shared-data/radar/${file}`) ?? '');
for (const file of shared) if (!isThere(file)) console.log(`left out: the real scan ${file} (needs ../shared/data)`);

test.describe('of the real world', () => {
  const sharedPage = sharePage('<volume-view max-error="3"></volume-view>');

  for (const file of shared.filter(isThere))
    test(`the real scan ${file} is drawn`, async () => {
      const page = sharedPage();
      await setAttributes(page, { src: `/shared-data/radar/${file}` });
      const volume = await withElement(page, (element) => element.volume);
      expect(volume!.unit).toBe('dBZ');
      // The cloud radar's sector of four degrees is framed for itself: in the square around its reach it would be a hundredth.
      expect(meanOf(await takePicture(page))[3]).toBeGreaterThan(0.3);
    });
});

test('another moment is shown, and one that the file has not is an error that names those it has', async ({ page }) => {
  await open(page, `<volume-view src="/test/fixtures/radar/cfradial1-classic.nc" ${looks}></volume-view>`);
  await settle(page);
  const before = await withElement(page, (element) => element.volume!);
  const other = before.moments!.find((moment) => moment !== before.moment);
  if (other) {
    await setAttributes(page, { moment: other });
    expect(await withElement(page, (element) => element.volume!.moment)).toBe(other);
  }
  await page.locator('volume-view').evaluate((element) => element.setAttribute('moment', 'RAINBOWS'));
  const { code, message } = (await waitForEvent(page, 'error')).detail as ErrorDetail;
  expect(code).toBe('attribute/invalid');
  expect(message).toContain('RAINBOWS');
  for (const moment of before.moments!) expect(message).toContain(moment);
});

test('heights are stretched as asked for', async ({ page }) => {
  await open(
    page,
    `<volume-view src="/demos/data/storm-radar-1510.json" vertical-exaggeration="1" ${looks}></volume-view>`,
  );
  await settle(page);
  const heightOf = () => withElement(page, (element) => element.volume!.spacing[2] * element.volume!.dimensions[2]);
  const plain = await heightOf();
  await setAttributes(page, { 'vertical-exaggeration': '8' });
  expect((await heightOf()) / plain).toBeCloseTo(8, 6);
});

newPageTest('a page with a NIfTI file loads nothing of the radar', async ({ page }) => {
  const requests: string[] = [];
  page.on('request', (request) => requests.push(new URL(request.url()).pathname));
  await open(page, '<volume-view src="/test/e2e/pages/data/field.nii.gz"></volume-view>');
  await settle(page);
  expect(requests.filter((path) => /nifti/.test(path))).toHaveLength(1);
  expect(requests.filter((path) => /radar|hdf5|nexrad|cfradial|polar/.test(path))).toEqual([]);
});
