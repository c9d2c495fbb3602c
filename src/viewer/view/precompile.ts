import { wholeSteps } from '../../optics/cells/substeps.ts';
import { allRays } from '../../quality/sampling-outcome.ts';
import type { Volume } from '../../volume/volume.ts';
import type { Cuts } from '../cuts/cuts.ts';
import { planFrame } from '../model/frame-plan.ts';
import type { Scene } from '../model/scene.ts';
import type { Viewer } from './viewer.ts';
import { styleOf } from '../model/volume-info.ts';
import type { VolumeOptics } from '../model/volume-info.ts';

/** What will be shown next. */
export interface Foretold {
  readonly volume: Volume;
  readonly optics: VolumeOptics;
  readonly cuts: Cuts;
}

/**
 * Precompile, in a viewer's scene that waits for its volume, the code that draws it: by a picture of one pixel that is cleared
 * before anybody sees it. For a radar, compiling takes as long as all other work before its first picture.
 */
export function precompile(viewer: Viewer | null, foretold: Foretold): void {
  viewer?.controller.precompile((scene) => draw(scene, foretold).catch(() => {})); // An error is reported when the picture itself is drawn.
}

async function draw(scene: Scene, { volume, optics, cuts }: Foretold): Promise<void> {
  await scene.prepare(volume, optics);
  await scene.setAppearance({ optics, style: styleOf(optics) });
  if (!(await scene.bringVolume(volume, () => false))) return;
  const quality = { scale: 1, steps: 1, substeps: wholeSteps, sampling: allRays };
  // From any direction: an author's viewpoint stays as it is.
  const plan = planFrame({ shown: { grid: volume.grid, cuts }, quality, size: { width: 1, height: 1 }, camera: null });
  scene.apply(plan);
  scene.draw();
  scene.apply({ ...plan, picture: { width: 1, height: 2 } }); // A canvas that changes its size is cleared.
  await scene.finished();
}
