// In the browser: pictures of an element under several policies, what they take and how far they are from the view in full.
import type { VolumeView } from '../../components/volume-view/volume-view.ts';
import type { CameraChangeDetail } from '../../components/internal/volume-view-events.ts';
import { maxSteps } from '../../src/renderer/ray/compose-ray.ts';
import '../../src/index.ts';
import { compareCovered } from '../helpers/covered-error.ts';
import { dragCamera } from './drag-camera.ts';
import { median } from './table.mjs';

export interface PairsOptions {
  readonly attributes: Readonly<Record<string, string>>;
  /** Pixels along each side. */
  readonly size: number;
  /** Of the fixed policies. */
  readonly stepCounts: readonly number[];
  /** Of the controller's pictures at rest, and of its moving frames. */
  readonly maxErrors: readonly number[];
  readonly targetFps: readonly number[];
  /** Redraws of a picture at rest. */
  readonly repeats: number;
  /** Of each drag. */
  readonly seconds: number;
}

/** What a policy reached. */
export interface Pair {
  /** Steps of a fixed policy, `max-error` or `target-fps`. */
  readonly target: number;
  /** Median, from the call to the GPU having finished. */
  readonly ms: number;
  /** RMS over the pixels that the volume covers and the four premultiplied channels against the view in full, both in 8 bits; 1/255. */
  readonly error: number;
  /** The error that the element states; null where it states none. */
  readonly stated: number | null;
  readonly steps: number;
  /** Pixels drawn, as a share of the picture's. */
  readonly pixels: number;
}

/** A scene's pairs, by policy. */
export interface ScenePairs {
  readonly fixed: readonly Pair[];
  readonly atRest: readonly Pair[];
  readonly moving: readonly Pair[];
}

/** A picture whose error is not measured yet: RGBA, premultiplied, 0..255, and its view; null for the element's own. */
interface Shown {
  readonly picture: Uint8ClampedArray;
  readonly view: CameraChangeDetail | null;
}

interface Taken extends Omit<Pair, 'error'> {
  readonly shown: readonly Shown[];
}

/** Of a picture that takes longer, one is timed: what blurs times is small beside it, ms. */
const slow = 1000;

/** Frames of a drag whose error is measured. */
const judged = 2;

/** Of a drag, as a share of the element's height: a sixteenth of a turn, so that all is seen from about the same side. */
const dragged = 0.1;

/** The view in full has so many times the steps of any picture that is held against it: errors are right to a sixteenth. */
const finer = 4;

/** @param notify - what is being done */
export async function measurePairs(options: PairsOptions, notify: (what: string) => void): Promise<ScenePairs> {
  const element = document.createElement('volume-view');
  for (const [name, value] of Object.entries(options.attributes)) element.setAttribute(name, value);
  element.style.cssText = `width: ${options.size}px; height: ${options.size}px; max-height: none; aspect-ratio: auto`;
  document.body.append(element);
  await element.whenRendered();
  const fixed: Taken[] = [];
  for (const steps of options.stepCounts) {
    notify(`${steps} steps`);
    element.steps = steps;
    fixed.push({ ...(await takeAtRest(element, options)), target: steps });
  }
  element.steps = null;
  const atRest: Taken[] = [];
  for (const maxError of options.maxErrors) {
    notify(`max-error ${maxError}`);
    element.maxError = maxError;
    atRest.push({ ...(await takeAtRest(element, options)), target: maxError });
  }
  element.maxError = null;
  const judgeOf = (taken: readonly Taken[]): Judge =>
    new Judge(element, options.size, finer * Math.max(...taken.map(({ steps }) => steps)));
  const ofRest = judgeOf([...fixed, ...atRest]); // Before anything moves the camera from the element's own view.
  const pairsOfRest = { fixed: await ofRest.measure(fixed, notify), atRest: await ofRest.measure(atRest, notify) };
  element.steps = null;
  const moving: Taken[] = [];
  for (const fps of options.targetFps) {
    notify(`target-fps ${fps}`);
    element.targetFps = fps;
    moving.push({ ...(await takeMoving(element, options)), target: fps });
  }
  const pairs = { ...pairsOfRest, moving: await judgeOf(moving).measure(moving, notify) };
  element.remove();
  return pairs;
}

async function takeAtRest(element: VolumeView, { size, repeats }: PairsOptions): Promise<Omit<Taken, 'target'>> {
  await element.whenRendered();
  const { steps, width, height, error } = element.renderStats!;
  const shown = [{ picture: readPicture(element, size), view: null }];
  const times = [(await element.redraw()).frameMs];
  while (times.length < repeats && times[0] <= slow) times.push((await element.redraw()).frameMs);
  return { ms: median(times), stated: error?.rms ?? null, steps, pixels: (width * height) / size ** 2, shown };
}

/** Frames of a drag back to where the one before began, in which the controller has learned what they take. */
async function takeMoving(element: VolumeView, { size, seconds }: PairsOptions): Promise<Omit<Taken, 'target'>> {
  await drag(element, { seconds: 1, pixels: dragged * size }, () => {});
  const frames: { ms: number; steps: number; pixels: number }[] = [];
  const shown: Shown[] = [];
  const began = performance.now();
  await drag(element, { seconds, pixels: -dragged * size }, (view) => {
    const { frameMs, steps, width, height } = element.renderStats!;
    frames.push({ ms: frameMs, steps, pixels: (width * height) / size ** 2 });
    const passed = (performance.now() - began) / 1000 / seconds;
    if (passed > (shown.length + 0.5) / judged) shown.push({ picture: readPicture(element, size), view });
  });
  const medianOf = (key: 'ms' | 'steps' | 'pixels'): number => median(frames.map((frame) => frame[key]));
  return { ms: medianOf('ms'), steps: medianOf('steps'), pixels: medianOf('pixels'), stated: null, shown };
}

async function drag(
  element: VolumeView,
  how: { seconds: number; pixels: number },
  onFrame: (view: CameraChangeDetail) => void,
): Promise<void> {
  await element.whenRendered();
  const abort = new AbortController();
  element.addEventListener('camera-change', ({ detail }) => onFrame(detail), { signal: abort.signal });
  await dragCamera(element, how.seconds, how.pixels);
  abort.abort();
}

/** Holds pictures against the view in full, which is drawn once for each view. */
class Judge {
  readonly #limits = new Map<string, Promise<Uint8ClampedArray>>();

  constructor(
    readonly element: VolumeView,
    readonly size: number,
    readonly steps: number,
  ) {}

  async measure(taken: readonly Taken[], notify: (what: string) => void): Promise<Pair[]> {
    const pairs: Pair[] = [];
    for (const { shown, ...rest } of taken) {
      notify(`error at ${rest.target}`);
      const errors: number[] = [];
      for (const { picture, view } of shown) errors.push(compareCovered(picture, await this.#limitOf(view), 1).rms);
      pairs.push({ ...rest, error: median(errors) });
    }
    return pairs;
  }

  #limitOf(view: CameraChangeDetail | null): Promise<Uint8ClampedArray> {
    const key = JSON.stringify(view);
    let limit = this.#limits.get(key);
    if (!limit) this.#limits.set(key, (limit = this.#draw(view)));
    return limit;
  }

  async #draw(view: CameraChangeDetail | null): Promise<Uint8ClampedArray> {
    const { element } = this;
    element.steps = Math.min(maxSteps, Math.round(this.steps));
    if (view) {
      element.cameraOrbit = `${view.orbit.theta.toFixed(9)}rad ${view.orbit.phi.toFixed(9)}rad ${view.orbit.radius.toFixed(9)}`;
      element.cameraTarget = view.target;
    }
    await element.whenRendered();
    return readPicture(element, this.size);
  }
}

/** What is seen of an element: RGBA, premultiplied, 0..255; blown up where it has fewer pixels, bilinear as browsers do. */
function readPicture(element: VolumeView, size: number): Uint8ClampedArray {
  const context = new OffscreenCanvas(size, size).getContext('2d', { willReadFrequently: true })!;
  context.drawImage(element.shadowRoot!.querySelector('canvas')!, 0, 0, size, size);
  const { data } = context.getImageData(0, 0, size, size);
  // It comes with straight alpha; rounding brings back the premultiplied bytes that it was made from.
  for (let i = 0; i < data.length; i += 4)
    for (let c = i; c < i + 3; c++) data[c] = Math.round((data[c] * data[i + 3]) / 255);
  return data;
}
