import { stepsPerProbe, stepsPerRay } from '../../quality/frame-quality.ts';
import type { SamplingOutcome } from '../../quality/sampling-outcome.ts';
import { stepLengthOf } from '../../quality/steps.ts';
import type { DrawnView } from '../model/drawn-view.ts';
import type { Scene } from '../model/scene.ts';

/** Number of steps in the pictures that are timed, */
const steps = 64;

/** and their share of the pixels along each axis. */
const scale = 0.5;

/** How often each kind is timed. */
const turns = 3;

/** A picture that takes longer than this, ms, is timed only once. */
const slow = 50;

/**
 * For a picture that takes less than this, ms, the page's clock is too coarse: it is rounded, and the page gets the end of drawing
 * some milliseconds late.
 */
const fast = 10;

/** If an outcome casts more rays than this share, its time says little about the gain of fewer rays. */
const largestShare = 0.5;

/** Smallest and largest factor between the measured and the predicted time of pictures with fewer rays. */
const limits = [0.25, 16] as const;

/** The factor depends on the GPU only, so one measurement is enough for a scene. */
const measured = new WeakMap<Scene, number>();

/**
 * The time of pictures with fewer rays, relative to the time that they would take if only rays took time: some renderers are slow
 * with the small pieces in which such rays are drawn. Drawn off screen, in turns with pictures that have all rays.
 * @param outcomes - predicted for such pictures
 * @returns 1 where nothing could be measured, or all pictures are fast
 */
export async function timeSampling(view: DrawnView, outcomes: readonly SamplingOutcome[]): Promise<number> {
  const { scene } = view;
  const known = measured.get(scene);
  if (known !== undefined) return known;
  const outcome = outcomes.find(({ share }) => share <= largestShare);
  if (!outcome || !scene.gatherable || scene.endsAtShapes) return 1;
  const [all, spared]: number[][] = [[], []];
  const kinds = [
    [0, all],
    [outcome.maxCurvature, spared],
  ] as const;
  // The first turn compiles the programs.
  for (let turn = 0; turn <= turns && (all[1] ?? 0) <= slow; turn++) {
    for (const [maxCurvature, times] of kinds) {
      if (!view.goesOn()) return 1;
      times.push(await draw(view, maxCurvature));
    }
  }
  const foretold = (outcome.share * (steps + stepsPerRay) + stepsPerProbe) / (steps + stepsPerRay);
  const [allMs, sparedMs] = [all, spared].map((times) => Math.min(...times.slice(1)));
  const cost =
    Math.max(allMs, sparedMs) < fast ? 1 : Math.max(limits[0], Math.min(limits[1], sparedMs / allMs / foretold));
  measured.set(scene, cost);
  return cost;
}

/** @returns ms */
async function draw({ scene, grid, size }: DrawnView, maxCurvature: number): Promise<number> {
  const picture = {
    width: Math.max(1, Math.round(scale * size.width)),
    height: Math.max(1, Math.round(scale * size.height)),
  };
  const rays = { stepLength: stepLengthOf(grid, steps), maxCurvature, edgeCurvature: Infinity };
  const began = performance.now();
  for (const pass of scene.startGathering(rays, picture))
    scene.gather(rays, { pass, firstRow: 0, rows: pass.height }, picture);
  await scene.finished();
  return performance.now() - began;
}
