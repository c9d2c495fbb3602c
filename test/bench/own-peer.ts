// In the browser: our own renderer among the peers.
import { defaultReferenceLength } from '../../demos/accuracy/study-view.ts';
import { cutSteps } from '../../src/quality/levels.ts';
import { allRays } from '../../src/quality/sampling-outcome.ts';
import { autoSteps, stepLengthOf } from '../../src/quality/steps.ts';
import { maxSubsteps } from '../../src/optics/rays/segment.ts';
import { ViewQuality } from '../../src/viewer/frames/view-quality.ts';
import type { Volume } from '../../src/volume/volume.ts';
import { VolumeScene } from '../../src/x3d/scene.ts';
import { changePlan } from '../helpers/change-plan.ts';
import type { Peer, Shown } from './peer.ts';
import type { PeerCamera } from './peer-scene.ts';

/** The scene of `<volume-view>`, x3dom and all. */
export async function startOurs(
  host: HTMLElement,
  { volume, transferFunction, isLit, camera }: Shown & { camera: PeerCamera },
): Promise<Peer> {
  const scene = await VolumeScene.create(host, host, () => {});
  await scene.prepare(volume);
  scene.setVolume(volume);
  await scene.setAppearance({
    optics: {
      transferFunction,
      referenceLength: defaultReferenceLength(volume),
      opacityFactor: 1,
      lightFactor: 1,
    },
  });
  if (isLit) await scene.setAppearance({ style: { lit: true } });
  await scene.finished();
  const { grid } = volume;
  let chosen: Partial<typeof scene.plan> | null = null;
  return {
    gl: scene.canvas.getContext('webgl2')!,
    setSize(pixels) {
      chosen = null;
      changePlan(scene, { picture: { width: pixels, height: pixels } });
      changePlan(scene, { camera });
    },
    draw: (stepLength) => {
      const finest = { steps: Math.round(stepsOfLength(volume, stepLength)), substeps: maxSubsteps };
      changePlan(scene, chosen ?? { stepLength, substeps: cutSteps(finest, autoSteps(grid), 1), maxCurvature: 0 });
      scene.draw();
    },
    async choose(maxError, isFree) {
      const view = { scene, grid, size: scene.plan.picture, goesOn: () => true };
      const quality = new ViewQuality(view, { steps: 'auto', maxError, isFree });
      const found = await quality.choose();
      if (!found) throw new Error('the view is gone');
      const { steps, substeps, free } = found.level;
      const { sampling = allRays, substeps: cut = quality.cuts.own(found.level) } = free ?? {};
      chosen = { stepLength: stepLengthOf(grid, steps), substeps: cut, maxCurvature: sampling.maxCurvature };
      return { steps, substeps, rays: sampling.share };
    },
    dispose: () => scene.dispose(),
  };
}

function stepsOfLength({ grid }: Volume, stepLength: number): number {
  return stepLengthOf(grid, 1) / stepLength;
}
