import { expect } from '@esm-bundle/chai';
import { maxSubsteps } from '../../../../src/optics/rays/segment.ts';
import { allSubsteps } from '../../../../src/optics/cells/substeps.ts';
import { stepLengthOf } from '../../../../src/quality/steps.ts';
import { measureError } from '../../../../src/viewer/frames/measure-quality.ts';
import { errorScenes } from '../../../accuracy/error-scenes.ts';
import { changePlan, drawAt } from '../../../helpers/change-plan.ts';
import { compareCovered } from '../../../helpers/covered-error.ts';
import { withScene } from '../../../helpers/picture.ts';
import { readPixels } from '../../../helpers/read-pixels.ts';
import { shapesAmong } from '../../../helpers/shapes-among.ts';
import { probe } from '../../../helpers/probe.ts';

const [width, height] = [120, 90];

const { volume, transferFunction, camera } = errorScenes().find(({ name }) => name.startsWith('shells, smooth'))!;

/** Few: an error far above that of rounding. */
const steps = 16;

describe('the error that a picture with shapes states', () => {
  for (const [kind, children] of Object.entries(shapesAmong(volume.grid))) {
    it(`is within a factor of two of the true one: ${kind}`, async function () {
      this.timeout(120_000);
      await withScene({ children }, (scene) => {
        changePlan(scene, { picture: { width, height } });
        scene.setVolume(volume);
        void scene.setAppearance({
          optics: { transferFunction, referenceLength: 1, opacityFactor: 1, lightFactor: 1 },
        });
        changePlan(scene, { camera });
        changePlan(scene, { substeps: allSubsteps });
        drawAt(scene, stepLengthOf(volume.grid, steps));
        expect(readPixels(scene).some((x) => x > 0)).to.equal(true);
        const stated = measureError(scene, volume.grid, { steps, substeps: maxSubsteps })!;
        // Of the volume's own rays, which end at the shapes, at the picture's steps and at 16 times as many.
        const lattice = { stride: 1, first: [0, 0], width, height } as const;
        const [shown, limit] = probe(
          scene,
          [steps, 16 * steps].map((n) => stepLengthOf(volume.grid, n)),
          lattice,
          { width, height },
        )!;
        const known = Math.hypot(compareCovered(shown, limit, 255).rms, rounding);
        console.log(
          `${kind}: stated ${stated.rms.toFixed(2)}, order ${stated.order.toFixed(2)}, true ${known.toFixed(2)}`,
        );
        expect(stated.rms / known).to.be.within(0.5, 2);
      });
    });
  }
});

/** Of 8 bits, which the probes' floats do not have: RMS, 1/255. */
const rounding = 1 / Math.sqrt(12);
