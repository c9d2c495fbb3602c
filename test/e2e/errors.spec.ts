import type { Page } from '@playwright/test';
import { files } from './helpers/data.ts';
import {
  compare,
  expect,
  expectSamePicture,
  fieldUrl,
  networkLines,
  open,
  seenEvents,
  settle,
  sharePage,
  takePicture,
  takeScreenshot,
  keptTest as test,
  test as newPageTest,
  waitForEvent,
  withElement,
} from './helpers/harness.ts';
import type { Seen } from './helpers/harness.ts';
import { attributesOf, drawReference, plainAttributes } from './helpers/reference.ts';

const plain = `<volume-view src="${fieldUrl}" ${attributesOf()} alt="A field"></volume-view>`;
const goodAttributes: Record<string, string> = { src: fieldUrl, ...plainAttributes };
const dataFolder = '/test/e2e/pages/data';

/** A header that asks for 10^12 voxels of 4 bytes, and nothing after it. */
function hugeNifti(): Uint8Array {
  const bytes = files['ball.nii'].slice(0, 352);
  const view = new DataView(bytes.buffer);
  for (const at of [42, 44, 46]) view.setInt16(at, 10_000, true);
  return bytes;
}

function patchedNifti(patch: (bytes: Uint8Array, view: DataView) => void): Uint8Array {
  const bytes = files['field.nii'].slice();
  patch(bytes, new DataView(bytes.buffer));
  return bytes;
}

const json = (value: unknown): Uint8Array => new TextEncoder().encode(JSON.stringify(value));

/** Files that are wrong, by name. */
const wrongFiles: Record<string, Uint8Array | string> = {
  'notes.txt': 'What a fine day it is.',
  'page.html': '<!doctype html><title>Sign in</title>',
  'page.nii.gz': '<!doctype html><title>Sign in</title>',
  'empty.nii': '',
  'cut.nii.gz': files['field.nii.gz'].slice(0, 3000),
  'cut.nii': files['field.nii'].slice(0, 3000),
  'huge.nii': hugeNifti(),
  'pair.hdr': patchedNifti((bytes) => bytes.set([0x6e, 0x69, 0x31], 344)),
  'bits.nii': patchedNifti((_, view) => view.setInt16(70, 1, true)),
  'cut.png': files['field.png'].slice(0, 2000),
  'broken.json': '{ "image": ',
  'no-image.json': json({ mosaic: '4x4' }),
  'lost-image.json': json({ image: 'nowhere.png', mosaic: '4x4' }),
  'no-mosaic.json': json({ image: `${dataFolder}/field.png` }),
};

interface Fault {
  readonly attributes: Record<string, string>;
  readonly code: string;
  readonly message: RegExp;
}

const faults: Record<string, Fault> = {
  'a missing file': {
    attributes: { src: 'nowhere.nii' },
    code: 'source/not-found',
    message: /nowhere\.nii got HTTP status 404/,
  },
  'a server that is away': {
    attributes: { src: 'away.nii' },
    code: 'source/not-found',
    message: /away\.nii can not be fetched/,
  },
  'a text file': {
    attributes: { src: 'notes.txt' },
    code: 'format/unknown',
    message: /notes\.txt .*is of no known type; expected .*NIfTI/,
  },
  'a web page': { attributes: { src: 'page.html' }, code: 'format/unknown', message: /page\.html with a web page/ },
  'a web page in the place of a file': {
    attributes: { src: 'page.nii.gz' },
    code: 'format/unknown',
    message: /page\.nii\.gz with a web page/,
  },
  'an empty file': { attributes: { src: 'empty.nii' }, code: 'format/unknown', message: /empty\.nii is empty/ },
  'a cut gzip': { attributes: { src: 'cut.nii.gz' }, code: 'format/corrupt', message: /gz/ },
  'a cut file': { attributes: { src: 'cut.nii' }, code: 'format/corrupt', message: /\d/ },
  'a header that asks for 10^12 voxels': {
    attributes: { src: 'huge.nii' },
    code: 'format/too-large',
    message: /10000 x 10000 x 10000|1,?000,?000,?000,?000|e\+?12/,
  },
  'a cut PNG': { attributes: { src: 'cut.png', mosaic: '4x4' }, code: 'format/corrupt', message: /PNG|png/ },
  'a header without its data': {
    attributes: { src: 'pair.hdr' },
    code: 'source/not-found',
    message: /pair\.hdr is one of the two files of .*neither pair\.img nor pair\.img\.gz was found/,
  },
  'a datatype of bits': {
    attributes: { src: 'bits.nii' },
    code: 'format/unsupported',
    message: /holds .*; convert it to numbers first/,
  },
  'a mosaic of no layout': {
    attributes: { src: `${dataFolder}/field.png` },
    code: 'mosaic/layout',
    message: /96 x 80 pixels got no mosaic layout/,
  },
  'a mosaic that does not fit': {
    attributes: { src: `${dataFolder}/field.png`, mosaic: '200x4' },
    code: 'mosaic/layout',
    message: /200 x 4 tiles for an image of 96 x 80/,
  },
  'more slices than tiles': {
    attributes: { src: `${dataFolder}/field.png`, mosaic: '4x4', slices: '17' },
    code: 'mosaic/layout',
    message: /17/,
  },
  'a manifest that is no JSON': { attributes: { src: 'broken.json' }, code: 'manifest/invalid', message: /not JSON/ },
  'a manifest without image': {
    attributes: { src: 'no-image.json' },
    code: 'manifest/invalid',
    message: /"image" got nothing/,
  },
  'a manifest whose image is missing': {
    attributes: { src: 'lost-image.json' },
    code: 'source/not-found',
    message: /nowhere\.png got HTTP status 404/,
  },
  'a manifest without mosaic': {
    attributes: { src: 'no-mosaic.json' },
    code: 'mosaic/layout',
    message: /no mosaic layout/,
  },
  'another origin without CORS': {
    attributes: { src: `CROSS/no-cors${fieldUrl}` },
    code: 'source/cross-origin',
    message: /Access-Control-Allow-Origin/,
  },
  'a transfer function with a typo': {
    attributes: { 'transfer-function': '0 black 0, 1 whit 5%' },
    code: 'transfer-function/syntax',
    message: /stop 2, "1 whit 5%", got the colour "whit"/,
  },
  'a preset with a typo': {
    attributes: { 'transfer-function': 'virids' },
    code: 'transfer-function/syntax',
    message: /virids.*viridis/,
  },
  'falling stops': {
    attributes: { 'transfer-function': '1 black 0, 0 white 5%' },
    code: 'transfer-function/syntax',
    message: /stop 2 got the value 0, which is below 1/,
  },
  'an empty transfer function': {
    attributes: { 'transfer-function': '' },
    code: 'transfer-function/syntax',
    message: /stop 1.*got nothing/,
  },
  spacing: {
    attributes: { spacing: '1 2' },
    code: 'attribute/invalid',
    message: /spacing got "1 2"; expected 3 numbers/,
  },
  'spacing of nothing': {
    attributes: { spacing: '1 1 0' },
    code: 'attribute/invalid',
    message: /spacing got "1 1 0"; expected three lengths that are not zero/,
  },
  'value-window': {
    attributes: { 'value-window': '5 1' },
    code: 'attribute/invalid',
    message: /^value-window got "5 1"; expected the lower value first/,
  },
  steps: {
    attributes: { steps: 'lots' },
    code: 'attribute/invalid',
    message: /steps got "lots"; expected auto, or a number from 1/,
  },
  'no steps': { attributes: { steps: '0' }, code: 'attribute/invalid', message: /steps got "0"/ },
  'camera-orbit': {
    attributes: { 'camera-orbit': '30deg 70deg' },
    code: 'attribute/invalid',
    message: /camera-orbit got "30deg 70deg"; expected three parts/,
  },
  'camera-orbit in gradians': {
    attributes: { 'camera-orbit': '30grad 70deg 1' },
    code: 'attribute/invalid',
    message: /expected angles in deg or rad/,
  },
  'camera-target': {
    attributes: { 'camera-target': 'here' },
    code: 'attribute/invalid',
    message: /camera-target got "here"; expected 3 numbers/,
  },
  'field-of-view': {
    attributes: { 'field-of-view': '190deg' },
    code: 'attribute/invalid',
    message: /field-of-view got "190deg"; expected an angle between/,
  },
  coordinates: {
    attributes: { coordinates: 'round' },
    code: 'attribute/invalid',
    message: /coordinates got "round"; expected cartesian or spherical/,
  },
  'beam-model': {
    attributes: { 'beam-model': 'bent' },
    code: 'attribute/invalid',
    message: /beam-model got "bent"; expected standard or straight/,
  },
  'vertical-exaggeration': {
    attributes: { 'vertical-exaggeration': '0' },
    code: 'attribute/invalid',
    message: /vertical-exaggeration got "0"; expected a number above zero/,
  },
  'max-error': { attributes: { 'max-error': 'none' }, code: 'attribute/invalid', message: /max-error got "none"/ },
  'target-fps': { attributes: { 'target-fps': '-30' }, code: 'attribute/invalid', message: /target-fps got "-30"/ },
  mosaic: {
    attributes: { mosaic: '4 by 4' },
    code: 'attribute/invalid',
    message: /mosaic got "4 by 4"; expected tiles/,
  },
  slices: {
    attributes: { slices: '-3' },
    code: 'attribute/invalid',
    message: /slices got "-3"; expected a whole number/,
  },
  'reference-length': {
    attributes: { 'reference-length': '0' },
    code: 'attribute/invalid',
    message: /reference-length got "0"; expected a number above zero/,
  },
  'opacity-factor': {
    attributes: { 'opacity-factor': '-1' },
    code: 'attribute/invalid',
    message: /opacity-factor got "-1"; expected a number from 0/,
  },
  'light-factor': {
    attributes: { 'light-factor': 'bright' },
    code: 'attribute/invalid',
    message: /light-factor got "bright"/,
  },
};

/** Readers are shown the folder and the name of an address. */
const withoutAddresses = (message: string): string =>
  message.replace(/https?:\S+\/(?=[^\s/]+\/[^\s/]+ (got|can) )/g, '');

async function serveWrongFiles(page: Page): Promise<void> {
  for (const [name, body] of Object.entries(wrongFiles)) {
    await page.route(`**/pages/${name}`, (route) =>
      route.fulfill({
        contentType: name.endsWith('.html') ? 'text/html' : 'application/octet-stream',
        body: typeof body === 'string' ? body : Buffer.from(body),
      }),
    );
  }
  await page.route('**/pages/away.nii', (route) => route.abort('connectionrefused'));
}

/** What `error` says. */
const notifiedBy = ({ detail }: Seen): { code: string; message: string } => detail as { code: string; message: string };

test.describe('bad input', () => {
  test.use({ allowedLines: networkLines });

  test.describe('one after the other', () => {
    const head = '<style>volume-view { background: white } volume-view.bare::part(error) { display: none }</style>';
    const sharedPage = sharePage(plain, { head, prepare: serveWrongFiles });

    for (const [name, { attributes, code, message }] of Object.entries(faults))
      test(`${name}: ${code}`, async () => {
        const page = sharedPage();
        await page.locator('volume-view').evaluate(
          (element, [changes, cross]) => {
            for (const [attribute, value] of Object.entries(changes))
              element.setAttribute(attribute, value.replace('CROSS', cross));
          },
          [attributes, process.env.VOLUME_VIEW_CROSS_URL!] as const,
        );
        const reported = notifiedBy(await waitForEvent(page, 'error'));
        expect(reported.code).toBe(code);
        expect(reported.message).toMatch(message);
        // One fault, one event, in words for everybody, in place.
        await expect(page.getByRole('alert').getByRole('paragraph')).toHaveText([
          /^[A-Z].+\.$/,
          withoutAddresses(reported.message),
        ]);
        const rejection = await withElement(page, (element) =>
          element.whenRendered().then(
            () => 'resolved',
            (error: { code: string }) => error.code,
          ),
        );
        expect(rejection).toBe(code);
        expect((await seenEvents(page)).filter(({ type }) => type === 'error')).toHaveLength(1);
        // The last good picture is kept.
        await page.locator('volume-view').evaluate((element) => element.classList.add('bare'));
        expectSamePicture(await takeScreenshot(page), drawReference({ background: [255, 255, 255] }));
        // Put right, all is well.
        await page.locator('volume-view').evaluate(
          (element, [changes, good]) => {
            element.classList.remove('bare');
            for (const attribute of Object.keys(changes)) {
              if (attribute in good) element.setAttribute(attribute, good[attribute]);
              else element.removeAttribute(attribute);
            }
          },
          [attributes, goodAttributes] as const,
        );
        await settle(page);
        await expect(page.getByRole('alert')).toHaveCount(0);
        expectSamePicture(await takePicture(page), drawReference());
        expect((await seenEvents(page)).filter(({ type }) => type === 'error')).toHaveLength(1);
      });
  });

  newPageTest(
    'an exception that nobody expects is internal, and names the file or the attributes',
    async ({ page }) => {
      await page.addInitScript(() => {
        for (const { prototype } of [WebGLRenderingContext, WebGL2RenderingContext]) {
          const { flush } = prototype;
          prototype.flush = function () {
            if ((window as { broken?: boolean }).broken) throw new TypeError('nobody expects this');
            flush.call(this);
          };
        }
      });
      await open(page, plain);
      await settle(page);
      await page.evaluate(() => Object.assign(window, { broken: true }));
      await withElement(page, (element) => element.setAttribute('steps', '50'));
      const { code, message } = notifiedBy(await waitForEvent(page, 'error'));
      expect(code).toBe('internal');
      expect(message).toContain(fieldUrl);
      expect(message).toContain('nobody expects this');
      await page.evaluate(() => Object.assign(window, { broken: false }));
      await withElement(page, (element) => element.setAttribute('steps', '30'));
      await settle(page);
      await expect(page.getByRole('alert')).toHaveCount(0);
    },
  );

  test('at the first load there is no picture, and the words stand in place', async ({ page }) => {
    await open(page, '<volume-view src="nowhere.nii"></volume-view>');
    const { message } = notifiedBy(await waitForEvent(page, 'error'));
    await expect(page.getByText(message.slice(message.indexOf('nowhere.nii')))).toBeVisible();
    expect(await withElement(page, (element) => [element.volume, element.renderStats])).toEqual([null, null]);
    expect(await withElement(page, (element) => element.toBlob().catch((error: { code: string }) => error.code))).toBe(
      'source/not-found',
    );
    expect(await withElement(page, (element) => element.redraw().catch((error: { code: string }) => error.code))).toBe(
      'source/not-found',
    );
  });

  test('of an address a reader sees the folder and the name, and nothing that may be secret', async ({ page }) => {
    await open(page, '<volume-view src="/courses/anatomy/nowhere.nii?token=a1b2c3#part"></volume-view>');
    const { message } = notifiedBy(await waitForEvent(page, 'error'));
    expect(message).toContain('/courses/anatomy/nowhere.nii?token=a1b2c3');
    const shown = page.getByRole('alert').getByRole('paragraph').last();
    await expect(shown).toHaveText(
      /^anatomy\/nowhere\.nii got HTTP status 404 Not Found; expected the file; check the URL/,
    );
    await expect(shown).not.toHaveText(/token|courses|:\/\//);
  });

  test('a wrong transfer function at the first load still shows the volume, and says so', async ({ page }) => {
    await open(page, `<volume-view src="${fieldUrl}" transfer-function="rainbow"></volume-view>`);
    await waitForEvent(page, 'load');
    await waitForEvent(page, 'render');
    expect((await seenEvents(page)).map(({ type }) => type)).toContain('error');
    await expect(page.getByRole('alert')).toContainText('rainbow');
    await page.locator('volume-view').evaluate((element) => element.setAttribute('transfer-function', 'viridis'));
    await settle(page);
    await expect(page.getByRole('alert')).toHaveCount(0);
  });

  test('an author may fill the error slot', async ({ page }) => {
    await open(page, '<volume-view src="nowhere.nii"><p slot="error">The scan is on holiday.</p></volume-view>');
    await waitForEvent(page, 'error');
    await expect(page.getByText('The scan is on holiday.')).toBeVisible();
    await expect(page.getByText('404')).toBeHidden();
  });

  test('two faults: one is put right, the other stays', async ({ page }) => {
    await open(page, plain);
    await settle(page);
    await withElement(page, async (element) => {
      element.setAttribute('steps', 'lots');
      element.cameraOrbit = 'round';
      await element.updateComplete;
    });
    await expect(page.getByRole('alert')).toContainText('camera-orbit');
    await withElement(page, (element) => {
      element.cameraOrbit = '35deg 65deg 90';
    });
    await expect(page.getByRole('alert')).toContainText('steps');
    await withElement(page, (element) => {
      element.steps = 60;
    });
    await expect(page.getByRole('alert')).toHaveCount(0);
    expectSamePicture(await takePicture(page), drawReference());
  });

  newPageTest('x3dom that is missing, and then is there', async ({ page }) => {
    await page.route('**/x3dom.js', (route) => route.abort());
    await open(page, plain);
    const reported = notifiedBy(await waitForEvent(page, 'error'));
    expect(reported.code).toBe('x3dom/unavailable');
    expect(reported.message).toMatch(/x3dom could not be loaded from http.*\/dist\/x3dom\.js/);
    await expect(page.getByRole('alert').getByRole('paragraph')).toHaveText([
      /^[A-Z].+\.$/,
      reported.message.replace(/http\S+\/(?=dist\/x3dom)/, ''),
    ]);
    await page.unroute('**/x3dom.js');
    await withElement(
      page,
      async (element, url) => {
        element.src = null;
        await element.updateComplete;
        element.src = url;
      },
      { argument: fieldUrl },
    );
    expectSamePicture(await takePicture(page), drawReference());
    await expect(page.getByRole('alert')).toHaveCount(0);
  });

  newPageTest('a worker script that is missing does not matter', async ({ page }) => {
    await page.route('**/decode-worker*.js', (route) => route.fulfill({ status: 404 }));
    await open(page, plain);
    expectSamePicture(await takePicture(page), drawReference());
  });
});

newPageTest('a page without WebGL', async ({ page }) => {
  await page.addInitScript(() => {
    HTMLCanvasElement.prototype.getContext = () => null;
  });
  await open(page, plain);
  const reported = notifiedBy(await waitForEvent(page, 'error'));
  expect(reported.code).toBe('webgl/unavailable');
  expect(reported.message).toMatch(/no WebGL/);
  await expect(page.getByRole('alert').getByRole('paragraph')).toHaveText([/^[A-Z].+\.$/, reported.message]);
});

newPageTest('WebGL that goes away after the probe', async ({ page }) => {
  await page.addInitScript(() => {
    const original = HTMLCanvasElement.prototype.getContext;
    let asked = 0;
    HTMLCanvasElement.prototype.getContext = function (this: HTMLCanvasElement, ...args: unknown[]) {
      return asked++ === 0 ? (Reflect.apply(original, this, args) as never) : null;
    };
  });
  await open(page, plain);
  const reported = notifiedBy(await waitForEvent(page, 'error'));
  expect(reported.code).toBe('webgl/unavailable');
  await expect(page.getByRole('alert').getByRole('paragraph')).toHaveText([/^[A-Z].+\.$/, reported.message]);
});

test('a message is text, whatever an attribute holds', async ({ page }) => {
  await open(page, plain);
  await settle(page);
  await page
    .locator('volume-view')
    .evaluate((element) => element.setAttribute('value-window', '<img src=x onerror=alert(1)>'));
  await waitForEvent(page, 'error');
  await expect(page.getByRole('alert')).toContainText('<img src=x onerror=alert(1)>');
  await expect(page.locator('volume-view img')).toHaveCount(0);
  expect(compare(await takeScreenshot(page), await takeScreenshot(page)).worst).toBe(0);
});
