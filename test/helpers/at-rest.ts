// A picture at rest as an element would draw it, what is stated of it, and what is true.
import { measureTrueError } from '../accuracy/compare-shown.ts';
import type { Camera } from '../../src/optics/camera.ts';
import type { ShownOverlay } from '../../src/optics/overlay.ts';
import type { RayStyle } from '../../src/optics/ray-style.ts';
import { allSubsteps } from '../../src/optics/substeps.ts';
import type { TransferFunction } from '../../src/optics/transfer-function.ts';
import type { PictureError } from '../../src/quality/error-estimate.ts';
import { autoSteps, stepLengthOf } from '../../src/quality/steps.ts';
import { QualityControl } from '../../src/viewer/quality-control.ts';
import type { Volume } from '../../src/volume/volume.ts';
import type { VolumeScene } from '../../src/x3d/scene.ts';
import type { CoveredError } from './covered-error.ts';

/** What is drawn. */
export interface RestScene {
  readonly volume: Volume;
  readonly style: RayStyle | null;
  readonly overlay?: ShownOverlay;
  readonly transferFunction: TransferFunction;
  readonly camera: Camera;
  readonly size: { readonly width: number; readonly height: number };
}

/** What is said of a picture, and what is so. */
export interface RestResult {
  readonly stated: PictureError;
  readonly isKept: boolean;
  readonly error: CoveredError;
  readonly samplesAVoxel: number;
}

/** Full rays have this many steps a voxel, each with up to eight substeps. */
const full = 12;

export async function measureAtRest(gpu: VolumeScene, { volume, style, overlay, transferFunction, camera, size }: RestScene): Promise<RestResult> {
  gpu.resize(size.width, size.height);
  await gpu.setOverlay(null);
  const optics = { transferFunction, referenceLength: 1, opacityFactor: 1, lightFactor: 1 };
  await gpu.prepare(volume, optics);
  gpu.setVolume(volume);
  await gpu.setStyle(style);
  await gpu.setOptics(optics);
  if (overlay) await gpu.setOverlay(overlay);
  gpu.setCamera(camera);
  const control = new QualityControl();
  let steps = 0;
  for (let isFinal = false; !isFinal; ) {
    const plan = control.still(volume.grid);
    steps = plan.steps;
    gpu.setSubsteps(plan.substeps);
    gpu.draw(stepLengthOf(volume.grid, steps));
    isFinal = !(await control.probe(gpu, volume.grid, { plan, size, goesOn: () => true }));
  }
  const shown = gpu.readPicture().data;
  gpu.setSubsteps(allSubsteps);
  const best = gpu.probe([stepLengthOf(volume.grid, full * autoSteps(volume.grid))], { stride: 1, first: [0, 0], ...size }, size)![0];
  return { stated: control.error!, isKept: control.isKept, error: measureTrueError(shown, best), samplesAVoxel: steps / autoSteps(volume.grid) };
}
