import type { StudyMethod } from '../../src/renderer/study.ts';
import type { FunctionResults, SceneResults, StudyResults } from './results.ts';
import { error } from './tables.ts';

/** Root mean square that was aimed at with one sample per voxel, 1/255. */
const aims = { smooth: 1, peaks: 2 } as const;

/** Root mean square that rounding to 8 bits makes, 1/255. */
const rounding = 1 / Math.sqrt(12);

/** What a reader should know first, in words and numbers of the data. */
export function describeResults({ scenes }: StudyResults): string {
  const scene = scenes[0];
  const fn = scene?.functions[0];
  if (!fn) return 'Nothing has been measured yet.';
  const at = (method: StudyMethod, steps: number): string =>
    error(fn.errors.find((row) => row.method === method && row.steps === steps)!.rms);
  const min = Math.min(...fn.errors.filter(({ method }) => method === 'printed').map(({ rms }) => rms));
  const atVoxel = errorAtVoxel(scene, fn.id, 'shipped');
  return (
    `${scene.name}: with 40 steps the picture is off by ${at('shipped', 40)} of 255, with 80 by ${at('shipped', 80)}, with 200 by ` +
    `${at('shipped', 200)}, and with one sample per voxel, ${scene.voxelSteps} steps, by ${error(atVoxel)}` +
    `${atVoxel < rounding ? ', less than a screen can show' : ''}. The method of the 2011 paper stays at ${error(min)} or more, ` +
    `however many steps it takes. Plain samples are off by ${at('plain', scene.voxelSteps)} here, and through narrow peaks by ` +
    `${error(errorAtVoxel(scene, 'peaks', 'plain'))}, volume-view by ${error(errorAtVoxel(scene, 'peaks', 'shipped'))}.`
  );
}

/** Whether the aims were reached, and what the methods are to each other with one sample per voxel; a Markdown list. */
export function listFindings({ scenes }: StudyResults): string {
  const lines = (['smooth', 'peaks'] as const).map((id) => {
    const rows = scenes.map((scene) => ({ name: scene.name, rms: errorAtVoxel(scene, id, 'shipped') }));
    const missed = rows.filter(({ rms }) => rms > aims[id]);
    const words =
      missed.length === 0
        ? 'in all'
        : `in ${rows.length - missed.length} of ${rows.length}; missed: ${missed.map(({ name, rms }) => `${name}, ${error(rms)}`).join('; ')}`;
    return `- ${id === 'smooth' ? 'Smooth: at most 1/255' : 'Narrow peaks: at most 2/255'}, kept ${words}.`;
  });
  const shares = (['smooth', 'peaks', 'step'] as const).map((id) => {
    const ratios = scenes.map((scene) => errorAtVoxel(scene, id, 'plain') / errorAtVoxel(scene, id, 'shipped'));
    return `${Math.min(...ratios).toFixed(1)} to ${Math.max(...ratios).toFixed(1)} with ${{ smooth: 'smooth functions', peaks: 'the peaks', step: 'the opaque step' }[id]}`;
  });
  return [...lines, `- Error of plain samples as a multiple of volume-view's: ${shares.join(', ')}.`].join('\n');
}

function errorAtVoxel(scene: SceneResults, id: string, method: StudyMethod): number {
  const fn: FunctionResults = scene.functions.find((one) => one.id === id)!;
  return fn.errors.find((row) => row.method === method && row.steps === scene.voxelSteps)!.rms;
}
