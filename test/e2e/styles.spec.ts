// X3D's volume nodes as children: pictures, changes without a program more, tags that were not closed, a whole scene moved in.
import { encode } from 'fast-png';
import type { Volume } from '../../src/volume/volume.ts';
import { niftiBytes } from '../helpers/nifti-bytes.ts';
import { syntheticVolume } from '../helpers/synthetic.ts';
import { mosaicTiles } from './helpers/data.ts';
import {
  compare,
  expect,
  fieldUrl,
  forgetEvents,
  open,
  settle,
  takePicture,
  test,
  waitForEvent,
  withElement,
} from './helpers/harness.ts';
import { meanOf } from './helpers/pictures.ts';
import type { Picture } from './helpers/pictures.ts';
import { attributesOf } from './helpers/reference.ts';
import { serveFiles } from './helpers/served-files.ts';
import { field } from './helpers/volumes.ts';

const view = (children: string, attributes = `src="${fieldUrl}"`): string =>
  `<volume-view ${attributes} ${attributesOf()} style="width: 60px; height: 45px" alt="A field">${children}</volume-view>`;
const light = '<DirectionalLight direction="0.6 0.5 -0.6"></DirectionalLight>';

test('styles are drawn, and change without a program more; what cannot be read leaves the picture', async ({
  page,
}) => {
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
  const countPrograms = (): Promise<number> =>
    page.evaluate(() => (window as unknown as { programs: number }).programs);
  await open(page, view('<ToneMappedVolumeStyle></ToneMappedVolumeStyle>'));
  const tone = await takePicture(page);
  const programs = await countPrograms();
  await page.locator('tonemappedvolumestyle').evaluate((element) => element.setAttribute('warmColor', '0 1 0'));
  const green = await takePicture(page);
  expect(compare(tone, green).worst).toBeGreaterThan(40);
  await page
    .locator('volume-view')
    .evaluate(
      (element) =>
        (element.innerHTML =
          '<ComposedVolumeStyle><CartoonVolumeStyle colorSteps="3"/></ComposedVolumeStyle><SilhouetteEnhancementVolumeStyle silhouetteRetainedOpacity="0.2"/>'),
    );
  const cartoon = await takePicture(page);
  expect(compare(cartoon, green).worst).toBeGreaterThan(40);
  expect(await countPrograms(), 'programs').toBe(programs);
  await forgetEvents(page);
  await page.locator('cartoonvolumestyle').evaluate((element) => element.setAttribute('colorSteps', 'many'));
  const { detail } = await waitForEvent(page, 'error');
  expect((detail as { message: string }).message).toBe(
    'colorSteps of CartoonVolumeStyle got "many"; expected a number from 1 to 64.',
  );
  await page.locator('cartoonvolumestyle').evaluate((element) => element.setAttribute('colorSteps', '3'));
  expect(compare(await takePicture(page), cartoon).worst).toBe(0);
  await page.locator('volume-view').evaluate((element) => element.replaceChildren());
  await settle(page);
  expect(await withElement(page, (element) => element.optics!.styles)).toBeUndefined();
});

test("tags that were not closed swallow neither lights nor styles, and a scene of X3DOM's can be moved in", async ({
  page,
}) => {
  const styles = '<ShadedVolumeStyle lighting="true"/><EdgeEnhancementVolumeStyle gradientThreshold="1.2"/>';
  await open(page, view(`${styles}${light}`));
  const unclosed = await takePicture(page);
  await page
    .locator('volume-view')
    .evaluate(
      (element, html) => (element.innerHTML = html),
      `<ShadedVolumeStyle lighting="true"></ShadedVolumeStyle><EdgeEnhancementVolumeStyle gradientThreshold="1.2"></EdgeEnhancementVolumeStyle>${light}`,
    );
  expect(compare(await takePicture(page), unclosed).worst).toBe(0);
  await page.locator('directionallight').evaluate((element) => element.remove());
  expect(compare(await takePicture(page), unclosed).worst, 'the light shone').toBeGreaterThan(10);
});

test("a scene of X3DOM's that is moved in is the volume of its atlas, in its size", async ({ page }) => {
  const scene = `<x3d><scene><viewpoint position="0 0 60" orientation="0 0 1 0"></viewpoint><transform><VolumeData dimensions="4 4 2">
    <ImageTextureAtlas containerField="voxels" url='"/test/e2e/pages/data/field.png"' numberOfSlices="16" slicesOverX="4" slicesOverY="4"></ImageTextureAtlas>
    <OpacityMapVolumeStyle></OpacityMapVolumeStyle></VolumeData></transform></scene></x3d>`;
  await open(page, view(scene, ''));
  await settle(page);
  const { dimensions, spacing, indexToWorld } = await withElement(page, (element) => element.volume!);
  expect(
    [0, 5, 10].map((i) => Math.sign(indexToWorld[i])),
    'as X3DOM has it: x to the right of the image, y down',
  ).toEqual([1, 1, 1]);
  dimensions.forEach((count, axis) => expect(count * spacing[axis]).toBeCloseTo([4, 4, 2][axis], 3));
  const [orbit, html] = await withElement(page, (element) => [element.cameraOrbit, element.innerHTML]);
  expect(orbit, 'its viewpoint holds').toMatch(/^180deg 0deg /);
  expect(html, 'x3dom has made no scene of its own of it').not.toMatch(/canvas|inline/);
});

const shaded = (material: string, lighting = true): string =>
  `<ShadedVolumeStyle lighting="${lighting}"><Material ${material}></Material></ShadedVolumeStyle>`;
const surfaces = (fields: string, inside: string): string =>
  `<IsoSurfaceVolumeData ${fields}>${inside}</IsoSurfaceVolumeData>`;
/** Without fog, or with one that nobody sees: a transfer function says what counts as flat, and has to be the same in both. */
const fogless = (html: string, fog: string | null = null): string =>
  html.replace(/ transfer-function="[^"]*"/, fog === null ? '' : ` transfer-function="${fog}"`);
const valued = (values: string, more = ''): string => view('', `src="${fieldUrl}" surface-values="${values}" ${more}`);

for (const [what, node, attribute] of [
  [
    'with a material for each',
    fogless(
      view(
        surfaces(
          'surfaceValues="0.6 0.4"',
          shaded('diffuseColor="0 1 0"') + shaded('diffuseColor="1 0 0" transparency="0.6"'),
        ),
      ),
    ),
    fogless(valued('0.4 red 40%, 0.6 lime')),
  ],
  [
    'in colours of the transfer function',
    view(surfaces('surfaceValues="0.4"', '')),
    fogless(valued('0.4 #c63'), '0.15 #003 0, 0.4 #c63 0, 0.8 #ffc 0'),
  ],
  [
    'repeated, without light',
    fogless(
      view(
        surfaces(
          'surfaceValues="0.5" contourStepSize="0.25"',
          shaded('diffuseColor="0 0 1" transparency="0.5"', false),
        ),
        `src="${fieldUrl}" value-window="0.2 0.8"`,
      ),
    ),
    fogless(valued('0.25 blue 50%, 0.5 blue 50%, 0.75 blue 50%', 'value-window="0.2 0.8" shading="unlit"')),
  ],
] as const) {
  test(`IsoSurfaceVolumeData ${what}: the picture is that of surface-values`, async ({ page }) => {
    await open(page, attribute);
    const expected = await takePicture(page);
    expect(meanOf(expected)[3], 'surfaces are seen').toBeGreaterThan(20);
    await open(page, node);
    expect(compare(await takePicture(page), expected).worst).toBe(0);
    await page.locator('isosurfacevolumedata').evaluate((element) => element.setAttribute('surfaceValues', '0.7'));
    expect(compare(await takePicture(page), expected).worst, 'another value').toBeGreaterThan(40);
  });
}

/** Four parts of the field's voxels, of which no two have the same shape. */
const parts: Volume = {
  ...syntheticVolume({
    dimensions: field.grid.dimensions,
    field: (x, y, z) => (x < 0.4 ? 0 : y < 0.5 ? 1 : z < 0.6 ? 2 : 3) / 255,
  }),
  grid: field.grid,
  slope: 1,
  intercept: 0,
};

/** Their numbers as an image of slices, as the field's own image has them. */
function tileParts(): Uint8Array {
  const [nx, ny, nz] = field.grid.dimensions;
  const data = new Uint8Array(nx * ny * nz);
  for (let row = 0; row < ny * nz; row++) {
    const slice = Math.floor(row / ny);
    const tileRow = Math.floor(slice / mosaicTiles) * ny + (row % ny);
    data.set(parts.samples.subarray(row * nx, (row + 1) * nx), (tileRow * mosaicTiles + (slice % mosaicTiles)) * nx);
  }
  return encode({ width: nx * mosaicTiles, height: ny * mosaicTiles, data, channels: 1, depth: 8 });
}

test('SegmentedVolumeData: the picture is that of labels that look like its segments, and follows segmentEnabled', async ({
  page,
}) => {
  const folder = '/test/e2e/pages/data/parts';
  await serveFiles(page, folder, {
    'parts.nii': Buffer.from(niftiBytes(parts)),
    'parts.png': Buffer.from(tileParts()),
  });
  /** Segment 1 has a texture of its own. */
  const segments = view(`<SegmentedVolumeData>
    <ImageTextureAtlas containerField="segmentIdentifiers" url="${folder}/parts.png" slicesOverX="${mosaicTiles}" slicesOverY="${mosaicTiles}"></ImageTextureAtlas>
    <OpacityMapVolumeStyle></OpacityMapVolumeStyle>
    <OpacityMapVolumeStyle><PixelTexture image="3 1 4 0x00FF0000 0x00FF0033 0x0000FF66"></PixelTexture></OpacityMapVolumeStyle>
  </SegmentedVolumeData>`);
  const labels = view(`<volume-labels src="${folder}/parts.nii">
    <volume-label value="1" transfer-function="0% lime 0, 50% lime 20%, 100% blue 40%"></volume-label>
    ${[0, 2, 3].map((id) => `<volume-label value="${id}" color="white"></volume-label>`).join('')}</volume-labels>`);
  await open(page, labels);
  await expect
    .poll(() =>
      page.locator('volume-labels').evaluate((one: HTMLElementTagNameMap['volume-labels']) => one.labels?.length),
    )
    .toBe(4);
  const pictures: Picture[] = [];
  for (const hidden of [[], [2], [0, 1]]) {
    await page
      .locator('volume-labels')
      .evaluate((one: HTMLElementTagNameMap['volume-labels'], ids) => (one.hiddenLabels = ids), hidden);
    pictures.push(await takePicture(page));
  }
  pictures.forEach((one, i) =>
    expect(compare(one, pictures[(i + 1) % 3]).worst, 'what is hidden, and another colour, are seen').toBeGreaterThan(
      40,
    ),
  );
  await open(page, segments);
  expect(compare(await takePicture(page), pictures[0]).worst, 'all').toBe(0);
  for (const [enabled, expected] of [
    ['true true false', 1],
    ['false false', 2],
    ['', 0],
  ] as const) {
    await page
      .locator('segmentedvolumedata')
      .evaluate((element, text) => element.setAttribute('segmentEnabled', text), enabled);
    expect(compare(await takePicture(page), pictures[expected]).worst, enabled).toBe(0);
  }
});
