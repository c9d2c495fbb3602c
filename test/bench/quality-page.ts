// In the browser: what a picture of a given error costs, and what each technique brings.
import { comparePictures } from '../../demos/accuracy/compare-pictures.ts';
import { listFunctions, loadScene, studyScenes } from '../../demos/accuracy/scenes.ts';
import type { StudyFunction } from '../../demos/accuracy/scenes.ts';
import { StudyGl } from '../../demos/accuracy/study-gl.ts';
import type { StudyPicture } from '../../demos/accuracy/study-gl.ts';
import { stepsOfLimit } from '../../demos/accuracy/study.ts';
import { defaultRays, defaultReferenceLength } from '../../demos/accuracy/study-view.ts';
import { autoSteps } from '../../src/quality/steps.ts';
import { maxSteps } from '../../src/shader/compose.ts';
import type { Volume } from '../../src/volume/volume.ts';
import { syntheticVolume } from '../helpers/synthetic.ts';

/** A way to draw. */
type Technique = Pick<StudyPicture, 'method' | 'mostParts' | 'skipping'>;

/** All techniques, each of them off, and none. */
const techniques: Readonly<Record<string, Technique>> = {
  shipped: { method: 'shipped' },
  'without parts': { method: 'shipped', mostParts: 1 },
  'without skipping': { method: 'shipped', skipping: false },
  'without both': { method: 'shipped', mostParts: 1, skipping: false },
  'plain samples': { method: 'plain' },
};

/** Time to an error; null where no number of steps reaches it. */
export interface Reached {
  readonly steps: number;
  readonly error: number;
  readonly ms: number;
}

export interface QualityRow {
  readonly volume: string;
  readonly transferFunction: string;
  readonly oneAVoxel: number;
  /** By technique. */
  readonly reached: Readonly<Record<string, Reached | null>>;
}

export interface QualityOptions {
  /** Pixels along each side: of the pictures that are timed, and of those whose errors are measured. */
  readonly size: number;
  readonly errorSize: number;
  readonly repeats: number;
  /** RMSE, 1/255. */
  readonly target: number;
}

/** A thin sphere's skin in nothing. */
function shellVolume(): Volume {
  const n = 256;
  const field = (x: number, y: number, z: number): number => Math.exp(-(((Math.hypot(x - 0.5, y - 0.5, z - 0.5) - 0.35) * 60) ** 2));
  return syntheticVolume({ dimensions: [n, n, n], field });
}

/** Volumes by name, one after the other, so that one at a time is held. */
export async function* eachVolume(signal: AbortSignal): AsyncGenerator<{ name: string; volume: Volume; functions: readonly StudyFunction[] }> {
  for (const scene of studyScenes.filter(({ id }) => id !== 'ct-phantom')) {
    const volume = await loadScene(scene, signal);
    if (volume) yield { name: scene.name, volume, functions: await listFunctions(scene, volume) };
  }
  const volume = { ...shellVolume(), window: [0, 1] as const };
  yield { name: 'Thin shell (synthetic), mostly empty', volume, functions: await listFunctions(studyScenes[0], volume) };
}

const counts: readonly number[] = Array.from({ length: 24 }, (_, i) => Math.round(6 * 1.35 ** i)).filter((steps) => steps < maxSteps / 2);

/** Time to an error, for all scenes. @param tell - what is being done */
export async function measureQuality(options: QualityOptions, tell: (what: string) => void): Promise<{ renderer: string; rows: QualityRow[] }> {
  const { signal } = new AbortController();
  const gl = new StudyGl();
  const rows: QualityRow[] = [];
  for await (const { name, volume, functions } of eachVolume(signal)) {
    for (const { name: transferFunction, ...fn } of functions) {
      tell(`${name}, ${transferFunction}`);
      const base = { volume, rays: defaultRays(volume), referenceLength: defaultReferenceLength(volume), transferFunction: fn.transferFunction };
      const limit = await gl.draw({ ...base, method: 'shipped', mostParts: 1, steps: stepsOfLimit(volume) }, options.errorSize, signal);
      const reached: Record<string, Reached | null> = {};
      const found = new Map<string, { picture: StudyPicture; error: number }>();
      for (const [technique, how] of Object.entries(techniques)) {
        const hit = await findSteps(gl, { ...base, ...how, steps: 1 }, limit, options);
        if (hit) found.set(technique, hit);
        else reached[technique] = null;
      }
      const times = timeInTurns(gl, found, options);
      for (const [technique, { picture, error }] of found) reached[technique] = { steps: picture.steps, error, ms: times.get(technique)! };
      rows.push({ volume: name, transferFunction, oneAVoxel: autoSteps(volume), reached });
    }
    gl.forget(volume);
  }
  const { renderer } = gl;
  gl.dispose();
  return { renderer, rows };
}

/** The fewest steps of a list whose picture, and that of the next one, keep the error. */
async function findSteps(
  gl: StudyGl, picture: StudyPicture, limit: Float32Array, { errorSize, target }: QualityOptions,
): Promise<{ picture: StudyPicture; error: number } | null> {
  let before: { picture: StudyPicture; error: number } | null = null;
  for (const steps of counts) {
    const candidate = { ...picture, steps };
    const { rms } = comparePictures(await gl.draw(candidate, errorSize, new AbortController().signal), limit);
    if (rms > target) {
      before = null;
    } else {
      if (before) return before; // A single good number of steps may be luck.
      before = { picture: candidate, error: rms };
    }
  }
  return before;
}

function timeInTurns(gl: StudyGl, found: ReadonlyMap<string, { picture: StudyPicture }>, { size, repeats }: QualityOptions): Map<string, number> {
  const times = new Map([...found.keys()].map((technique) => [technique, [] as number[]]));
  for (let i = -1; i < repeats; i++) {
    for (const [technique, { picture }] of found) {
      const ms = gl.time(picture, size);
      if (i >= 0) times.get(technique)!.push(ms);
    }
  }
  return new Map([...times].map(([technique, list]) => {
    list.sort((a, b) => a - b);
    return [technique, list[list.length >> 1]];
  }));
}
