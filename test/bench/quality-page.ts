// In the browser: what a picture of a given error costs, and what each technique brings.
import { StudyGl } from '../../demos/accuracy/study-gl.ts';
import type { StudyPicture } from '../../demos/accuracy/study-gl.ts';
import { stepsOfLimit } from '../../demos/accuracy/study.ts';
import { defaultRays, defaultReferenceLength } from '../../demos/accuracy/study-view.ts';
import { cutSteps, listLevels } from '../../src/quality/levels.ts';
import type { Level } from '../../src/quality/levels.ts';
import { autoSteps } from '../../src/quality/steps.ts';
import { maxSteps } from '../../src/renderer/ray/compose-ray.ts';
import { compareCovered } from '../helpers/covered-error.ts';
import { eachVolume } from './bench-scenes.ts';
import { findFewest, findLevel, listCounts, remember } from './find-steps.ts';
import type { FoundSteps } from './find-steps.ts';
import { median } from './table.mjs';

/** A way to draw. With substeps it takes the element's levels; without, any number of steps from one a voxel on. */
export type Technique = Pick<StudyPicture, 'method' | 'skipping'> & { readonly hasLevels?: boolean };

/** All techniques, each of them off, none but pre-integration, and none, with any number of steps. Skipping changes no error. */
export const techniques: Readonly<Record<string, Technique>> = {
  shipped: { method: 'shipped', hasLevels: true },
  'without substeps': { method: 'shipped' },
  'without skipping': { method: 'shipped', skipping: false, hasLevels: true },
  'without both': { method: 'shipped', skipping: false },
  'plain samples': { method: 'plain' },
};

/** What larger pictures are timed with. */
const essential: readonly string[] = ['shipped', 'plain samples'];

/** Time to an error; null where it would take too long to be measured at this size. */
export interface Reached extends FoundSteps {
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
  /** E, see helpers/covered-error.ts. */
  readonly targets: readonly number[];
  readonly repeats: number;
}

/** What all pictures of a scene have in common. */
export type ScenePicture = Pick<StudyPicture, 'volume' | 'rays' | 'referenceLength' | 'transferFunction'>;

/** All scenes, each with all its transfer functions. @param notify - what is being done */
export async function* eachScene(
  gl: StudyGl,
  ids: readonly string[],
  notify: (what: string) => void,
): AsyncGenerator<{ volume: string; transferFunction: string; picture: ScenePicture }> {
  for await (const { name, volume, functions } of eachVolume(ids, new AbortController().signal)) {
    for (const { name: transferFunction, ...fn } of functions) {
      notify(`${name}, ${transferFunction}`);
      yield {
        volume: name,
        transferFunction,
        picture: {
          volume,
          rays: defaultRays(volume),
          referenceLength: defaultReferenceLength(volume),
          transferFunction: fn.transferFunction,
        },
      };
    }
    gl.forget(volume);
  }
}

/**
 * For each target the least that a technique needs to keep it, on fewer rays of the same view. The limit is drawn in
 * floats, as the pictures are.
 */
export async function findAllSteps(
  gl: StudyGl,
  picture: ScenePicture,
  names: readonly string[],
  { targets, errorSize }: QualityOptions,
): Promise<Map<number, Map<string, FoundSteps | null>>> {
  const { signal } = new AbortController();
  const limit = await gl.draw(
    { ...picture, method: 'shipped', steps: stepsOfLimit(picture.volume) },
    errorSize,
    signal,
  );
  const errorOf = async (how: Pick<StudyPicture, 'method' | 'steps' | 'maxSubsteps' | 'cut'>): Promise<number> =>
    compareCovered(await gl.draw({ ...picture, ...how }, errorSize, signal), limit, 255).e;
  const oneAVoxel = autoSteps(picture.volume.grid);
  const levels = remember((level: Level) =>
    errorOf({ method: 'shipped', steps: level.steps, cut: cutSteps(level, oneAVoxel, 1) }),
  );
  const uncut = remember((steps: number) => errorOf({ method: 'shipped', steps, maxSubsteps: 1 }));
  const plain = remember((steps: number) => errorOf({ method: 'plain', steps }));
  const find = (name: string, target: number): Promise<FoundSteps | null> => {
    const { method, hasLevels } = techniques[name];
    if (hasLevels) return findLevel(listLevels(oneAVoxel), target, levels);
    if (method === 'plain') return findFewest(listCounts(maxSteps / 2), target, plain);
    return findFewest(listCounts(maxSteps / 2, oneAVoxel), target, uncut);
  };
  const found = new Map(targets.map((target) => [target, new Map<string, FoundSteps | null>()]));
  for (const name of names) for (const target of targets) found.get(target)!.set(name, await find(name, target));
  return found;
}

/** What is drawn of a technique to keep an error. */
export function pictureOf(picture: ScenePicture, name: string, { steps, substeps }: FoundSteps): StudyPicture {
  const { method, skipping, hasLevels } = techniques[name];
  const cut = hasLevels ? cutSteps({ steps, substeps: substeps ?? 1 }, autoSteps(picture.volume.grid), 1) : undefined;
  return { ...picture, method, skipping, steps, maxSubsteps: 1, cut };
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
  gl: StudyGl,
  pictures: ReadonlyMap<string, StudyPicture>,
  { size, repeats }: { size: number; repeats: number },
): Map<string, number> {
  const times = new Map([...pictures].map(([name, picture]) => [name, [gl.time(picture, size)]]));
  const quick = [...pictures]
    .map(([name, picture]) => ({ name, picture, first: times.get(name)![0] }))
    .filter(({ first }) => first <= slow);
  for (const { name } of quick) times.set(name, []);
  for (let i = 0; i < repeats; i++) {
    for (const { name, picture, first } of quick) {
      times
        .get(name)!
        .push(gl.time(picture, size, Math.min(maxPictures, Math.max(1, Math.round(shortest / Math.max(first, 0.01))))));
    }
  }
  return new Map([...times].map(([name, list]) => [name, median(list)]));
}

/** Time to an error, for all scenes. @param notify - what is being done */
export async function measureQuality(options: QualityOptions, notify: (what: string) => void): Promise<QualityRow[]> {
  const gl = new StudyGl();
  const rows: QualityRow[] = [];
  for await (const { volume, transferFunction, picture } of eachScene(gl, options.scenes, notify)) {
    const found = await findAllSteps(gl, picture, Object.keys(techniques), options);
    const [first, ...further] = options.sizes;
    const full = timeAll(
      gl,
      { picture, found, names: Object.keys(techniques) },
      { size: first, repeats: options.repeats },
    );
    rows.push({ volume, transferFunction, size: first, reached: full });
    for (const size of further) {
      const isShort = (target: number, name: string): boolean =>
        (full[target][name]?.ms ?? 0) * (size / first) ** 2 <= longest;
      const reached = timeAll(gl, { picture, found, names: essential, isShort }, { size, repeats: options.repeats });
      rows.push({ volume, transferFunction, size, reached });
    }
  }
  gl.dispose();
  return rows;
}

/** What is timed of a scene, and how its steps were found. */
interface Timed {
  readonly picture: ScenePicture;
  readonly found: ReadonlyMap<number, ReadonlyMap<string, FoundSteps | null>>;
  readonly names: readonly string[];
  readonly isShort?: (target: number, name: string) => boolean;
}

function timeAll(
  gl: StudyGl,
  { picture, found, names, isShort = () => true }: Timed,
  how: { size: number; repeats: number },
): QualityRow['reached'] {
  return Object.fromEntries(
    [...found].map(([target, byName]) => {
      const pictures = new Map<string, StudyPicture>();
      for (const name of names) {
        const one = byName.get(name);
        if (one && isShort(target, name)) pictures.set(name, pictureOf(picture, name, one));
      }
      const times = timeInTurns(gl, pictures, how);
      return [
        target,
        Object.fromEntries(
          names.map((name) => {
            const one = byName.get(name);
            return [name, one ? { ...one, ms: times.get(name) ?? null } : null];
          }),
        ),
      ];
    }),
  );
}
