import { autoSteps } from '../../src/quality/steps.ts';
import type { StudyMethod } from '../../src/renderer/study.ts';
import type { Volume } from '../../src/volume/volume.ts';
import { quantizeTo8Bits } from './derive-volumes.ts';
import { listFunctions, loadScene, studyScenes } from './scenes.ts';
import type { StudyFunction, StudyScene } from './scenes.ts';
import type { StudyPicture } from './study-gl.ts';
import { defaultRays, defaultReferenceLength } from './study-view.ts';

export const studyMethods: readonly StudyMethod[] = ['printed', 'plain', 'shipped'];

/** Steps of the study: the paper's, and a decade to both sides. One step a voxel is added for each volume. */
export const studySteps: readonly number[] = [10, 20, 40, 80, 140, 200, 400, 800, 2000];

/** Steps of the paper's figure 7, and one more, for the coarser grids. */
export const resolutionSteps: readonly number[] = [20, 50, 80, 200];

/** Steps in ascending order, with one step a voxel among them. */
export function listSteps(volume: Volume, steps: readonly number[]): readonly number[] {
  const all = [...new Set([...steps, autoSteps(volume.grid)])];
  all.sort((a, b) => a - b);
  return all;
}

export interface StudyOptions {
  readonly scenes: readonly string[];
  /** Pixels along each side, where errors are measured. */
  readonly size: number;
  /** Pixels along each side, where times are measured. */
  readonly timeSize: number;
  /** Scenes that are timed. */
  readonly timed: readonly string[];
  /** Timed draws of each picture; the median counts. */
  readonly repeats: number;
  readonly signal: AbortSignal;
  /** @param share - of the work that is done, 0..1 */
  readonly onProgress: (share: number, what: string) => void;
}

/** Everything that the pictures of one scene have in common. */
export interface SceneSetup extends Pick<StudyScene, 'id' | 'name'> {
  readonly volume: Volume;
  readonly eightBits: Volume;
  readonly functions: readonly StudyFunction[];
  readonly base: Pick<StudyPicture, 'rays' | 'referenceLength'>;
}

/** Load a scene, or null where its data are not here. */
export async function setUpScene(id: string, signal: AbortSignal): Promise<SceneSetup | null> {
  const scene = studyScenes.find((one) => one.id === id);
  if (!scene) throw new Error(`no scene "${id}"`);
  const volume = await loadScene(scene, signal);
  if (!volume) return null;
  const base = { rays: defaultRays(volume), referenceLength: defaultReferenceLength(volume) };
  const functions = await listFunctions(scene, volume);
  return { id, name: scene.name, volume, eightBits: quantizeTo8Bits(volume), functions, base };
}

/** One picture of a scene: the paper's method is given the data in 8 bits. */
export function describePicture(
  setup: SceneSetup,
  fn: StudyFunction,
  { method, steps, paper, maxSubsteps }: Pick<StudyPicture, 'method' | 'steps' | 'paper' | 'maxSubsteps'>,
): StudyPicture {
  const volume = method === 'printed' ? setup.eightBits : setup.volume;
  return { ...setup.base, volume, transferFunction: fn.transferFunction, method, steps, paper, maxSubsteps };
}
