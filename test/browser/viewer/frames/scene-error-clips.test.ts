// The error that pictures of cut volumes state, and what sparing rays does to them.
import { expect } from '@esm-bundle/chai';
import { orbitCamera } from '../../../../src/optics/rays/camera.ts';
import { maxSubsteps } from '../../../../src/optics/rays/segment.ts';
import { allSubsteps } from '../../../../src/optics/cells/substeps.ts';
import { forecastSampling } from '../../../../src/quality/adaptive-sampling.ts';
import { atOnce } from '../../../../src/core/waiting.ts';
import { stepLengthOf } from '../../../../src/quality/steps.ts';
import { createClip } from '../../../../src/renderer/ray/modules/clip.ts';
import { createCutout } from '../../../../src/renderer/ray/modules/cutout.ts';
import type { RayCut } from '../../../../src/renderer/ray/ray-module.ts';
import { measureError } from '../../../../src/viewer/frames/measure-quality.ts';
import { longestDiagonal } from '../../../../src/volume/grid.ts';
import type { VolumeScene } from '../../../../src/x3d/scene.ts';
import { errorScenes } from '../../../accuracy/error-scenes.ts';
import { changePlan, drawAt } from '../../../helpers/change-plan.ts';
import { compareCovered } from '../../../helpers/covered-error.ts';
import { cutBox, keep } from '../../../helpers/clips.ts';
import { comparePictures, shareScene } from '../../../helpers/picture.ts';
import { readPixels } from '../../../helpers/read-pixels.ts';
import { probe } from '../../../helpers/probe.ts';

const size = { width: 151, height: 113 };
const shells = errorScenes().find(({ name }) => name.startsWith('shells, smooth'))!;
const { volume } = shells;
const { grid } = volume;
const reach = longestDiagonal(grid);

/** What is seen of shells that are all but opaque: faces of cuts. */
const dense = shells.transferFunction.map((stop) => ({ ...stop, opacity: Math.min(0.95, 8 * stop.opacity) }));

const cuts: Record<string, readonly RayCut[]> = {
  'two planes': [
    { create: createClip, items: [keep(grid, [0.3, 1, 0.2], 0), keep(grid, [-1, 0.2, -0.4], -0.1 * reach)] },
  ],
  'a corner cut out': [
    { create: createCutout, items: [cutBox(grid, [-0.02 * reach, 0.01 * reach, 0], [reach, reach, reach])] },
  ],
  'a hole in the middle': [
    {
      create: createCutout,
      items: [cutBox(grid, [-0.15 * reach, -0.1 * reach, -0.12 * reach], [0.1 * reach, 0.12 * reach, 0.15 * reach])],
    },
  ],
};

/** Of 8 bits, which the probes' floats do not have: RMS, 1/255. */
const rounding = 1 / Math.sqrt(12);

describe('a volume that is cut', function () {
  this.timeout(120_000);
  const shared = shareScene({});

  const show = (name: string, transferFunction = shells.transferFunction): VolumeScene => {
    const scene = shared();
    changePlan(scene, { picture: size });
    scene.setVolume(volume);
    void scene.setAppearance({ optics: { transferFunction, referenceLength: 1, opacityFactor: 1, lightFactor: 1 } });
    changePlan(scene, { slices: [], cuts: cuts[name] });
    changePlan(scene, { camera: orbitCamera({ theta: 0.7, phi: 1, radius: 1.6 * reach }, [0, 0, 0], 0.6) });
    changePlan(scene, { substeps: allSubsteps });
    changePlan(scene, { maxCurvature: 0, edgeCurvature: Infinity });
    return scene;
  };

  for (const [name, steps] of [
    ['two planes', 14],
    ['a corner cut out', 12],
    ['a hole in the middle', 12],
  ] as const) {
    it(`states an error within a factor of two of the true one: ${name}`, () => {
      const scene = show(name);
      drawAt(scene, stepLengthOf(grid, steps));
      const stated = measureError(scene, grid, { steps, substeps: maxSubsteps })!;
      const [shown, limit] = probe(
        scene,
        [steps, 16 * steps].map((n) => stepLengthOf(grid, n)),
        { stride: 1, first: [0, 0], ...size },
        size,
      )!;
      const known = Math.hypot(compareCovered(shown, limit, 255).rms, rounding);
      console.log(
        `${name}: stated ${stated.rms.toFixed(2)}, order ${stated.order.toFixed(2)}, true ${known.toFixed(2)}`,
      );
      expect(known).to.be.above(0.4);
      expect(stated.rms / known).to.be.within(0.5, 2);
    });

    it(`is off by no more than was predicted where rays are spared: ${name}`, () => {
      const scene = show(name, dense);
      const draw = (maxCurvature: number): Uint8ClampedArray => {
        changePlan(scene, { maxCurvature, edgeCurvature: Infinity });
        drawAt(scene, stepLengthOf(grid, 100));
        return readPixels(scene);
      };
      const all = draw(0);
      expect(scene.adaptive).to.equal(true);
      const [outcomes] = atOnce(forecastSampling(scene.readPicture(), [1], null));
      const foretold = outcomes.filter(({ error }) => error <= 0.5).at(-1)!;
      const adaptive = draw(foretold.maxCurvature);
      const { rmse } = comparePictures(adaptive, all);
      const beyond = Array.from({ length: all.length / 4 }, (_, pixel) =>
        [0, 1, 2, 3].some((c) => Math.abs(all[4 * pixel + c] - adaptive[4 * pixel + c]) > 8),
      ).filter(Boolean).length;
      console.log(
        `${name}: foretold ${foretold.error.toFixed(2)}, ${rmse.toFixed(2)}; ${beyond} pixels of ${all.length / 4} are off by more than 8`,
      );
      expect(rmse, 'rays are spared').to.be.above(0.03);
      expect(rmse).to.be.within(foretold.error / 2 - 0.2, 2 * foretold.error + 0.2);
      expect(beyond / (all.length / 4)).to.be.at.most(0.001);
    });
  }
});
