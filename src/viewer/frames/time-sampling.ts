import { stepsPerProbe, stepsPerRay } from '../../quality/frame-plan.ts';
import type { SamplingOutcome } from '../../quality/sampling-outcome.ts';
import { stepLengthOf } from '../../quality/steps.ts';
import type { DrawnView } from '../model/drawn-view.ts';
import type { Scene } from '../model/scene.ts';

/** Pictures that are timed have so many steps, */
const steps = 64;

/** and this share of the pixels along each axis. */
const scale = 0.5;

/** Times of each kind that are compared. */
const turns = 3;

/** A picture that takes longer, ms, is timed once. */
const slow = 50;

/** Of one that takes less, ms, the page's clock says little: it is rounded, and the page learns some milliseconds late of its end. */
const fast = 10;

/** Outcomes that cast more rays than this share tell little of what sparing rays saves. */
const largestShare = 0.5;

/** How many times as long as foretold pictures with spared rays may take, and how few. */
const limits = [0.25, 16] as const;

/** It is the graphics processor's, so one measure holds for a scene. */
const measured = new WeakMap<Scene, number>();

/**
 * What spared rays take, over what they would take if rays were all that takes time: some renderers handle the small pieces that they are
 * drawn in slowly. Drawn aside, in turns with pictures that have all rays.
 * @param outcomes - foretold for such pictures
 * @returns 1 where nothing could be measured, or all is fast
 */
export async function timeSampling(view: DrawnView, outcomes: readonly SamplingOutcome[]): Promise<number> {
  const { scene } = view;
  const known = measured.get(scene);
  if (known !== undefined) return known;
  const outcome = outcomes.find(({ share }) => share <= largestShare);
  if (!outcome || !scene.gatherable || scene.endsAtShapes) return 1;
  const [all, spared]: number[][] = [[], []];
  const kinds = [[0, all], [outcome.maxCurvature, spared]] as const;
  try {
    // In the first turn programs are compiled.
    for (let turn = 0; turn <= turns && (all[1] ?? 0) <= slow; turn++) {
      for (const [maxCurvature, times] of kinds) {
        if (!view.goesOn()) return 1;
        times.push(await draw(view, maxCurvature));
      }
    }
  } finally {
    scene.setMaxCurvature(0);
  }
  const foretold = (outcome.share * (steps + stepsPerRay) + stepsPerProbe) / (steps + stepsPerRay);
  const [allMs, sparedMs] = [all, spared].map((times) => Math.min(...times.slice(1)));
  const cost = Math.max(allMs, sparedMs) < fast ? 1 : Math.max(limits[0], Math.min(limits[1], sparedMs / allMs / foretold));
  measured.set(scene, cost);
  return cost;
}

/** @returns ms */
async function draw({ scene, grid, size }: DrawnView, maxCurvature: number): Promise<number> {
  const picture = { width: Math.max(1, Math.round(scale * size.width)), height: Math.max(1, Math.round(scale * size.height)) };
  scene.setMaxCurvature(maxCurvature);
  const began = performance.now();
  for (const pass of scene.passes(picture)) scene.gather(stepLengthOf(grid, steps), { pass, firstRow: 0, rows: pass.height }, picture);
  await scene.finished();
  return performance.now() - began;
}
