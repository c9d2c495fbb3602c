import { expect } from '@esm-bundle/chai';
import { StepPolicy } from '../../components/step-policy.ts';
import { stepLengthOf } from '../../src/quality/steps.ts';
import type { Volume } from '../../src/volume/volume.ts';
import type { VolumeScene } from '../../src/x3d/scene.ts';
import { errorScenes } from '../accuracy/error-scenes.ts';
import { withScene } from '../helpers/picture.ts';

/** Shells through a smooth transfer function: a scene with an error to choose by. */
const { volume, transferFunction, camera } = errorScenes().find(({ name }) => name.startsWith('shells, smooth'))!;

function drawWith(scene: VolumeScene, shown: Volume, steps: number): void {
  scene.draw(stepLengthOf(shown, steps));
}

async function withShells(use: (scene: VolumeScene) => void): Promise<void> {
  await withScene({}, (scene) => {
    scene.resize(240, 180);
    scene.setVolume(volume);
    scene.setOptics({ transferFunction, referenceLength: 1, opacityFactor: 1, lightFactor: 1 });
    scene.setCamera(camera);
    use(scene);
  });
}

describe('the policy of steps', () => {
  it('chooses by max-error, draws again only when the choice differs, and states the error that was reached', () =>
    withShells((scene) => {
      const chosen = [2, 0.5].map((maxError) => {
        const policy = new StepPolicy();
        policy.set('auto', maxError);
        const first = policy.still(volume);
        drawWith(scene, volume, first);
        expect(policy.look(scene, volume, first)).to.equal(policy.still(volume) !== first);
        const steps = policy.still(volume);
        drawWith(scene, volume, steps);
        expect(policy.look(scene, volume, steps), 'a second look is content').to.equal(false);
        expect(policy.error!.rms).to.be.at.most(maxError);
        return steps;
      });
      expect(chosen[1]).to.be.above(chosen[0] * 1.3);
    }));

  it('leaves given steps alone, states their error, and forgets it when something changes', () =>
    withShells((scene) => {
      const policy = new StepPolicy();
      policy.set(25, null);
      drawWith(scene, volume, 25);
      expect(policy.look(scene, volume, 25)).to.equal(false);
      const coarse = policy.error!.rms;
      expect(coarse).to.be.above(1);
      policy.forget();
      expect(policy.error).to.equal(null);
      policy.set(200, null);
      drawWith(scene, volume, 200);
      policy.look(scene, volume, 200);
      expect(policy.error!.rms).to.be.below(coarse / 4);
    }));

  it('takes fewer steps while moving than at rest, but for given steps', () => {
    const policy = new StepPolicy();
    policy.tookMoving(100, 300);
    expect(policy.moving(volume)).to.be.below(policy.still(volume));
    policy.set(77, null);
    expect([policy.moving(volume), policy.still(volume)]).to.deep.equal([77, 77]);
  });
});
