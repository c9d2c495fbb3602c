import { expect } from '@esm-bundle/chai';
import { maxSubsteps } from '../../src/optics/rays/segment.ts';
import { allSubsteps } from '../../src/optics/cells/substeps.ts';
import { stepLengthOf } from '../../src/quality/steps.ts';
import { measureError } from '../../src/viewer/frames/measure-quality.ts';
import type { VolumeScene } from '../../src/x3d/scene.ts';
import type { ErrorScene } from '../accuracy/error-scenes.ts';
import { changePlan, drawAt } from './change-plan.ts';
import { compareCovered } from './covered-error.ts';
import { comparePictures } from './picture.ts';
import { readPixels } from './read-pixels.ts';
import { probe } from './probe.ts';

/** The rounding error of 8 bits, which the probes' floats do not have: RMS, in 1/255. */
const rounding = 1 / Math.sqrt(12);

/** The pixels that are compared. */
type Lattice = Parameters<typeof probe>[2];

export interface TrueError {
  /** The size of the picture in pixels. */
  readonly size: { readonly width: number; readonly height: number };
  /** The pixels that are compared; all if absent. */
  readonly lattice?: Lattice;
  /** The picture with this many times the steps counts as the true one. */
  readonly times: number;
}

/** The size of a picture that is drawn only to be probed: a probe needs a view that has been drawn. */
const small = { width: 16, height: 12 } as const;

function show(
  gpu: VolumeScene,
  { volume, transferFunction, camera }: ErrorScene,
  steps: number,
  size: TrueError['size'],
): void {
  changePlan(gpu, { picture: size });
  gpu.setVolume(volume);
  void gpu.setAppearance({ optics: { transferFunction, referenceLength: 1, opacityFactor: 1, lightFactor: 1 } });
  changePlan(gpu, { camera });
  drawAt(gpu, stepLengthOf(volume.grid, steps));
}

/**
 * The ratio of a picture's stated error to its true error. The true error is the difference to a picture of the same GPU with many times
 * the steps, because the twin would take too long.
 */
export function compareStated(
  gpu: VolumeScene,
  scene: ErrorScene,
  { size, lattice = { stride: 1, first: [0, 0], ...size }, times }: TrueError,
): number {
  const {
    name,
    volume: { grid },
    steps,
  } = scene;
  changePlan(gpu, { substeps: allSubsteps });
  show(gpu, scene, steps, small);
  const stated = measureError(gpu, grid, { steps, substeps: maxSubsteps }, size)!;
  const [shown, limit] = probe(
    gpu,
    [steps, times * steps].map((n) => stepLengthOf(grid, n)),
    lattice,
    size,
  )!;
  const known = Math.hypot(compareCovered(shown, limit, 255).rms, rounding);
  const ratio = stated.rms / known;
  console.log(
    `${name}: stated ${stated.rms.toFixed(2)}, true ${known.toFixed(2)}, ratio ${ratio.toFixed(2)}, order ${stated.order.toFixed(2)}`,
  );
  return ratio;
}

/** How much adaptive ray sampling changes a scene's picture: RMS, in 1/255. */
export function compareSpared(gpu: VolumeScene, scene: ErrorScene, size: TrueError['size']): number {
  show(gpu, scene, 60, size);
  const all = readPixels(gpu);
  expect(gpu.adaptive).to.equal(true);
  changePlan(gpu, { maxCurvature: 6, edgeCurvature: Infinity });
  drawAt(gpu, stepLengthOf(scene.volume.grid, 60));
  const { rmse } = comparePictures(readPixels(gpu), all);
  console.log(`adaptive: rmse ${rmse.toFixed(2)}`);
  return rmse;
}

/** @param ratios - stated errors divided by true errors */
export function expectMostWithinTwo(ratios: readonly number[]): void {
  const good = ratios.filter((ratio) => ratio > 0.5 && ratio < 2).length;
  expect(good / ratios.length, `${good} of ${ratios.length}`).to.be.at.least(0.9);
}
