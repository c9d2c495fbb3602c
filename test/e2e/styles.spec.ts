// X3D's volume nodes as children: pictures, changes without a program more, tags that were not closed, a whole scene moved in.
import { compare, expect, fieldUrl, forgetEvents, open, settle, takePicture, test, waitForEvent, withElement } from './helpers/harness.ts';
import { attributesOf } from './helpers/reference.ts';

const view = (children: string, attributes = `src="${fieldUrl}"`): string => `<volume-view ${attributes} ${attributesOf()} style="width: 60px; height: 45px" alt="A field">${children}</volume-view>`;
const light = '<DirectionalLight direction="0.6 0.5 -0.6"></DirectionalLight>';

test('styles are drawn, and change without a program more; what cannot be read leaves the picture', async ({ page }) => {
  await page.addInitScript(() => {
    const counted = window as unknown as { programs: number };
    counted.programs = 0;
    for (const { prototype } of [WebGLRenderingContext, WebGL2RenderingContext]) {
      const native = prototype.linkProgram;
      prototype.linkProgram = function (program: WebGLProgram) {
        counted.programs++;
        native.call(this, program);
      };
    }
  });
  const countPrograms = (): Promise<number> => page.evaluate(() => (window as unknown as { programs: number }).programs);
  await open(page, view('<ToneMappedVolumeStyle></ToneMappedVolumeStyle>'));
  const tone = await takePicture(page);
  const programs = await countPrograms();
  await page.locator('tonemappedvolumestyle').evaluate((element) => element.setAttribute('warmColor', '0 1 0'));
  const green = await takePicture(page);
  expect(compare(tone, green).worst).toBeGreaterThan(40);
  await page.locator('volume-view').evaluate((element) => (element.innerHTML = '<ComposedVolumeStyle><CartoonVolumeStyle colorSteps="3"/></ComposedVolumeStyle><SilhouetteEnhancementVolumeStyle silhouetteRetainedOpacity="0.2"/>'));
  const cartoon = await takePicture(page);
  expect(compare(cartoon, green).worst).toBeGreaterThan(40);
  expect(await countPrograms(), 'programs').toBe(programs);
  await forgetEvents(page);
  await page.locator('cartoonvolumestyle').evaluate((element) => element.setAttribute('colorSteps', 'many'));
  const { detail } = await waitForEvent(page, 'error');
  expect((detail as { message: string }).message).toBe('colorSteps of CartoonVolumeStyle got "many"; expected a number from 1 to 64.');
  await page.locator('cartoonvolumestyle').evaluate((element) => element.setAttribute('colorSteps', '3'));
  expect(compare(await takePicture(page), cartoon).worst).toBe(0);
  await page.locator('volume-view').evaluate((element) => element.replaceChildren());
  await settle(page);
  expect(await withElement(page, (element) => element.optics!.styles)).toBeUndefined();
});

test('tags that were not closed swallow neither lights nor styles, and a scene of X3DOM\'s can be moved in', async ({ page }) => {
  const styles = '<ShadedVolumeStyle lighting="true"/><EdgeEnhancementVolumeStyle gradientThreshold="1.2"/>';
  await open(page, view(`${styles}${light}`));
  const unclosed = await takePicture(page);
  await page.locator('volume-view').evaluate((element, html) => (element.innerHTML = html), `<ShadedVolumeStyle lighting="true"></ShadedVolumeStyle><EdgeEnhancementVolumeStyle gradientThreshold="1.2"></EdgeEnhancementVolumeStyle>${light}`);
  expect(compare(await takePicture(page), unclosed).worst).toBe(0);
  await page.locator('directionallight').evaluate((element) => element.remove());
  expect(compare(await takePicture(page), unclosed).worst, 'the light shone').toBeGreaterThan(10);
});

test('a scene of X3DOM\'s that is moved in is the volume of its atlas, in its size', async ({ page }) => {
  const scene = `<x3d><scene><viewpoint position="0 0 60" orientation="0 0 1 0"></viewpoint><transform><VolumeData dimensions="4 4 2">
    <ImageTextureAtlas containerField="voxels" url='"/test/e2e/pages/data/field.png"' numberOfSlices="16" slicesOverX="4" slicesOverY="4"></ImageTextureAtlas>
    <OpacityMapVolumeStyle></OpacityMapVolumeStyle></VolumeData></transform></scene></x3d>`;
  await open(page, view(scene, ''));
  await settle(page);
  const { dimensions, spacing, indexToWorld } = await withElement(page, (element) => element.volume!);
  expect([0, 5, 10].map((i) => Math.sign(indexToWorld[i])), 'as X3DOM has it: x to the right of the image, y down').toEqual([1, 1, 1]);
  dimensions.forEach((count, axis) => expect(count * spacing[axis]).toBeCloseTo([4, 4, 2][axis], 3));
  const [orbit, html] = await withElement(page, (element) => [element.cameraOrbit, element.innerHTML]);
  expect(orbit, 'its viewpoint holds').toMatch(/^180deg 0deg /);
  expect(html, 'x3dom has made no scene of its own of it').not.toMatch(/canvas|inline/);
});
