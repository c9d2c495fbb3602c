import { expect } from '@esm-bundle/chai';
import { minSubsteps } from '../../../src/optics/cells/min-substeps.ts';
import { orbitCamera, projectionMatrix, viewMatrix } from '../../../src/optics/rays/camera.ts';
import { parseTransferFunction } from '../../../src/optics/transfer/parse-transfer-function.ts';
import { setUpRays } from '../../../src/optics/rays/rays.ts';
import { renderReference } from '../../../src/optics/reference.ts';
import { allSubsteps } from '../../../src/optics/cells/substeps.ts';
import type { Substeps } from '../../../src/optics/cells/substeps.ts';
import { longSteps } from '../../../src/renderer/ray/long-steps.ts';
import { cutsOfLevels } from '../../../src/quality/levels.ts';
import { autoSteps, stepLengthOf } from '../../../src/quality/steps.ts';
import { boundingSphere } from '../../../src/volume/grid.ts';
import { changePlan, drawAt } from '../../helpers/change-plan.ts';
import { comparePictures, withScene } from '../../helpers/picture.ts';
import { randomNumbers, syntheticVolume } from '../../helpers/synthetic.ts';
import { readPixels } from '../../helpers/read-pixels.ts';

const [width, height] = [60, 45];

/** Specks of one voxel in a faint gradient. */
function specks(): ReturnType<typeof syntheticVolume> {
  const random = randomNumbers(21);
  return syntheticVolume({
    dimensions: [40, 36, 30],
    field: (x, y) => (random() < 0.002 ? 0.2 + 0.8 * y : 0.1 + 0.1 * x),
  });
}

/** How cells cut the steps of a picture. */
const cases = [
  { name: 'as finely as they need', maxError: 1, looks: '0 #246 0, 0.4 #246 1%, 1 #fff 90%', wanted: [0, 3] },
  // Four and two voxels a step where a thing can't make more of a difference than it may, and one voxel elsewhere.
  { name: 'as coarsely as they may', maxError: 8, looks: '0 #246 0, 0.4 #246 1%, 1 #fff 60%', wanted: [0, 4, 8] },
];

describe('cells that are sampled', () => {
  for (const { name, maxError, looks, wanted } of cases)
    for (const webgl2 of [true, false]) {
      it(`${name} give the reference's picture, and another than without: WebGL ${webgl2 ? 2 : 1}`, () =>
        withScene({ webgl1: !webgl2 }, async (scene) => {
          const volume = specks();
          const transferFunction = parseTransferFunction(looks, [0, 1]);
          const { center, radius } = boundingSphere(volume.grid);
          const camera = orbitCamera({ theta: 0.7, phi: 1.1, radius: 3 * radius }, center, 0.6);
          const optics = { transferFunction, referenceLength: 1, opacityFactor: 1, lightFactor: 1 };
          const oneAVoxel = autoSteps(volume.grid);
          const stepLength = stepLengthOf(volume.grid, oneAVoxel);
          changePlan(scene, { picture: { width, height } });
          scene.setVolume(volume);
          await scene.setAppearance({ optics });
          changePlan(scene, { camera });
          const draw = (substeps: Substeps): Uint8ClampedArray => {
            changePlan(scene, { substeps });
            drawAt(scene, stepLength);
            return readPixels(scene);
          };
          const coarse = draw({ ...allSubsteps, max: 1 });
          const cut = cutsOfLevels(oneAVoxel, maxError, longSteps).own({ steps: oneAVoxel, substeps: 1 });
          const fine = draw(cut);
          const codes = scene.detail()!;
          expect([...new Set(codes)], 'cells differ').to.include.members(wanted);
          const rays = setUpRays(
            volume.grid,
            viewMatrix(camera),
            projectionMatrix(camera.fieldOfView, width / height, 1, 2),
          )!;
          const reference = renderReference(
            {
              ...volume,
              ...optics,
              stepLength,
              maxSubsteps: 1,
              minSubsteps: minSubsteps(volume, codes, cut.voxelsPerStep),
            },
            rays,
            width,
            height,
          );
          const { worst } = comparePictures(
            fine,
            Uint8ClampedArray.from(reference, (x) => Math.round(x * 255)),
          );
          expect(worst).to.be.at.most(2);
          expect(comparePictures(coarse, fine).worst).to.be.above(maxError === 1 ? 10 : 2);
          scene.layers[0].skipping = false;
          expect(comparePictures(draw(cut), fine).worst, 'skipping changes nothing').to.equal(0);
        }));
    }
});
