import type { FunctionResults, TimeRow } from './results.ts';
import { describePicture, listSteps, resolutionSteps, studyMethods, studySteps } from './scene-setup.ts';
import type { SceneSetup, StudyOptions } from './scene-setup.ts';
import type { StudyGl, StudyPicture } from './study-gl.ts';

/** A time shorter than this is taken over several pictures, as clocks are coarse, ms. */
const shortest = 20;

/** Maximum number of pictures for one time. */
const maxPictures = 50;

interface Timed extends Omit<TimeRow, 'ms'> {
  readonly picture: StudyPicture;
  readonly repeat: number;
  readonly times: number[];
}

/**
 * Time all methods with the smooth transfer function. Every picture is drawn once to warm up; then they take turns, so
 * that all see the same machine, and the medians count.
 */
export async function timePictures(
  gl: StudyGl,
  scene: { setup: SceneSetup; reduced: ReadonlyMap<50 | 25, SceneSetup>; results: FunctionResults },
  { timeSize, repeats, signal, onProgress }: StudyOptions,
): Promise<TimeRow[]> {
  const { setup, reduced, results } = scene;
  const steps = listSteps(setup.volume, studySteps);
  const wanted = [
    ...studyMethods.map((method) => ({ percent: 100 as const, setup, method, steps })),
    ...[...reduced].map(([percent, one]) => ({
      percent,
      setup: one,
      method: 'shipped' as const,
      steps: resolutionSteps,
    })),
  ];
  const timed: Timed[] = wanted.flatMap(({ method, ...one }) =>
    one.steps.map((count) => {
      const picture = describePicture(one.setup, setup.functions[0], { method, steps: count, paper: results.paper });
      const warm = gl.time(picture, timeSize);
      const repeat = Math.min(maxPictures, Math.max(1, Math.round(shortest / Math.max(warm, 0.01))));
      return { percent: one.percent, method, steps: count, picture, repeat, times: [] };
    }),
  );
  for (let i = 0; i < repeats; i++) {
    for (const one of timed) {
      signal.throwIfAborted();
      one.times.push(gl.time(one.picture, timeSize, one.repeat));
      await new Promise((resolve) => setTimeout(resolve));
    }
    onProgress(0.75 + (0.25 * (i + 1)) / repeats, 'times');
  }
  return timed.map(({ percent, method, steps: count, times }) => ({
    percent,
    method,
    steps: count,
    ms: median(times),
  }));
}

export function median(values: readonly number[]): number {
  const sorted = Float64Array.from(values);
  sorted.sort();
  const middle = sorted.length >> 1;
  return sorted.length % 2 ? sorted[middle] : (sorted[middle - 1] + sorted[middle]) / 2;
}
