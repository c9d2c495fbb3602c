// In the browser: what is stated of scenes that were made to break it, and what is true of them.
import { fieldProviders } from '../../components/field-providers.ts';
import type { PictureError } from '../../src/quality/error-estimate.ts';
import { VolumeScene } from '../../src/x3d/scene.ts';
import { measureAtRest } from '../helpers/at-rest.ts';
import type { CoveredError } from '../helpers/covered-error.ts';
import { hardScenes } from './hard-scenes.ts';

/** What is stated of a scene's error, and what it is. */
export interface HardResult {
  readonly kind: string;
  readonly name: string;
  readonly maxError: number;
  readonly stats: { readonly error: PictureError; readonly keepsMaxError: boolean };
  readonly error: CoveredError;
  readonly level: { readonly samplesAVoxel: number; readonly substeps: number };
  /** Milliseconds until the picture was at rest, and the truth known. */
  readonly ms: number;
}

/** All scenes' names, with their kinds. */
export function listHard(): string[] {
  return hardScenes.map(({ kind, name }) => `${kind}: ${name}`);
}

/** @param wanted - as `listHard` names them @param tell - what is being done */
export async function measureHard(wanted: readonly string[], tell: (what: string) => void): Promise<HardResult[]> {
  const results: HardResult[] = [];
  for (const { kind, name, make } of hardScenes) {
    if (!wanted.includes(`${kind}: ${name}`)) continue;
    tell(`scene ${results.length + 1} of ${wanted.length}: ${kind}: ${name}`);
    const host = document.createElement('div');
    document.body.append(host);
    // Each has a scene of its own: nothing of the one before is left.
    const gpu = await VolumeScene.create(host, host, () => {}, fieldProviders);
    const scene = make();
    const began = performance.now();
    const { stated, isKept, error, samplesAVoxel, level: { substeps } } = await measureAtRest(gpu, scene, true);
    results.push({ kind, name, maxError: scene.maxError ?? 1, stats: { error: stated, keepsMaxError: isKept }, error, level: { samplesAVoxel, substeps }, ms: performance.now() - began });
    gpu.dispose();
    host.remove();
  }
  return results;
}
