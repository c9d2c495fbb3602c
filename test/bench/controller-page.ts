// In the browser: a scripted orbit of an element, and how far its frames were from what they stand for.
import type { VolumeView } from '../../components/volume-view/volume-view.ts';
import { CameraRig } from '../../src/viewer/camera/camera-rig.ts';
import { loadVolume } from '../../src/worker/load.ts';
import type { Orbit } from '../../src/optics/rays/camera.ts';
import { orbitCamera } from '../../src/optics/rays/camera.ts';
import { resolveTransferFunction } from '../../src/optics/transfer/resolve-transfer-function.ts';
import { windowFromHistogram } from '../../src/optics/transfer/window.ts';
import { autoSteps, stepLengthOf } from '../../src/quality/steps.ts';
import type { Vector3 } from '../../src/volume/matrix.ts';
import type { Volume } from '../../src/volume/volume.ts';
import { VolumeScene } from '../../src/x3d/scene.ts';
import '../../src/index.ts';
import { defaultReferenceLength } from '../../demos/accuracy/study-view.ts';
import { changePlan, drawAt } from '../helpers/change-plan.ts';
import { blowUp } from './blow-up.ts';
import { dragCamera } from './drag-camera.ts';
import { median } from './table.mjs';
import { readPixels } from '../helpers/read-pixels.ts';
import '../helpers/provide-substeps.ts';

export interface ControllerScene {
  readonly src: string;
  /** A preset's name, or stops. */
  readonly transferFunction: string;
  /** Pixels along each side. */
  readonly size: number;
  readonly targetFps: number;
  readonly seconds: number;
}

/** One frame of the orbit. */
interface Frame {
  readonly at: number;
  readonly ms: number;
  readonly steps: number;
  readonly rays: number;
  readonly maxCurvature: number;
  readonly width: number;
  readonly height: number;
  readonly orbit: Orbit;
  readonly target: Vector3;
}

export interface ControllerResult {
  /** A frame at rest: time, ms, and steps. */
  readonly atRestMs: number;
  readonly atRestSteps: number;
  readonly frames: number;
  readonly framesPerSecond: number;
  /** Share of the orbit's frames that took up to 15 % more than the budget. */
  readonly inBudget: number;
  readonly medianMs: number;
  /** Pixels drawn, as a share of all, and steps: medians. */
  readonly medianPixels: number;
  /** Rays, as a share of the full picture's pixels. */
  readonly medianRays: number;
  readonly medianSteps: number;
  /** RMSE of some of the orbit's frames, blown up, 1/255: median and largest. */
  readonly medianError: number;
  readonly largestError: number;
  /** From the hand's letting go to the final picture, ms. */
  readonly convergedMs: number;
  /** In the two seconds after: frames told of, and callbacks asked for. */
  readonly idleFrames: number;
  readonly idleCallbacks: number;
}

/** A frame that took this much of its budget is one that kept it. */
const tolerance = 1.15;

const idleMs = 2000;

/** Frames whose error is measured. */
const judged = 3;

/** @param notify - what is being done */
export async function measureController(
  scene: ControllerScene,
  notify: (what: string) => void,
): Promise<ControllerResult> {
  notify(`${scene.transferFunction.slice(0, 20)}, ${scene.size} pixels: loading`);
  const element = document.createElement('volume-view');
  element.src = scene.src;
  element.transferFunction = scene.transferFunction;
  element.targetFps = scene.targetFps;
  element.style.cssText = `width: ${scene.size}px; height: ${scene.size}px; max-height: none; aspect-ratio: auto`;
  document.body.append(element);
  await element.whenRendered();
  const atRest = await element.redraw();
  await orbit(element, 1); // The controller learns what frames of this scene take.
  notify('the orbit');
  const frames = await orbit(element, scene.seconds);
  const released = performance.now();
  await element.whenRendered();
  const convergedMs = performance.now() - released;
  const idle = await watchIdle(element);
  element.remove();
  notify('errors of its frames');
  const errors = await measureErrors(scene, frames);
  const times = frames.map(({ ms }) => ms);
  return {
    atRestMs: atRest.frameMs,
    atRestSteps: atRest.steps,
    frames: frames.length,
    framesPerSecond: (1000 * (frames.length - 1)) / (frames[frames.length - 1].at - frames[0].at),
    inBudget: times.filter((ms) => ms <= (tolerance * 1000) / scene.targetFps).length / frames.length,
    medianMs: median(times),
    medianPixels: median(frames.map(({ width, height }) => (width * height) / scene.size ** 2)),
    medianRays: median(frames.map(({ width, height, rays }) => (rays * width * height) / scene.size ** 2)),
    medianSteps: median(frames.map(({ steps }) => steps)),
    medianError: median(errors),
    largestError: Math.max(...errors),
    convergedMs,
    ...idle,
  };
}

/** Drag the camera once around in so many seconds, as a mouse of 60 movements a second does. */
async function orbit(element: VolumeView, seconds: number): Promise<Frame[]> {
  const frames: Frame[] = [];
  const abort = new AbortController();
  // The camera's position is reported after each frame in which it moved.
  element.addEventListener(
    'camera-change',
    ({ detail }) => {
      const { frameMs, steps, width, height, rays, maxCurvature } = element.renderStats!;
      frames.push({ at: performance.now(), ms: frameMs, steps, width, height, rays, maxCurvature, ...detail });
    },
    { signal: abort.signal },
  );
  // Height of the element that is one turn, see src/viewer/camera/camera-input.ts.
  await dragCamera(element, seconds, (2 * element.clientHeight) / 1.2);
  abort.abort();
  return frames;
}

/** Frames, and callbacks that anything in the page asks for, while nothing changes. */
async function watchIdle(element: VolumeView): Promise<{ idleFrames: number; idleCallbacks: number }> {
  let idleFrames = 0;
  let idleCallbacks = 0;
  const count = (): void => void idleFrames++;
  element.addEventListener('render', count);
  const { requestAnimationFrame: frame, setTimeout: once, setInterval: often } = window;
  const rest = new Promise((resolve) => setTimeout(resolve, idleMs));
  const counted = <T extends (...args: never[]) => unknown>(original: T): T =>
    ((...args: never[]) => {
      idleCallbacks++;
      return original(...args);
    }) as T;
  window.requestAnimationFrame = counted(frame);
  window.setTimeout = counted(once) as typeof setTimeout;
  window.setInterval = counted(often) as typeof setInterval;
  await rest;
  Object.assign(window, { requestAnimationFrame: frame, setTimeout: once, setInterval: often });
  element.removeEventListener('render', count);
  return { idleFrames, idleCallbacks };
}

/** Draw some frames of the orbit again, enlarged as browsers do it, and in full with two steps per voxel and substeps. */
async function measureErrors(
  { src, transferFunction, size }: ControllerScene,
  frames: readonly Frame[],
): Promise<number[]> {
  const limits = { maxVoxelsPerAxis: 2048, maxAtlasSize: null, maxBytes: 2 ** 30 };
  const volume = await loadVolume({ url: src, limits }, { signal: new AbortController().signal, onProgress: () => {} });
  const host = document.createElement('div');
  document.body.append(host);
  const scene = await VolumeScene.create(host, host, () => {});
  await scene.prepare(volume);
  scene.setVolume(volume);
  const stops = await resolveTransferFunction(transferFunction, volume.window ?? windowFromHistogram(volume.histogram));
  await scene.setAppearance({
    optics: {
      transferFunction: stops,
      referenceLength: defaultReferenceLength(volume),
      opacityFactor: 1,
      lightFactor: 1,
    },
  });
  const errors: number[] = [];
  for (let i = 0; i < judged; i++) {
    const frame = frames[Math.floor(((i + 0.5) / judged) * frames.length)];
    const shown = blowUp(drawAgain(scene, volume, frame), frame, size);
    const limit = drawAgain(scene, volume, {
      ...frame,
      width: size,
      height: size,
      maxCurvature: 0,
      steps: 2 * autoSteps(volume.grid),
    });
    let sum = 0;
    for (let at = 0; at < limit.length; at++) sum += (shown[at] - limit[at]) ** 2;
    errors.push(Math.sqrt(sum / limit.length));
  }
  scene.dispose();
  host.remove();
  return errors;
}

function drawAgain(
  scene: VolumeScene,
  volume: Volume,
  { width, height, steps, maxCurvature, orbit: place, target }: Frame,
): Uint8ClampedArray {
  changePlan(scene, { picture: { width, height } });
  changePlan(scene, { camera: orbitCamera(place, target, new CameraRig().camera.fieldOfView) });
  changePlan(scene, { maxCurvature, edgeCurvature: Infinity });
  drawAt(scene, stepLengthOf(volume.grid, steps));
  return readPixels(scene);
}
