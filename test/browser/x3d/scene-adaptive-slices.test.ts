// Slices in a picture whose pixels do not all get rays: no more than was foretold is lost, and thin ones have no gaps.
import { expect } from '@esm-bundle/chai';
import { orbitCamera } from '../../../src/optics/rays/camera.ts';
import type { Camera } from '../../../src/optics/rays/camera.ts';
import { forecastSampling } from '../../../src/quality/adaptive-sampling.ts';
import { atOnce } from '../../../src/core/waiting.ts';
import { stepLengthOf } from '../../../src/quality/steps.ts';
import type { RayCut } from '../../../src/renderer/ray/ray-module.ts';
import type { Slice } from '../../../src/radar/slices.ts';
import { readPlanes } from '../../../src/viewer/cuts/read-planes.ts';
import { add, cross, dot, normalize, scale, subtract } from '../../../src/volume/matrix.ts';
import { boundingSphere } from '../../../src/volume/grid.ts';
import { isPolar } from '../../../src/volume/volume.ts';
import type { Volume } from '../../../src/volume/volume.ts';
import type { VolumeScene } from '../../../src/x3d/scene.ts';
import { changePlan, drawAt } from '../../helpers/change-plan.ts';
import { comparePictures, shareScene } from '../../helpers/picture.ts';
import { readPixels } from '../../helpers/read-pixels.ts';
import { evenAzimuths, radarVolume } from '../../helpers/synthetic-radar.ts';
import { syntheticVolume } from '../../helpers/synthetic.ts';

const size = { width: 151, height: 113 };
const cartesian = syntheticVolume({ dimensions: [40, 36, 30], spacing: [1, 1, 1] });
const storm = radarVolume(
  {
    sweeps: [0.5, 2, 5, 10, 20].map((elevation) => ({
      elevation,
      gates: 60,
      azimuths: evenAzimuths(72),
      stored: (azimuth, gate) => Math.round(130 + 60 * Math.sin((azimuth * Math.PI) / 60) + 50 * Math.sin(gate / 9)),
    })),
  },
  { verticalExaggeration: 3 },
);

function planesOf(html: string, volume: Volume): readonly RayCut[] {
  const host = document.createElement('div');
  host.innerHTML = html;
  return readPlanes([...host.children], volume, [0, 1]).cuts;
}

const seen = (volume: Volume, phi: number): Camera => {
  const { center, radius } = boundingSphere(volume.grid);
  return orbitCamera({ theta: 0.6, phi, radius: 2.4 * radius }, center, 0.8);
};

/** Draws the same view with a limit to the curvature; 0: with all rays. */
async function show(
  scene: VolumeScene,
  volume: Volume,
  { slices = [], cuts = [], camera }: { slices?: readonly Slice[]; cuts?: readonly RayCut[]; camera: Camera },
): Promise<(maxCurvature: number) => Uint8ClampedArray> {
  changePlan(scene, { picture: size });
  await scene.prepare(volume);
  scene.setVolume(volume);
  await scene.setAppearance({
    optics: {
      transferFunction: isPolar(volume)
        ? [
            { value: 0, color: [0.1, 0.3, 1], opacity: 0 },
            { value: 70, color: [1, 0.4, 0.1], opacity: 0.3 },
          ]
        : [
            { value: 0.2, color: [0, 0, 0.4], opacity: 0 },
            { value: 0.8, color: [1, 1, 0.8], opacity: 0.05 },
          ],
      referenceLength: boundingSphere(volume.grid).radius / 20,
      opacityFactor: 1,
      lightFactor: 1,
    },
  });
  changePlan(scene, { slices, cuts });
  changePlan(scene, { camera });
  return (maxCurvature) => {
    changePlan(scene, { maxCurvature, edgeCurvature: Infinity });
    drawAt(scene, stepLengthOf(volume.grid, 60));
    return readPixels(scene);
  };
}

for (const webgl1 of [false, true]) {
  describe(`slices where rays are spared, WebGL ${webgl1 ? 1 : 2}`, function () {
    this.timeout(120_000);
    const scene = shareScene({ webgl1 });
    const three = ['axial', 'coronal', 'sagittal']
      .map((type) => `<volume-slice type="${type}"></volume-slice>`)
      .join('');
    const cases = [
      { name: 'planes', volume: cartesian, cuts: planesOf(three, cartesian) },
      {
        name: "a radar's level and upright ones",
        volume: storm,
        slices: [
          { kind: 'level', height: 3000 },
          { kind: 'upright', from: [0, 0], direction: [0.6, 0.8], length: Infinity },
        ] as const,
      },
    ];

    for (const { name, volume, ...cutting } of cases) {
      it(`are off by no more than was predicted: ${name}`, async () => {
        const draw = await show(scene(), volume, { ...cutting, camera: seen(volume, 1.1) });
        const all = draw(0);
        expect(scene().adaptive).to.equal(true);
        const [outcomes] = atOnce(forecastSampling(scene().readPicture(), [1], null));
        const foretold = outcomes.filter(({ error }) => error <= 0.5).at(-1)!;
        expect(foretold.share, 'rays are spared').to.be.below(0.95);
        const adaptive = draw(foretold.maxCurvature);
        const { rmse } = comparePictures(adaptive, all);
        expect(rmse, `curvature ${foretold.maxCurvature}`).to.be.within(0.02, 2 * foretold.error + 0.2);
        expect(comparePictures(draw(0), all).worst, 'afterwards').to.equal(0);
      });
    }
  });
}

describe('a slice that is seen from its side', function () {
  this.timeout(120_000);
  const scene = shareScene({});

  it('has no gaps even where all other pixels are interpolated', async () => {
    const { center } = boundingSphere(cartesian.grid);
    const camera = seen(cartesian, 1.1);
    const toEye = normalize(subtract(camera.eye, center));
    const across = normalize(cross(toEye, [0, 0, 1]));
    // The eye lies next to the plane, whose picture is a slanting line two pixels wide.
    const normal = add(add(scale(across, 0.5), scale(cross(across, toEye), 0.8)), scale(toEye, 0.018));
    const cuts = planesOf(
      `<volume-slice type="oblique" normal="${normal.join(' ')}" at="${dot(normalize(normal), center)}"></volume-slice>`,
      cartesian,
    );
    const draw = await show(scene(), cartesian, { cuts, camera });
    const [all, adaptive] = [0, 256].map(draw);
    const isOnPlane = (pixel: number): boolean => all[4 * pixel + 3] > 250;
    const pixels = Array.from({ length: size.width * size.height }, (_, pixel) => pixel);
    expect(pixels.filter(isOnPlane).length).to.be.within(40, 400);
    expect(comparePictures(adaptive, all, (pixel) => !isOnPlane(pixel)).worst).to.equal(0);
  });

  it('is drawn with all rays where it is a cone, whose edge is not known', async () => {
    await show(scene(), storm, { slices: [{ kind: 'cone', sweep: 0 }], camera: seen(storm, 1.1) });
    expect(scene().adaptive).to.equal(false);
  });
});
