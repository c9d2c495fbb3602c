import { expect } from '@esm-bundle/chai';
import { defaultTargets, QualityControl } from '../../src/viewer/quality-control.ts';
import type { FramePlan } from '../../src/quality/plan-frame.ts';
import { allRays } from '../../src/quality/adaptive-sampling.ts';
import { autoSteps, stepLengthOf } from '../../src/quality/steps.ts';
import type { VolumeScene } from '../../src/x3d/scene.ts';
import { errorScenes } from '../accuracy/error-scenes.ts';
import { comparePictures, withScene } from '../helpers/picture.ts';

/** Shells through a smooth transfer function: a scene with an error to choose by. */
const { volume, transferFunction, camera } = errorScenes().find(({ name }) => name.startsWith('shells, peaks'))!;
const soft = errorScenes().find(({ name }) => name.startsWith('shells, smooth'))!.transferFunction;

const size = { width: 240, height: 180 };
const pixels = size.width * size.height;

/** All pixels at full size, each with its own ray. */
const plain = (steps: number): FramePlan => ({ scale: 1, steps, sampling: allRays });

async function withShells(use: (scene: VolumeScene) => void, shown = transferFunction): Promise<void> {
  await withScene({}, (scene) => {
    scene.resize(size.width, size.height);
    scene.setVolume(volume);
    scene.setOptics({ transferFunction: shown, referenceLength: 1, opacityFactor: 1, lightFactor: 1 });
    scene.setCamera(camera);
    use(scene);
  });
}

/** Draw at rest until the control is content. */
function settle(control: QualityControl, scene: VolumeScene): number {
  for (let frame = 1; frame <= 3; frame++) {
    const plan = control.still(volume.grid);
    scene.setMaxCurvature(plan.sampling.maxCurvature);
    scene.draw(stepLengthOf(volume.grid, plan.steps));
    if (!control.probe(scene, volume.grid, plan, size)) return frame;
  }
  throw new Error('the control is never content');
}

describe('the control of quality', () => {
  it('chooses by max-error, draws again only when the choice differs, and states the error that was reached', () =>
    withShells((scene) => {
      const chosen = [4, 1].map((maxError) => {
        const control = new QualityControl();
        control.set({ ...defaultTargets, maxError });
        expect(control.undecided).to.equal(true);
        expect(settle(control, scene)).to.be.at.most(2);
        expect(control.undecided).to.equal(false);
        expect(control.error!.rms).to.be.at.most(maxError);
        return control.still(volume.grid).steps;
      });
      expect(chosen[1]).to.be.above(chosen[0] * 1.3);
    }));

  it('draws a picture at rest in pieces of a frame\'s time where it takes long, and at once where it does not', () => {
    const control = new QualityControl();
    const big = { width: 1000, height: 800 };
    expect(control.rowsOfPieces(big, plain(100)), 'where nothing is known of times').to.equal(null);
    // 10 ms, and 1 ms for each 100,000 pixels and steps.
    for (const [w, steps] of [[100, 20], [200, 40], [400, 80]]) control.took(plain(steps), w * w, 10 + (w * w * steps) / 1e5);
    const rows = control.rowsOfPieces(big, plain(100))!;
    const ms = 10 + (rows * big.width * 100) / 1e5;
    expect(ms).to.be.within(20, 1000 / defaultTargets.targetFps);
    expect(control.rowsOfPieces({ width: 100, height: 80 }, plain(100))).to.equal(null);
    expect(control.rowsOfPieces({ width: 4000, height: 4000 }, plain(4000)), 'not a row at a time').to.equal(16);
    control.set({ ...defaultTargets, steps: 100 });
    expect(control.rowsOfPieces(big, plain(100)), 'steps that an author gave').to.equal(null);
  });

  it('leaves given steps alone, states their error, and forgets it when something changes', () =>
    withShells((scene) => {
      const control = new QualityControl();
      control.set({ ...defaultTargets, steps: 25 });
      expect(settle(control, scene)).to.equal(1);
      const coarse = control.error!.rms;
      expect(coarse).to.be.above(1);
      control.forget();
      expect(control.error).to.equal(null);
      control.set({ ...defaultTargets, steps: 200 });
      settle(control, scene);
      expect(control.error!.rms).to.be.below(coarse / 2);
    }));

  it('while moving keeps the target time by fewer steps and pixels, but for given steps', () => {
    const control = new QualityControl();
    expect(control.untimed).to.equal(true);
    // 100 steps at full size would take 300 ms.
    control.took({ ...plain(64), scale: 1 / 8 }, pixels, (300 * 64) / 6400);
    expect(control.untimed).to.equal(false);
    for (const targetFps of [10, 30, 60]) {
      control.set({ ...defaultTargets, targetFps });
      const { scale, steps } = control.moving(volume.grid, pixels);
      expect((300 * scale ** 2 * steps) / 100, `${targetFps}`).to.be.within(0.4 * (1000 / targetFps), 1000 / targetFps);
      expect(steps).to.be.at.most(autoSteps(volume.grid));
    }
    control.set({ ...defaultTargets, steps: 77 });
    expect(control.moving(volume.grid, pixels)).to.deep.equal(plain(77));
    expect(control.still(volume.grid)).to.deep.equal(plain(77));
  });

  it('begins with what kept the error in the last view, and knows nothing of another volume', () =>
    withShells((scene) => {
      const control = new QualityControl();
      settle(control, scene);
      const chosen = control.still(volume.grid).steps;
      control.forget();
      expect(control.still(volume.grid).steps).to.be.within(0.5 * chosen, 1.5 * chosen);
      control.took(plain(50), pixels, 10);
      control.forgetAll();
      expect(control.untimed).to.equal(true);
    }));

  it('casts fewer rays for pictures at rest where they are smooth, holds these against rays of all pixels, and begins anew with other looks', () =>
    withShells((scene) => {
      const control = new QualityControl();
      settle(control, scene);
      expect(control.still(volume.grid).sampling, 'nothing is known at first').to.equal(allRays);
      const shares = [];
      for (const maxError of [1, 4]) {
        control.set({ ...defaultTargets, maxError });
        scene.setCamera({ ...camera, fieldOfView: camera.fieldOfView * 0.98 });
        control.forget();
        settle(control, scene);
        const { sampling, steps } = control.still(volume.grid);
        expect(sampling.maxCurvature).to.be.above(0);
        shares.push(sampling.share);
        expect(control.error!.rms).to.be.at.most(1.05 * maxError);
        const shown = scene.readPixels();
        scene.setMaxCurvature(0);
        scene.draw(stepLengthOf(volume.grid, 16 * steps));
        const { rmse } = comparePictures(shown, scene.readPixels());
        // A lattice of one pixel in 81 tells what is off in a few of them.
        expect(control.error!.rms / rmse).to.be.within(0.6, 1.7);
      }
      expect(shares[0]).to.be.below(0.8);
      expect(shares[1]).to.be.below(shares[0]);
      control.forgetProbes();
      expect(control.still(volume.grid).sampling).to.equal(allRays);
    }, soft));

  it('gives up on adaptive sampling that leaves more than the target', () =>
    withShells((scene) => {
      const control = new QualityControl();
      settle(control, scene);
      control.forget();
      expect(control.still(volume.grid).sampling.maxCurvature).to.be.above(0);
      const read = scene.readPicture.bind(scene);
      scene.readPicture = () => {
        const picture = read();
        return { ...picture, data: picture.data.map((byte) => (byte > 20 && byte < 200 ? byte + 12 : byte)) };
      };
      settle(control, scene);
      expect(control.still(volume.grid).sampling).to.equal(allRays);
      expect(control.error!.rms, 'all rays').to.be.below(1);
    }, soft));
});
