import { expect } from '@esm-bundle/chai';
import { listFunctions, studyScenes } from '../../../../demos/accuracy/scenes.ts';
import type { StudyScene } from '../../../../demos/accuracy/scenes.ts';
import { defaultRays, defaultReferenceLength } from '../../../../demos/accuracy/study-view.ts';
import { emission } from '../../../../src/optics/transfer/emission.ts';
import { interpolate } from '../../../../src/optics/rays/interpolate.ts';
import { intersectUnitCube, rayThrough } from '../../../../src/optics/rays/rays.ts';
import type { Ray, RaySetup } from '../../../../src/optics/rays/rays.ts';
import { countSteps } from '../../../../src/optics/rays/count-steps.ts';
import { castSceneRay, opticsOf } from '../../../../src/optics/reference.ts';
import type { ReferenceScene } from '../../../../src/optics/reference.ts';
import { attenuate, composite } from '../../../../src/optics/rays/segment.ts';
import type { Premultiplied } from '../../../../src/optics/transfer/transfer-function.ts';
import { autoSteps, stepLengthOf } from '../../../../src/quality/steps.ts';
import { add, scale } from '../../../../src/volume/matrix.ts';
import type { Volume } from '../../../../src/volume/volume.ts';
import { decodeBytes, fetchFile } from '../../../helpers/decode.ts';
import { fetchSharedData } from '../../../helpers/shared-data.ts';
import { randomNumbers } from '../../../helpers/synthetic.ts';

/** Rays that meet the volume, at random over the picture. */
const raysPerScene = 150;

/** Samples a step of what stands for the limit. */
const samplesOfLimit = 48;

/** Samples at points: the middle of each step, the transfer function there. It shares no segment and no mean with castRay. */
function samplePoints(scene: ReferenceScene, setup: RaySetup, ray: Ray, samplesPerStep: number): Premultiplied {
  const [entry, exit] = intersectUnitCube(ray.point, ray.direction);
  const total = (exit - entry) * ray.lengthPerT;
  const count = countSteps(total, scene.stepLength / setup.diameter) * samplesPerStep;
  const ratio = (total * setup.diameter) / scene.referenceLength / count;
  const accumulated: Premultiplied = [0, 0, 0, 0];
  for (let i = 0; i < count && accumulated[3] < 0.9999; i++) {
    const t = entry + ((i + 0.5) / count) * (exit - entry);
    const stored = interpolate(scene.samples, scene.grid.dimensions, add(ray.point, scale(ray.direction, t)));
    composite(accumulated, attenuate(emission(scene.transferFunction, scene.slope * stored + scene.intercept), ratio));
  }
  return accumulated;
}

/** Errors of one sample a voxel, root mean square, 1/255: ours, and plain samples. */
function measure(
  volume: Volume,
  transferFunction: ReferenceScene['transferFunction'],
): { ours: number; plain: number } {
  const setup = defaultRays(volume);
  const scene: ReferenceScene = {
    ...volume,
    transferFunction,
    referenceLength: defaultReferenceLength(volume),
    opacityFactor: 1,
    lightFactor: 1,
    stepLength: stepLengthOf(volume.grid, autoSteps(volume.grid)),
  };
  const optics = opticsOf(scene);
  const random = randomNumbers(97);
  const sums = { ours: 0, plain: 0 };
  for (let met = 0; met < raysPerScene;) {
    const ray = rayThrough(setup, random() * 2 - 1, random() * 2 - 1);
    const [entry, exit] = intersectUnitCube(ray.point, ray.direction);
    if (!(exit > entry)) continue;
    met++;
    const limit = samplePoints(scene, setup, ray, samplesOfLimit);
    const pictures = { ours: castSceneRay(scene, setup, ray, optics), plain: samplePoints(scene, setup, ray, 1) };
    for (const by of ['ours', 'plain'] as const) {
      for (let c = 0; c < 4; c++) sums[by] += (255 * (pictures[by][c] - limit[c])) ** 2;
    }
  }
  const rms = (sum: number): number => Math.sqrt(sum / (4 * raysPerScene));
  return { ours: rms(sums.ours), plain: rms(sums.plain) };
}

async function fetchScene(context: Mocha.Context, scene: StudyScene): Promise<Volume> {
  const shared = scene.url.match(/^\/shared-data\/(.*)/);
  const bytes = shared ? new Uint8Array(await fetchSharedData(context, shared[1])) : await fetchFile(scene.url);
  return decodeBytes(bytes, scene.url, scene.mosaic);
}

describe('one sample a voxel', () => {
  for (const scene of studyScenes) {
    it(`keeps 1/255 with smooth functions and 2/255 with peaks of 1 %: ${scene.name}`, async function () {
      this.timeout(120_000);
      const volume = await fetchScene(this, scene);
      const functions = await listFunctions(scene, volume);
      for (const { id, transferFunction } of functions.filter((f) => f.id !== 'step')) {
        const { ours, plain } = measure(volume, transferFunction);
        console.log(`${scene.name}, ${id}: ${ours.toFixed(2)} of 255, plain samples ${plain.toFixed(2)}`);
        expect(ours, id).to.be.below(id === 'smooth' ? 1 : 2);
        // Where the target is met easily, plain samples may be as good; but they miss narrow peaks.
        if (id === 'peaks') expect(plain, id).to.be.above(5 * ours);
      }
    });
  }
});
