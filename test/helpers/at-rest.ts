// Draws a picture at rest as an element would, and compares the error that the element states with the true error.
import { measureTrueError } from '../accuracy/compare-shown.ts';
import type { Camera } from '../../src/optics/rays/camera.ts';
import type { ShownOverlay } from '../../src/optics/attachments/overlay.ts';
import type { RayStyle } from '../../src/optics/rays/ray-style.ts';
import { allSubsteps } from '../../src/optics/cells/substeps.ts';
import type { TransferFunction } from '../../src/optics/transfer/transfer-function.ts';
import type { PictureError } from '../../src/quality/error-estimate.ts';
import { autoSteps, stepLengthOf } from '../../src/quality/steps.ts';
import type { Level } from '../../src/quality/levels.ts';
import type { Optics } from '../../src/renderer/ray/ray-module.ts';
import { QualityControl } from '../../src/viewer/frames/quality-control.ts';
import { defaultTargets } from '../../src/viewer/model/quality-targets.ts';
import type { Volume } from '../../src/volume/volume.ts';
import type { VolumeScene } from '../../src/x3d/scene.ts';
import { changePlan, drawAt } from './change-plan.ts';
import type { CoveredError } from './covered-error.ts';
import { probe } from './probe.ts';

/** The scene to draw. */
export interface RestScene {
  readonly volume: Volume;
  readonly style: RayStyle | null;
  readonly overlay?: ShownOverlay;
  readonly transferFunction: TransferFunction;
  readonly camera: Camera;
  readonly size: { readonly width: number; readonly height: number };
  /** Sets other things: cuts, a region, labels. */
  readonly set?: (gpu: VolumeScene) => Promise<void> | void;
  /** Optics that differ from the usual ones. */
  readonly optics?: Partial<Optics>;
  /** 1 where absent. */
  readonly maxError?: number;
  /** A fixed number of steps, along the longest ray. */
  readonly steps?: number;
}

/** The stated error of a picture, and the true error. */
export interface RestResult {
  readonly stated: PictureError;
  readonly isKept: boolean;
  readonly error: CoveredError;
  readonly samplesAVoxel: number;
  readonly level: Level;
  /** The shown picture: RGBA, premultiplied, bottom row first. */
  readonly shown: Uint8Array;
}

/** Reference rays have this many steps for each voxel, each with up to eight substeps. */
const full = 12;

/** Their maximum number of steps: all of their samples have to be taken. */
const maxSteps = 16_384;

/** The maximum number of frames until there is a picture at rest: draw, choose the steps, draw with these steps. */
const maxFrames = 3;

/** @param halves - compare also with half as many steps: where both references differ, a pixel counts by the nearer one */
export async function measureAtRest(gpu: VolumeScene, scene: RestScene, halves = false): Promise<RestResult> {
  const drawn = await drawAtRest(gpu, scene);
  const { volume, size } = scene;
  changePlan(gpu, { substeps: allSubsteps });
  const one = autoSteps(volume.grid);
  const lengthOf = (share: number): number => stepLengthOf(volume.grid, Math.min(maxSteps, share * one));
  const best = probe(
    gpu,
    (halves ? [full, full / 2] : [full]).map(lengthOf),
    { stride: 1, first: [0, 0], ...size },
    size,
  )! as [Float32Array];
  return { ...drawn, error: measureTrueError(drawn.shown, ...best) };
}

/** Draw the picture, and return it with its stated error. */
export async function drawAtRest(gpu: VolumeScene, scene: RestScene): Promise<Omit<RestResult, 'error'>> {
  const {
    volume,
    style,
    overlay,
    transferFunction,
    camera,
    size,
    set,
    optics: others,
    maxError = defaultTargets.maxError,
    steps: fixed = 'auto',
  } = scene;
  changePlan(gpu, { picture: size });
  await gpu.setOverlay(null);
  const optics = { transferFunction, referenceLength: 1, opacityFactor: 1, lightFactor: 1, ...others };
  await gpu.prepare(volume, optics);
  gpu.setVolume(volume);
  await gpu.setAppearance({ optics, style });
  if (overlay) await gpu.setOverlay(overlay);
  await set?.(gpu);
  changePlan(gpu, { camera });
  const control = new QualityControl();
  control.set({ ...defaultTargets, maxError, steps: fixed });
  const level = await settle(control, gpu, { volume, size });
  return {
    stated: control.error!,
    isKept: control.isKept,
    samplesAVoxel: level.steps / autoSteps(volume.grid),
    level,
    shown: gpu.readPicture().data,
  };
}

/** Draw as an element does: draw, choose the steps by the error, and draw with these steps. */
export async function settle(
  control: QualityControl,
  gpu: VolumeScene,
  { volume: { grid }, size }: Pick<RestScene, 'volume' | 'size'>,
): Promise<Level> {
  for (let frame = 1; frame <= maxFrames; frame++) {
    const plan = control.still(grid);
    changePlan(gpu, { substeps: plan.substeps });
    drawAt(gpu, stepLengthOf(grid, plan.steps));
    if (!(await control.probe(gpu, grid, { plan, size, goesOn: () => true })))
      return { steps: plan.steps, substeps: plan.substeps.max };
  }
  throw new Error(`no picture at rest within ${maxFrames} frames`);
}
