// In the browser: what a picture of a given error costs, and what each technique brings.
import { comparePictures } from '../../demos/accuracy/compare-pictures.ts';
import { StudyGl } from '../../demos/accuracy/study-gl.ts';
import type { StudyPicture } from '../../demos/accuracy/study-gl.ts';
import { stepsOfLimit } from '../../demos/accuracy/study.ts';
import { defaultRays, defaultReferenceLength } from '../../demos/accuracy/study-view.ts';
import { allRays } from '../../src/quality/adaptive-sampling.ts';
import { maxSteps } from '../../src/renderer/ray/compose-ray.ts';
import { eachVolume } from './bench-scenes.ts';
import { findFewest, listCounts, remember } from './find-steps.ts';
import type { FoundSteps } from './find-steps.ts';
import { AdaptiveErrors } from './find-adaptive.ts';
import type { FoundAdaptive } from './find-adaptive.ts';
import { median } from './table.mjs';

/** A way to draw. */
export type Technique = Pick<StudyPicture, 'method' | 'maxSubsteps' | 'skipping'> & { readonly sampling?: boolean };

/** All techniques, each of them off, none but pre-integration, and none. Skipping changes no error. */
export const techniques: Readonly<Record<string, Technique>> = {
  shipped: { method: 'shipped', sampling: true },
  'without adaptive sampling': { method: 'shipped' },
  'without substeps': { method: 'shipped', maxSubsteps: 1, sampling: true },
  'without skipping': { method: 'shipped', skipping: false, sampling: true },
  'without all three': { method: 'shipped', maxSubsteps: 1, skipping: false },
  'plain samples': { method: 'plain' },
};

/** What larger pictures are timed with. */
const essential: readonly string[] = ['shipped', 'plain samples'];

/** Time to an error; null where it would take too long to be measured at this size. */
export interface Reached extends FoundAdaptive {
  readonly ms: number | null;
}

/** One scene at one size. */
export interface QualityRow {
  readonly volume: string;
  readonly transferFunction: string;
  readonly size: number;
  /** By target, then by technique; null where no number of steps reaches it. */
  readonly reached: Readonly<Record<number, Readonly<Record<string, Reached | null>>>>;
}

export interface QualityOptions {
  /** Ids of bench-scenes.ts. */
  readonly scenes: readonly string[];
  /** Pixels along each side of the pictures that are timed; all techniques at the first, the essential at others. */
  readonly sizes: readonly number[];
  /** Rays along each side of the pictures whose errors are measured, of the same view. */
  readonly errorSize: number;
  /** RMSE, 1/255. */
  readonly targets: readonly number[];
  readonly repeats: number;
}

const counts = listCounts(maxSteps / 2);

/** What all pictures of a scene have in common. */
export type ScenePicture = Pick<StudyPicture, 'volume' | 'rays' | 'referenceLength' | 'transferFunction'>;

/** All scenes, each with all its transfer functions. @param tell - what is being done */
export async function* eachScene(
  gl: StudyGl, ids: readonly string[], tell: (what: string) => void,
): AsyncGenerator<{ volume: string; transferFunction: string; picture: ScenePicture }> {
  for await (const { name, volume, functions } of eachVolume(ids, new AbortController().signal)) {
    for (const { name: transferFunction, ...fn } of functions) {
      tell(`${name}, ${transferFunction}`);
      yield {
        volume: name,
        transferFunction,
        picture: { volume, rays: defaultRays(volume), referenceLength: defaultReferenceLength(volume), transferFunction: fn.transferFunction },
      };
    }
    gl.forget(volume);
  }
}

/**
 * For each target the fewest steps of a technique that keep it with all rays, on fewer rays of the same view. The limit is
 * drawn in floats, as the pictures are.
 */
export async function findAllSteps(
  gl: StudyGl, picture: ScenePicture, names: readonly string[], { targets, errorSize }: QualityOptions,
): Promise<Map<number, Map<string, FoundSteps | null>>> {
  const { signal } = new AbortController();
  const limit = await gl.draw({ ...picture, method: 'shipped', maxSubsteps: 1, steps: stepsOfLimit(picture.volume) }, errorSize, signal);
  const found = new Map(targets.map((target) => [target, new Map<string, FoundSteps | null>()]));
  const errors = new Map<string, (steps: number) => Promise<number>>();
  for (const name of names) {
    const { method, maxSubsteps } = techniques[name];
    const key = `${method} ${maxSubsteps}`;
    const errorOf = errors.get(key) ?? remember(async (steps) =>
      comparePictures(await gl.draw({ ...picture, method, maxSubsteps, steps }, errorSize, signal), limit).rms);
    errors.set(key, errorOf);
    for (const target of targets) found.get(target)!.set(name, await findFewest(counts, target, errorOf));
  }
  return found;
}

/** The same with adaptive ray sampling, whose errors depend on the size. */
export async function adaptAll(
  gl: StudyGl, picture: ScenePicture, found: ReadonlyMap<number, ReadonlyMap<string, FoundSteps | null>>, { size, errorSize }: { size: number; errorSize: number },
): Promise<Map<number, Map<string, FoundAdaptive | null>>> {
  const bySubsteps = new Map<number | undefined, AdaptiveErrors>();
  const adapted = new Map<number, Map<string, FoundAdaptive | null>>();
  for (const [target, byName] of found) {
    const known = new Map<number | undefined, FoundAdaptive>();
    const row = new Map<string, FoundAdaptive | null>();
    for (const [name, one] of byName) {
      const { method, maxSubsteps, sampling } = techniques[name];
      if (!one || !sampling) {
        row.set(name, one && { ...one, sampling: allRays });
        continue;
      }
      const errors = bySubsteps.get(maxSubsteps) ?? new AdaptiveErrors(gl, { ...picture, method, maxSubsteps }, size, errorSize);
      bySubsteps.set(maxSubsteps, errors);
      const best = known.get(maxSubsteps) ?? await errors.find(target, one, counts);
      known.set(maxSubsteps, best);
      row.set(name, best);
    }
    adapted.set(target, row);
  }
  return adapted;
}

/** What is drawn of a technique to keep an error. */
export function pictureOf(picture: ScenePicture, name: string, { steps, sampling }: FoundAdaptive): StudyPicture {
  const { method, maxSubsteps, skipping } = techniques[name];
  return { ...picture, method, maxSubsteps, skipping, steps, maxCurvature: sampling.maxCurvature };
}

/** A picture that would take longer at a further size, by what it took at the first, is not drawn again, ms. */
const longest = 10_000;

/** A time shorter than this is taken over several pictures, as clocks are coarse, ms. */
const shortest = 20;

/** Maximum number of pictures for one time. */
const maxPictures = 50;

/** Of a picture that takes longer, one is drawn: what blurs times is small beside it, ms. */
const slow = 1000;

/**
 * Medians of times, ms, by name; the pictures take turns, so that all see the same machine, after one to warm up. A slow
 * picture's first one counts.
 */
export function timeInTurns(
  gl: StudyGl, pictures: ReadonlyMap<string, StudyPicture>, { size, repeats }: { size: number; repeats: number },
): Map<string, number> {
  const times = new Map([...pictures].map(([name, picture]) => [name, [gl.time(picture, size)]]));
  const quick = [...pictures].map(([name, picture]) => ({ name, picture, first: times.get(name)![0] })).filter(({ first }) => first <= slow);
  for (const { name } of quick) times.set(name, []);
  for (let i = 0; i < repeats; i++) {
    for (const { name, picture, first } of quick) {
      times.get(name)!.push(gl.time(picture, size, Math.min(maxPictures, Math.max(1, Math.round(shortest / Math.max(first, 0.01))))));
    }
  }
  return new Map([...times].map(([name, list]) => [name, median(list)]));
}

/** Time to an error, for all scenes. @param tell - what is being done */
export async function measureQuality(options: QualityOptions, tell: (what: string) => void): Promise<QualityRow[]> {
  const gl = new StudyGl();
  const rows: QualityRow[] = [];
  for await (const { volume, transferFunction, picture } of eachScene(gl, options.scenes, tell)) {
    const found = await findAllSteps(gl, picture, Object.keys(techniques), options);
    const [first, ...further] = options.sizes;
    const sized = async (size: number): Promise<Omit<Timed, 'names'>> => ({ picture, found: await adaptAll(gl, picture, found, { size, errorSize: options.errorSize }) });
    const full = timeAll(gl, { ...(await sized(first)), names: Object.keys(techniques) }, { size: first, repeats: options.repeats });
    rows.push({ volume, transferFunction, size: first, reached: full });
    for (const size of further) {
      const isShort = (target: number, name: string): boolean => (full[target][name]?.ms ?? 0) * (size / first) ** 2 <= longest;
      const reached = timeAll(gl, { ...(await sized(size)), names: essential, isShort }, { size, repeats: options.repeats });
      rows.push({ volume, transferFunction, size, reached });
    }
  }
  gl.dispose();
  return rows;
}

/** What is timed of a scene, and how its steps were found. */
interface Timed {
  readonly picture: ScenePicture;
  readonly found: ReadonlyMap<number, ReadonlyMap<string, FoundAdaptive | null>>;
  readonly names: readonly string[];
  readonly isShort?: (target: number, name: string) => boolean;
}

function timeAll(gl: StudyGl, { picture, found, names, isShort = () => true }: Timed, how: { size: number; repeats: number }): QualityRow['reached'] {
  return Object.fromEntries([...found].map(([target, byName]) => {
    const pictures = new Map<string, StudyPicture>();
    for (const name of names) {
      const one = byName.get(name);
      if (one && isShort(target, name)) pictures.set(name, pictureOf(picture, name, one));
    }
    const times = timeInTurns(gl, pictures, how);
    return [target, Object.fromEntries(names.map((name) => {
      const one = byName.get(name);
      return [name, one ? { ...one, ms: times.get(name) ?? null } : null];
    }))];
  }));
}
