// gradient-opacity="gradient factor, ...": what is even inside becomes clear, and its boundaries stay.
import { domainOf } from '../../src/optics/transfer/emission.ts';
import { cartesianGradient, flatChange } from '../../src/optics/rays/gradient.ts';
import { pointField } from '../../src/optics/rays/lit.ts';
import { cartesianField } from '../../src/optics/rays/ray-field.ts';
import { setUpRays } from '../../src/optics/rays/rays.ts';
import { projectionMatrix, viewMatrix } from '../../src/optics/rays/camera.ts';
import { renderReference } from '../../src/optics/reference.ts';
import { styledShade } from '../../src/optics/rays/styled.ts';
import type { TransferFunction } from '../../src/optics/transfer/transfer-function.ts';
import type { GradientStop } from '../../src/optics/transfer/volume-styles.ts';
import { longestDiagonal } from '../../src/volume/grid.ts';
import { niftiBytes } from '../helpers/nifti-bytes.ts';
import { syntheticVolume } from '../helpers/synthetic.ts';
import {
  compare,
  expect,
  expectSamePicture,
  open,
  setAttributes,
  takePicture,
  takeScreenshot,
  keptTest as test,
  waitForEvent,
  withElement,
} from './helpers/harness.ts';
import type { Picture } from './helpers/pictures.ts';
import { attributesOf, plainCamera } from './helpers/reference.ts';
import { serveFiles } from './helpers/served-files.ts';

const [width, height] = [60, 45];
const folder = '/test/e2e/pages/data/even';

/** A ball of 1 inside, with a wall of 4 voxels of a millimetre: values fall by a quarter a millimetre there. */
const ball = syntheticVolume({
  dimensions: [32, 32, 32],
  field: (x, y, z) => Math.min(1, Math.max(0, (14 - 32 * Math.hypot(x - 0.5, y - 0.5, z - 0.5)) / 4)),
});
const transferFunction: TransferFunction = [
  { value: 0.1, color: [1, 1, 1], opacity: 0 },
  { value: 1, color: [1, 1, 1], opacity: 0.2 },
];
const view = `<volume-view src="${folder}/ball.nii" ${attributesOf({ 'transfer-function': '0.1 white 0, 1 white 20%', steps: '60' })} style="width: ${width}px; height: ${height}px" alt="A ball"></volume-view>`;

/** What the element should show. */
function drawBall(stops: readonly GradientStop[]): Picture {
  const { grid } = ball;
  const rays = setUpRays(
    grid,
    viewMatrix(plainCamera),
    projectionMatrix(plainCamera.fieldOfView, width / height, 1, 2),
  )!;
  const gradient = cartesianGradient(cartesianField({ ...ball, dimensions: grid.dimensions }), grid);
  const flat = flatChange(domainOf(transferFunction), ball.range);
  const shade = styledShade({
    grid,
    gradient,
    flat,
    chains: [{ weight: 1, styles: [{ kind: 'gradient', stops }] }],
    referenceLength: 1,
    opticalScale: rays.diameter,
  });
  const optics = { transferFunction, referenceLength: 1, opacityFactor: 1, lightFactor: 1 };
  const scene = {
    ...ball,
    ...optics,
    stepLength: longestDiagonal(grid) / 60,
    moreFields: [pointField],
    shades: [shade],
  };
  return { width, height, data: renderReference(scene, rays, width, height).map((x) => x * 255) };
}

/** Opacities from the middle of the picture to its right edge. */
const row = ({ data }: Picture): readonly number[] =>
  Array.from({ length: width / 2 }, (_, x) => data[((height >> 1) * width + width / 2 + x) * 4 + 3] / 255);

test('the even inside becomes clear, and its wall stays; what cannot be read is reported, and leaves the picture', async ({
  page,
}) => {
  await serveFiles(page, folder, { 'ball.nii': Buffer.from(niftiBytes(ball)) });
  await open(page, view, { head: '<style>volume-view::part(error) { visibility: hidden }</style>' });
  const plain = await takePicture(page);
  await setAttributes(page, { 'gradient-opacity': '0.05 0, 0.2 1' });
  const walls = await takePicture(page);
  expectSamePicture(
    walls,
    drawBall([
      [0.05, 0],
      [0.2, 1],
    ]),
  );
  const [before, after] = [row(plain), row(walls)];
  const rim = after.indexOf(Math.max(...after));
  expect(before[0], 'the middle').toBeGreaterThan(0.95);
  expect(after[0]).toBeLessThan(0.7 * before[0]);
  expect(rim, 'the wall is seen from its side at the rim').toBeGreaterThan(5);
  expect(after[rim]).toBeGreaterThan(0.85 * before[rim]);

  const shown = await takeScreenshot(page);
  await withElement(page, (element) => element.setAttribute('gradient-opacity', '0.05 0, steep 1'));
  expect((await waitForEvent(page, 'error')).detail).toEqual({
    code: 'attribute/invalid',
    message:
      'gradient-opacity: stop 2, "steep 1", got the gradient "steep"; expected a number from 0 on, in data units per world unit, or a percentage of the window along a reference length.',
  });
  await expect(page.locator('volume-view .error')).toContainText('gradient-opacity: stop 2');
  expect(
    await withElement(page, (element) => element.whenRendered().catch((error: { code: string }) => error.code)),
  ).toBe('attribute/invalid');
  expect(compare(await takeScreenshot(page), shown).worst, 'the last picture stays').toBe(0);
  await setAttributes(page, { 'gradient-opacity': null });
  await expect(page.locator('volume-view .error')).toHaveCount(0);
  expect(compare(await takePicture(page), plain).worst).toBe(0);
});
