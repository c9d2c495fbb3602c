import { expect } from '@esm-bundle/chai';
import { QualityControl } from '../../../../src/viewer/frames/quality-control.ts';
import { defaultTargets } from '../../../../src/viewer/model/quality-targets.ts';
import type { FrameQuality } from '../../../../src/quality/frame-quality.ts';
import { allSubsteps, wholeSteps } from '../../../../src/optics/cells/substeps.ts';
import { allRays } from '../../../../src/quality/sampling-outcome.ts';
import { autoSteps, stepLengthOf } from '../../../../src/quality/steps.ts';
import type { VolumeScene } from '../../../../src/x3d/scene.ts';
import { errorScenes } from '../../../accuracy/error-scenes.ts';
import { changePlan, drawAt } from '../../../helpers/change-plan.ts';
import { withScene } from '../../../helpers/picture.ts';

/** Shells through a smooth transfer function: a scene with an error to choose by. */
const { volume, transferFunction, camera } = errorScenes().find(({ name }) => name.startsWith('shells, peaks'))!;
const soft = errorScenes().find(({ name }) => name.startsWith('shells, smooth'))!.transferFunction;

const size = { width: 120, height: 90 };
const pixels = size.width * size.height;

/** All pixels at full size, each with its own ray. */
const plain = (steps: number): FrameQuality => ({ scale: 1, steps, substeps: allSubsteps, sampling: allRays });
/** The same as pictures in motion have them. */
const moving = (steps: number): FrameQuality => ({ ...plain(steps), substeps: wholeSteps });

async function withShells(use: (scene: VolumeScene) => void | Promise<void>, shown = transferFunction): Promise<void> {
  await withScene({}, async (scene) => {
    changePlan(scene, { picture: size });
    scene.setVolume(volume);
    void scene.setAppearance({
      optics: { transferFunction: shown, referenceLength: 1, opacityFactor: 1, lightFactor: 1 },
    });
    changePlan(scene, { camera });
    await use(scene);
  });
}

/** Draw at rest until the control is content. */
async function settle(control: QualityControl, scene: VolumeScene): Promise<number> {
  for (let frame = 1; frame <= 3; frame++) {
    const plan = control.still(volume.grid);
    changePlan(scene, { substeps: plan.substeps });
    drawAt(scene, stepLengthOf(volume.grid, plan.steps));
    if (!(await control.probe(scene, volume.grid, { plan, size, goesOn: () => true }))) return frame;
  }
  throw new Error('the control is never content');
}

describe('the control of quality', () => {
  it('chooses by max-error, draws again only when the choice differs, and states the error that was reached', () =>
    withShells(async (scene) => {
      const chosen = [];
      for (const maxError of [60, 1]) {
        const control = new QualityControl();
        control.set({ ...defaultTargets, maxError });
        expect(control.undecided).to.equal(true);
        expect(await settle(control, scene)).to.be.at.most(2);
        expect(control.undecided).to.equal(false);
        expect(control.error!.rms).to.be.at.most(maxError);
        expect(control.isKept).to.equal(true);
        const { steps, substeps, sampling } = control.still(volume.grid);
        expect(sampling).to.equal(allRays);
        expect(steps, 'never less than one a voxel').to.be.at.least(autoSteps(volume.grid));
        expect(substeps.voxelsPerStep).to.be.at.most(1);
        chosen.push({ rms: control.error!.rms, cost: steps * substeps.max });
      }
      expect(chosen[1].rms).to.be.below(chosen[0].rms);
      expect(chosen[1].cost).to.be.at.least(chosen[0].cost);
    }));

  it("draws a picture at rest in pieces of a frame's time where it takes long, and at once where it does not", () => {
    const control = new QualityControl();
    const big = { width: 1000, height: 800 };
    expect(control.rowsOfPieces(big, plain(100)), 'where nothing is known of times').to.equal(null);
    // 10 ms, and 1 ms for each 100,000 pixels and steps.
    for (const [w, steps] of [
      [100, 20],
      [200, 40],
      [400, 80],
    ])
      control.took(moving(steps), w * w, 10 + (w * w * steps) / 1e5);
    const rows = control.rowsOfPieces(big, plain(100))!;
    const ms = 10 + (rows * big.width * 100) / 1e5;
    expect(ms).to.be.within(20, 1000 / defaultTargets.targetFps);
    expect(control.rowsOfPieces({ width: 100, height: 80 }, plain(100))).to.equal(null);
    expect(control.rowsOfPieces({ width: 4000, height: 4000 }, plain(4000)), 'not a row at a time').to.equal(16);
    control.set({ ...defaultTargets, steps: 100 });
    expect(control.rowsOfPieces(big, plain(100)), 'steps that an author gave').to.equal(null);
  });

  it('leaves given steps alone, states their error, and forgets it when something changes', () =>
    withShells(async (scene) => {
      const control = new QualityControl();
      control.set({ ...defaultTargets, steps: 25 });
      await control.prepare();
      expect(await settle(control, scene)).to.equal(1);
      const coarse = control.error!.rms;
      expect(coarse).to.be.above(1);
      control.forget();
      expect(control.error).to.equal(null);
      control.set({ ...defaultTargets, steps: 200 });
      await settle(control, scene);
      expect(control.error!.rms).to.be.below(coarse / 2);
    }));

  it('states nothing of given steps where the view changes meanwhile', () =>
    withShells(async (scene) => {
      const native = scene.startProbe.bind(scene);
      let goesOn = true;
      scene.startProbe = (...given) => {
        goesOn = false;
        return native(...given);
      };
      const control = new QualityControl();
      control.set({ ...defaultTargets, steps: 25 });
      await control.prepare();
      drawAt(scene, stepLengthOf(volume.grid, 25));
      expect(
        await control.probe(scene, volume.grid, { plan: control.still(volume.grid), size, goesOn: () => goesOn }),
      ).to.equal(false);
      expect([goesOn, control.error]).to.deep.equal([false, null]);
    }));

  it('while moving keeps the target time by fewer steps and pixels, except with given steps', async () => {
    const control = new QualityControl();
    expect(control.untimed).to.equal(true);
    // What plans frames comes with the first picture, or with given steps.
    control.set({ ...defaultTargets, steps: 77 });
    await control.prepare();
    // 100 steps at full size would take 300 ms.
    control.took({ ...moving(64), scale: 1 / 8 }, pixels, (300 * 64) / 6400);
    expect(control.untimed).to.equal(false);
    for (const targetFps of [10, 30, 60]) {
      control.set({ ...defaultTargets, targetFps });
      const { scale, steps } = control.moving(volume.grid, pixels);
      expect((300 * scale ** 2 * steps) / 100, `${targetFps}`).to.be.within(0.4 * (1000 / targetFps), 1000 / targetFps);
      expect(steps).to.be.at.most(autoSteps(volume.grid));
    }
    control.set({ ...defaultTargets, steps: 77 });
    expect(control.moving(volume.grid, pixels)).to.deep.equal(plain(77));
    // At rest edges of surfaces get more rays, where they jump by more than `max-error` allows a pixel in a thousand.
    expect(control.still(volume.grid)).to.deep.equal({ ...plain(77), edgeCurvature: 8 * Math.sqrt(12) });
    control.set({ ...defaultTargets, steps: 77, maxError: 3 });
    expect(control.still(volume.grid).edgeCurvature).to.be.closeTo(3 * 8 * Math.sqrt(12), 1e-9);
  });

  it("while moving draws as at rest where that is within a frame's time, so that what is small does not blink", () =>
    withShells(async (scene) => {
      const control = new QualityControl();
      await settle(control, scene);
      const rest = control.still(volume.grid);
      expect(rest.substeps.voxelsPerStep, 'cells have a say').to.be.above(0);
      control.took(moving(64), pixels, 20);
      expect(control.moving(volume.grid, pixels).substeps, 'before a picture at rest was timed').to.equal(wholeSteps);
      control.took(rest, pixels, 20);
      control.forget(); // The camera moves.
      expect(control.moving(volume.grid, pixels)).to.equal(rest);
      expect(control.moving(volume.grid, 4 * pixels).substeps, 'in another size').to.equal(wholeSteps);
      control.took(rest, pixels, 29);
      expect(control.moving(volume.grid, pixels).substeps, 'where it takes longer after all').to.equal(wholeSteps);
      control.took(rest, pixels, 20);
      control.forgetProbes();
      expect(control.moving(volume.grid, pixels).substeps, 'where something else is seen').to.equal(wholeSteps);
    }));

  it('chooses the same for a view whatever was seen before, and knows nothing of another volume', function () {
    this.timeout(120_000);
    return withShells(async (scene) => {
      const chosen = [];
      for (const zooms of [[1], [0.7, 1.3, 1], [0.5, 1]]) {
        const control = new QualityControl();
        for (const zoom of zooms) {
          changePlan(scene, { camera: { ...camera, fieldOfView: camera.fieldOfView * zoom } });
          control.forget();
          await settle(control, scene);
        }
        chosen.push({ ...control.still(volume.grid), error: control.error });
      }
      expect(chosen[1]).to.deep.equal(chosen[0]);
      expect(chosen[2]).to.deep.equal(chosen[0]);
      const control = new QualityControl();
      control.took(moving(50), pixels, 10);
      control.forgetAll();
      expect(control.untimed).to.equal(true);
    });
  });

  it('learns from a picture at rest where rays of pictures in motion may be spared', () =>
    withShells(async (scene) => {
      const control = new QualityControl();
      control.took({ ...moving(64), scale: 1 / 8 }, pixels, 3);
      expect(control.moving(volume.grid, pixels).sampling).to.equal(allRays);
      await settle(control, scene);
      expect(control.moving(volume.grid, pixels).sampling.maxCurvature).to.be.above(0);
      control.forgetProbes();
      expect(control.moving(volume.grid, pixels).sampling).to.equal(allRays);
    }, soft));

  it('probes few steps, which only pictures in motion have, when the final picture is there', () =>
    withShells(async (scene) => {
      const control = new QualityControl();
      const lengths: number[] = [];
      const native = scene.startProbe.bind(scene);
      scene.startProbe = (rays, ...rest) => (lengths.push(rays.stepLength!), native(rays, ...rest));
      const max = stepLengthOf(volume.grid, autoSteps(volume.grid));
      drawAt(scene, stepLengthOf(volume.grid, 7));
      expect(
        await control.probe(scene, volume.grid, { plan: plain(7), size, goesOn: () => true }),
        'drawn again',
      ).to.equal(true);
      expect(lengths).to.have.property('length').above(0);
      expect(Math.max(...lengths), 'before it').to.be.at.most(max);
      expect(Math.min(...lengths), 'held against four steps a voxel').to.be.at.most(max / 4 + 1e-9);
      await settle(control, scene);
      expect(Math.max(...lengths), 'after it').to.be.above(2 * max);
    }));

  it('gives up without an error where the context is lost between two pictures', () =>
    withShells(async (scene) => {
      const native = scene.startProbe.bind(scene);
      let left = Infinity;
      // At its drawing, or when it is read.
      scene.startProbe = (...given) => (left-- > 0 ? native(...given) : left % 2 ? null : () => null);
      drawAt(scene, stepLengthOf(volume.grid, autoSteps(volume.grid)));
      for (const maxError of [60, 0.1]) {
        for (let pictures = 0; pictures < 9; pictures++) {
          left = pictures;
          const control = new QualityControl();
          control.set({ ...defaultTargets, maxError });
          await control.probe(scene, volume.grid, { plan: plain(10), size, goesOn: () => true });
          expect(control.error === null || control.error.rms >= 0).to.equal(true);
        }
      }
    }, soft));

  it('says where a target cannot be kept: below what 8 bits show', () =>
    withShells(async (scene) => {
      const control = new QualityControl();
      control.set({ ...defaultTargets, maxError: 0.1 });
      await settle(control, scene);
      expect(control.isKept).to.equal(false);
      expect(control.error!.rms, 'rounding alone').to.be.within(0.2, 0.45);
    }, soft));
});
