// What the GPU draws against rays that are cast on the processor, in the page: the whole way from attributes to pixels, in every kind of picture.
import type { Page } from '@playwright/test';
import type { PictureCheck } from '../../src/quality/compare-rays.ts';
import { openDemo } from './helpers/demo.ts';
import {
  expect,
  fewPixels,
  fieldUrl,
  keptTest as test,
  open,
  settle,
  test as newPageTest,
  withElement,
} from './helpers/harness.ts';

test.use(fewPixels);

const shown = 'style="width: 120px; height: 90px" alt="What is shown"';
const mri = '/demos/data/mni152-t1.nii.gz';
const torso = '/demos/data/ct-phantom.nii.gz';
const storm = '/demos/data/storm-radar-1510.json';

/** Kinds of pictures, as an author writes them. */
const kinds: Record<string, string> = {
  'one attribute': `<volume-view src="${mri}" ${shown}></volume-view>`,
  'less work at rest': `<volume-view src="${mri}" detail="free" max-error="8" ${shown}></volume-view>`,
  'given steps, half of what is asked at rest': `<volume-view src="${mri}" steps="180" ${shown}></volume-view>`,
  'a window, factors and bands': `<volume-view src="${torso}" value-window="-200 600" transfer-function="-200 #000 0, 40 #f80 0, 40 #f80 30%, 300 #fff 80%" opacity-factor="0.7" light-factor="1.2" ${shown}></volume-view>`,
  'light of its own, and a cut': `<volume-view src="${mri}" shading="lit" cutout="0 0 0 200 200 200" transfer-function="20% #e2b9a6 0, 30% #e2b9a6 60%, 100% #fff 90%" ${shown}><directionallight direction="1 1 -1" intensity="0.8"></directionallight></volume-view>`,
  'ambient occlusion, and a cut': `<volume-view src="${mri}" look="textbook" shading="ambient-occlusion" cutout="0 0 0 200 200 200" ${shown}></volume-view>`,
  'a look by one word': `<volume-view src="${torso}" look="textbook" ${shown}></volume-view>`,
  'an X-ray by one word': `<volume-view src="${torso}" look="xray" ${shown}></volume-view>`,
  'surfaces of values in fog': `<volume-view src="${torso}" surface-values="-300 #d9a98c 25%, 250 #f3e6cc" region="-100 -100 -100 100 80 100" ${shown}></volume-view>`,
  styles: `<volume-view src="${mri}" transfer-function="20% #e2b9a6 0, 40% #e2b9a6 40%, 100% #fff 70%" ${shown}><SilhouetteEnhancementVolumeStyle silhouetteSharpness="4"></SilhouetteEnhancementVolumeStyle></volume-view>`,
  'value and gradient': `<volume-view src="${torso}" gradient-opacity="0 0, 200 100%" ${shown}></volume-view>`,
  'the largest value': `<volume-view src="${torso}" projection="max" ${shown}></volume-view>`,
  'the mean': `<volume-view src="${torso}" projection="average" transfer-function="gray" ${shown}></volume-view>`,
  'a slice': `<volume-view src="${mri}" opacity-factor="0.3" ${shown}><volume-slice type="axial"></volume-slice></volume-view>`,
  'a clip and a shape': `<volume-view src="${mri}" ${shown}><volume-clip normal="0 1 0"></volume-clip><transform translation="40 0 20"><shape><appearance><material diffuseColor="0 1 0"></material></appearance><sphere radius="30"></sphere></shape></transform></volume-view>`,
  labels: `<volume-view src="${mri}" ${shown}><volume-labels src="/demos/data/brodmann-2mm.nii.gz" table="/demos/data/brodmann-dseg.tsv"></volume-labels></volume-view>`,
  'a layer': `<volume-view src="${mri}" ${shown}><volume-layer src="/demos/data/motor-synthetic.nii.gz"></volume-layer></volume-view>`,
  'a layer that colours labels': `<volume-view src="${mri}" ${shown}><volume-labels src="/demos/data/brodmann-2mm.nii.gz" table="/demos/data/brodmann-dseg.tsv"></volume-labels><volume-layer src="/demos/data/motor-synthetic.nii.gz" blend="color"></volume-layer></volume-view>`,
  'a radar, its ground and its rings': `<volume-view src="${storm}" vertical-exaggeration="4" ${shown}></volume-view>`,
  'cuts of a radar, brightened': `<volume-view src="${storm}" light-factor="1.5" vertical-exaggeration="4" ${shown}><volume-slice type="cappi" height="3000"></volume-slice></volume-view>`,
  'a lit radar in the colours of its wind': `<volume-view src="/demos/data/storm-radar-island.json" vertical-exaggeration="4" shading="lit" ${shown}><volume-layer src="/demos/data/storm-radar-1500-unfolded.json" blend="color"></volume-layer></volume-view>`,
};

// A view that is far away has no context while nobody asks for its picture.
test('a view far below the visible part of the page is checked too', async ({ page }) => {
  await open(page, `<div style="height: 5000px"></div><volume-view src="${mri}" ${shown}></volume-view>`);
  for (let i = 0; i < 2; i++) expect((await check(page))!.agrees).toBe(true);
  expect(await page.evaluate(() => scrollY)).toBe(0);
});

function check(page: Page): Promise<PictureCheck | null> {
  return withElement(page, (element) => element.checkPicture());
}

for (const [kind, markup] of Object.entries(kinds)) {
  test(`in float64 a picture is the same: ${kind}`, async ({ page }) => {
    await open(page, markup);
    await settle(page);
    const { rays, off, max, agrees } = (await check(page))!;
    console.log(`${kind}: ${rays} rays, largest difference ${max.toFixed(2)}`);
    expect(rays).toBeGreaterThan(12);
    expect(off).toBe(0);
    expect(max).toBeLessThan(1);
    expect(agrees).toBe(true);
  });
}

/** A GPU whose exponential function is wrong by a tenth, as those in half floats may be. */
function breakGpu(): void {
  for (const { prototype } of [WebGLRenderingContext, WebGL2RenderingContext]) {
    const original = prototype.shaderSource;
    prototype.shaderSource = function (shader, text) {
      original.call(this, shader, text.replaceAll('exp(-', 'exp(-1.1*'));
    };
  }
}

/** What the element told, and what it says. */
function reported(page: Page): Promise<{ code: string | undefined; message: string; checks: PictureCheck[] }> {
  return withElement(page, (element) => {
    const { checks, code } = element as unknown as { checks: PictureCheck[]; code?: string };
    return { code, checks, message: element.shadowRoot!.querySelector('[part=error]')?.textContent ?? '' };
  });
}

const watched = `<volume-view src="${fieldUrl}" self-check ${shown}></volume-view>
<script>{
  const view = Object.assign(document.querySelector('volume-view'), { checks: [] });
  view.addEventListener('picture-check', ({ detail }) => view.checks.push(detail));
  view.addEventListener('error', ({ detail }) => (view.code = detail.code));
}</script>`;

newPageTest('a GPU that draws wrong is reported, and the picture stays', async ({ page }) => {
  await page.addInitScript(breakGpu);
  await open(page, watched);
  await expect.poll(async () => (await reported(page)).code).toBe('webgl/inaccurate');
  const { message, checks } = await reported(page);
  expect(message).toMatch(
    /graphics processor .* draws the volume wrong: \d+ of 24 rays .* are off, by up to \d+ of 255/,
  );
  expect(checks[0].agrees).toBe(false);
  expect(checks[0].max).toBeGreaterThan(3);
  // It is a picture all the same: who waits for it gets it.
  const size = await withElement(page, async (element) => {
    await element.whenRendered();
    return (await element.toBlob()).size;
  });
  expect(size).toBeGreaterThan(1000);
  await withElement(page, (element) => (element.selfCheck = false));
  await expect.poll(async () => (await reported(page)).message).toBe('');
});

newPageTest('with self-check each picture at rest is checked, and a good one is no error', async ({ page }) => {
  await open(page, watched);
  await expect.poll(async () => (await reported(page)).checks.length).toBeGreaterThan(0);
  await withElement(page, (element) => {
    (element as unknown as { checks: PictureCheck[] }).checks = [];
    element.cameraOrbit = '120deg 60deg auto';
  });
  await expect.poll(async () => (await reported(page)).checks.length).toBeGreaterThan(0);
  const { checks, code, message } = await reported(page);
  expect(checks.every(({ agrees, off }) => agrees && off === 0)).toBe(true);
  expect(code).toBeUndefined();
  expect(message).toBe('');
});

newPageTest('the page of error against time says whether its device draws right', async ({ page }) => {
  await openDemo(page, 'trade.html', '.trade { grid-template-columns: repeat(3, 200px) !important }');
  await expect(page.locator('#found')).toContainText('differs');
  await page.locator('#check').click();
  await expect(page.locator('#checked')).toContainText(
    /^It is: the largest difference of 24 rays is 0(\.\d+)? of 255\.$/,
  );
});

test('where there is nothing to see there is nothing to check', async ({ page }) => {
  await open(page, `<volume-view src="${mri}" transfer-function="0 #000 0, 255 #fff 0" ${shown}></volume-view>`);
  await settle(page);
  expect(await check(page)).toBe(null);
});
