// In the browser: pictures of surfaces at rest with smooth edges against the same with one ray a pixel.
import { findEdges } from '../../src/optics/rays/edge-rays.ts';
import type { IsoSurface } from '../../src/optics/rays/ray-style.ts';
import { resolveTransferFunction } from '../../src/optics/transfer/resolve-transfer-function.ts';
import { cutSteps } from '../../src/quality/levels.ts';
import { autoSteps, stepLengthOf } from '../../src/quality/steps.ts';
import { changePlan, drawAt } from '../helpers/change-plan.ts';
import { loadScan } from './lit-scenes.ts';
import { median } from './table.mjs';
import { openTurnScene, processorSeconds } from './turns.ts';

interface EdgeScene {
  readonly name: string;
  readonly url: string;
  readonly surfaces: readonly IsoSurface[];
  readonly look?: string;
}

export interface EdgeRow {
  readonly scene: string;
  /** Pixels with an edge, as shares of all and of those in which something is seen. */
  readonly edges: number;
  readonly ofSeen: number;
  /** Median of processor time, ms, with one ray a pixel. */
  readonly plain: number;
  /** Medians of those of each turn, of processor time and of the clock's. */
  readonly ratio: number;
  readonly clock: number;
}

const surface = (value: number, opacity = 1): IsoSurface => ({ value, color: [0.95, 0.9, 0.8], opacity });
const torso = '/demos/data/ct-phantom.nii.gz';
const brain = '/demos/data/mni152-t1.nii.gz';

const scenes: readonly EdgeScene[] = [
  { name: 'CT of a torso, bones', url: torso, surfaces: [surface(250)] },
  { name: 'CT of a torso, bones under skin', url: torso, surfaces: [surface(-300, 0.25), surface(250)] },
  { name: 'CT of a torso, bones in fog', url: torso, surfaces: [surface(250)], look: 'ct-soft-tissue' },
  { name: 'MRI of a brain, white matter', url: brain, surfaces: [surface(72)] },
  { name: 'MRI of a brain, two surfaces', url: brain, surfaces: [surface(35, 0.3), surface(72)] },
  {
    name: 'radar, synthetic storm',
    url: '/demos/data/storm-radar-1510.json',
    surfaces: [surface(20, 0.3), surface(40)],
  },
];

/** Pixels with more curvature get more rays, 1/255: at `max-error` 1. */
export const edgeCurvature = 8 * Math.sqrt(12);

export async function compareEdges(size: number, turns: number, chosen: readonly string[]): Promise<EdgeRow[]> {
  const rows: EdgeRow[] = [];
  for (const one of scenes.filter(({ name }) => chosen.length === 0 || chosen.some((begin) => name.includes(begin))))
    rows.push(await compareScene(one, size, turns));
  return rows;
}

async function compareScene(
  { name, url, surfaces, look: appearance }: EdgeScene,
  size: number,
  turns: number,
): Promise<EdgeRow> {
  const volume = await loadScan(url);
  const transferFunction = await resolveTransferFunction(appearance ?? 'gray', volume.range);
  const { scene, dispose } = await openTurnScene({ volume, transferFunction, referenceLength: 0.01, size });
  await scene.setAppearance({ style: appearance ? { surfaces } : { surfaces, clear: true } });
  const steps = autoSteps(volume.grid);
  changePlan(scene, { substeps: cutSteps({ steps, substeps: 1 }, steps, 1) });
  const time = async (max: number): Promise<{ work: number; clock: number }> => {
    const [before, start] = [await processorSeconds(), performance.now()];
    changePlan(scene, { maxCurvature: 0, edgeCurvature: max });
    drawAt(scene, stepLengthOf(volume.grid, steps));
    scene.readPicture();
    await scene.finished();
    return { work: 1000 * ((await processorSeconds()) - before), clock: performance.now() - start };
  };
  await time(edgeCurvature); // Compiles.
  await time(Infinity);
  const picture = scene.readPicture();
  const edges = 4 * findEdges(picture, edgeCurvature).length;
  const seen = picture.data.reduce((sum, x, i) => sum + Number(i % 4 === 3 && x > 0), 0);
  const taken: { plain: { work: number; clock: number }; smooth: { work: number; clock: number } }[] = [];
  for (let turn = 0; turn < turns; turn++)
    taken.push({ plain: await time(Infinity), smooth: await time(edgeCurvature) });
  dispose();
  return {
    scene: name,
    edges: edges / (size * size),
    ofSeen: edges / seen,
    plain: median(taken.map(({ plain }) => plain.work)),
    ratio: median(taken.map(({ plain, smooth }) => smooth.work / plain.work)),
    clock: median(taken.map(({ plain, smooth }) => smooth.clock / plain.clock)),
  };
}
