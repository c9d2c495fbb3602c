import { contributionOf, measureEmptySpace } from '../../src/optics/cells/empty-space-distance.ts';
import { interpolate } from '../../src/optics/rays/interpolate.ts';
import { intersectUnitCube, rayThrough } from '../../src/optics/rays/rays.ts';
import { countSteps } from '../../src/optics/rays/count-steps.ts';
import { storedField } from '../../src/optics/rays/ray-field.ts';
import { castSceneRay } from '../../src/optics/reference.ts';
import type { PictureDifference } from './compare-pictures.ts';
import { autoSteps, stepLengthOf } from '../../src/quality/steps.ts';
import { maxSteps } from '../../src/renderer/ray/compose-ray.ts';
import type { Vector3 } from '../../src/volume/matrix.ts';
import type { Volume } from '../../src/volume/volume.ts';
import { comparePictures } from './compare-pictures.ts';
import { reduceTo } from './derive-volumes.ts';
import { fitPaperFactors } from './fit-paper.ts';
import { roundResults } from './results.ts';
import type { ErrorRow, FunctionResults, ResolutionResults, SceneResults, StudyResults } from './results.ts';
import { describePicture, listSteps, resolutionSteps, setUpScene, studyMethods, studySteps } from './scene-setup.ts';
import type { SceneSetup, StudyOptions } from './scene-setup.ts';
import { studyScenes } from './scenes.ts';
import type { StudyFunction } from './scenes.ts';
import { StudyGl } from './study-gl.ts';
import type { PaperFactors, StudyPicture } from './study-gl.ts';
import { coveredShare } from './study-view.ts';
import { timePictures } from './time-pictures.ts';

/** Minimum number of steps of a limit: twice, and five times, the maximum that is compared with it. */
const limitSteps = { full: 4000, reduced: 1000 } as const;

/** Pixels along each side of the picture that tells how settled a limit is. */
const coarseSize = 64;

/** Rays along each side of the picture on which samples are counted. */
const countedSide = 8;

/** Rays along each side of the picture on which the limit is held against the float64 reference. */
const referenceSide = 4;

/** Steps that stand for endlessly many: 16 samples a voxel or more. */
export function stepsOfLimit(volume: Volume, min: number = limitSteps.full): number {
  return Math.min(maxSteps, Math.max(16 * autoSteps(volume.grid), min));
}

/**
 * Measure error and time of all methods on a set of volumes.
 * @throws the signal's reason; Error where this browser can't draw the study
 */
export async function runStudy(options: StudyOptions): Promise<StudyResults> {
  const gl = new StudyGl();
  const scenes: SceneResults[] = [];
  const leftOut: string[] = [];
  try {
    for (const [i, id] of options.scenes.entries()) {
      const { name } = studyScenes.find((one) => one.id === id)!;
      const onProgress = (share: number, what: string): void =>
        options.onProgress((i + share) / options.scenes.length, `${name}: ${what}`);
      onProgress(0, 'loading');
      const setup = await setUpScene(id, options.signal);
      if (setup) scenes.push(await measureScene(gl, setup, { ...options, onProgress }));
      else leftOut.push(name);
    }
    return roundResults({
      where: {
        browser: /(Firefox|Edg|Chrome|Version)\/[\d.]+/.exec(navigator.userAgent)?.[0] ?? navigator.userAgent,
        renderer: gl.renderer,
        software: /swiftshader|llvmpipe|lavapipe|software/i.test(gl.renderer),
        threads: navigator.hardwareConcurrency,
      },
      size: options.size,
      timeSize: options.timeSize,
      channelBits: gl.channelBits,
      repeats: options.repeats,
      scenes,
      leftOut,
    });
  } finally {
    gl.dispose();
  }
}

async function measureScene(gl: StudyGl, setup: SceneSetup, options: StudyOptions): Promise<SceneResults> {
  const { id, name, volume, eightBits, functions, base } = setup;
  const functionResults: FunctionResults[] = [];
  const reduced = new Map(
    ([50, 25] as const).map((percent) => [
      percent,
      { ...setup, volume: reduceTo(volume, percent), eightBits: reduceTo(eightBits, percent) },
    ]),
  );
  for (const [i, fn] of functions.entries()) {
    const onProgress = (share: number, what: string): void =>
      options.onProgress((i + share) / (functions.length + 1), `${fn.name}, ${what}`);
    functionResults.push(await measureFunction(gl, { setup, reduced, fn }, { ...options, onProgress }));
  }
  options.onProgress(functions.length / (functions.length + 1), 'times');
  const isTimed = options.timed.includes(id);
  const times = isTimed ? await timePictures(gl, { setup, reduced, results: functionResults[0] }, options) : [];
  for (const one of [setup, ...reduced.values()]) [one.volume, one.eightBits].forEach((v) => gl.forget(v));
  return {
    id,
    name,
    dimensions: volume.grid.dimensions,
    bits: 8 * volume.samples.BYTES_PER_ELEMENT,
    voxelSteps: autoSteps(volume.grid),
    covered: coveredShare(base.rays, options.size),
    functions: functionResults,
    times,
  };
}

/** A scene with one transfer function, on its own grid and on coarser ones. */
interface FunctionSetup {
  readonly setup: SceneSetup;
  readonly reduced: ReadonlyMap<50 | 25, SceneSetup>;
  readonly fn: StudyFunction;
}

async function measureFunction(gl: StudyGl, work: FunctionSetup, options: StudyOptions): Promise<FunctionResults> {
  const { setup, fn } = work;
  const { size, signal, onProgress } = options;
  const steps = stepsOfLimit(setup.volume);
  onProgress(0, 'limit');
  const limitPicture = describePicture(setup, fn, { method: 'shipped', steps, maxSubsteps: 1 });
  const limit = await gl.draw(limitPicture, size, signal);
  const settled = await gl.draw(limitPicture, coarseSize, signal);
  const half = await gl.draw({ ...limitPicture, steps: steps / 2 }, coarseSize, signal);
  onProgress(0.3, 'reference');
  const reference = checkAgainstReference(limitPicture, limit, size);
  const paper = await fitPaperFactors(gl, limitPicture, setup.eightBits, signal);
  onProgress(0.35, 'errors');
  const errors = await measureErrors(gl, { ...work, paper, limit }, options);
  onProgress(0.7, 'coarser grids');
  const resolution: ResolutionResults[] = [];
  for (const percent of [50, 25] as const) {
    resolution.push(await measureResolution(gl, { ...work, paper, limit, percent }, options));
  }
  const eightBits =
    setup.eightBits === setup.volume
      ? null
      : {
          limit: comparePictures(await gl.draw({ ...limitPicture, volume: setup.eightBits }, size, signal), limit),
          atVoxel: comparePictures(
            await gl.draw(
              { ...limitPicture, volume: setup.eightBits, steps: autoSteps(setup.volume.grid), maxSubsteps: undefined },
              size,
              signal,
            ),
            limit,
          ),
        };
  return {
    id: fn.id,
    name: fn.name,
    samplesPerStep: countSamplesPerStep(limitPicture),
    limit: { steps, half: comparePictures(half, settled), reference },
    paper,
    errors,
    resolution,
    eightBits,
  };
}

async function measureErrors(
  gl: StudyGl,
  { setup, fn, paper, limit }: FunctionSetup & { paper: PaperFactors; limit: Float32Array },
  { size, signal }: StudyOptions,
): Promise<ErrorRow[]> {
  const rows: ErrorRow[] = [];
  const all = listSteps(setup.volume, [...studySteps, ...resolutionSteps]);
  for (const method of studyMethods) {
    for (const steps of all) {
      const picture = await gl.draw(describePicture(setup, fn, { method, steps, paper }), size, signal);
      rows.push({ method, steps, ...comparePictures(picture, limit) });
    }
  }
  return rows;
}

async function measureResolution(
  gl: StudyGl,
  {
    reduced,
    fn,
    paper,
    limit,
    percent,
  }: FunctionSetup & { paper: PaperFactors; limit: Float32Array; percent: 50 | 25 },
  { size, signal }: StudyOptions,
): Promise<ResolutionResults> {
  const setup = reduced.get(percent)!;
  const limitOfGrid = stepsOfLimit(setup.volume, limitSteps.reduced);
  const own = await gl.draw(
    describePicture(setup, fn, { method: 'shipped', steps: limitOfGrid, maxSubsteps: 1 }),
    size,
    signal,
  );
  const rows = [];
  for (const method of studyMethods) {
    for (const steps of resolutionSteps) {
      const picture = await gl.draw(describePicture(setup, fn, { method, steps, paper }), size, signal);
      rows.push({ method, steps, own: comparePictures(picture, own), full: comparePictures(picture, limit) });
    }
  }
  return {
    percent,
    dimensions: setup.volume.grid.dimensions,
    limitSteps: limitOfGrid,
    data: comparePictures(own, limit),
    rows,
  };
}

/** Samples that the shipped method takes per step of one voxel: in cells where something may be visible, with substeps. */
function countSamplesPerStep({ volume, rays, transferFunction, referenceLength }: StudyPicture): number {
  const { samples, slope, intercept, grid, macrocells } = volume;
  const { dimensions } = grid;
  const rings = measureEmptySpace(macrocells, [contributionOf(transferFunction)], volume);
  const cells = macrocells.dimensions;
  const taken = { samples: 0, steps: 0 };
  const valueAt = (point: Vector3): number => {
    const [i, j, k] = point.map((p, axis) =>
      Math.min(cells[axis] - 1, Math.max(0, Math.floor((p * dimensions[axis]) / macrocells.size))),
    );
    if (rings[i + cells[0] * (j + cells[1] * k)] === 0) taken.samples++;
    return interpolate(samples, dimensions, point);
  };
  const optics = { transferFunction, referenceLength, opacityFactor: 1, lightFactor: 1 };
  const stepLength = stepLengthOf(volume.grid, autoSteps(volume.grid));
  const scene = {
    grid: volume.grid,
    samples,
    slope,
    intercept,
    ...optics,
    stepLength,
    field: storedField(valueAt, volume),
  };
  for (let i = 0; i < countedSide ** 2; i++) {
    const [x, y] = [i % countedSide, Math.floor(i / countedSide)].map((n) => ((n + 0.5) / countedSide) * 2 - 1);
    const ray = rayThrough(rays, x, y);
    const [entry, exit] = intersectUnitCube(ray.point, ray.direction);
    if (!(exit > entry)) continue;
    taken.steps += countSteps((exit - entry) * ray.lengthPerT, stepLength / rays.diameter);
    castSceneRay(scene, rays, ray);
  }
  return taken.samples / taken.steps;
}

/** The limit against castRay: float64, no table, no early end of a ray. */
function checkAgainstReference(
  { volume, rays, transferFunction, referenceLength, steps }: StudyPicture,
  limit: Float32Array,
  size: number,
): { rays: number; rms: number; worst: number } {
  const { samples, slope, intercept } = volume;
  const optics = { transferFunction, referenceLength, opacityFactor: 1, lightFactor: 1 };
  const scene = {
    grid: volume.grid,
    samples,
    slope,
    intercept,
    ...optics,
    stepLength: stepLengthOf(volume.grid, steps),
    maxSubsteps: 1,
  };
  const differences: PictureDifference[] = [];
  for (let i = 0; i < referenceSide ** 2; i++) {
    const column = Math.floor((((i % referenceSide) + 0.5) / referenceSide) * size);
    const row = Math.floor(((Math.floor(i / referenceSide) + 0.5) / referenceSide) * size);
    const ray = rayThrough(rays, ((column + 0.5) / size) * 2 - 1, ((row + 0.5) / size) * 2 - 1);
    const expected = Float32Array.from(castSceneRay(scene, rays, ray));
    const at = (row * size + column) * 4;
    differences.push(comparePictures(limit.subarray(at, at + 4), expected));
  }
  return {
    rays: differences.length,
    rms: Math.sqrt(differences.reduce((sum, { rms }) => sum + rms ** 2, 0) / differences.length),
    worst: Math.max(...differences.map(({ p99 }) => p99)),
  };
}
