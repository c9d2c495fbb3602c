// In the browser: what is stated of scenes that were made to break it, and what is true of them.
import { fieldProviders } from '../../components/internal/field-providers.ts';
import type { PictureError } from '../../src/quality/error-estimate.ts';
import { VolumeScene } from '../../src/x3d/scene.ts';
import { measureAtRest } from '../helpers/at-rest.ts';
import type { CoveredError } from '../helpers/covered-error.ts';
import { hardScenes } from './hard-scenes.ts';
import '../helpers/provide-substeps.ts';

/** What is stated of a scene's error, and what it is. */
export interface HardResult {
  readonly kind: string;
  readonly name: string;
  readonly maxError: number;
  /** Whether nothing of the volume can be in the picture. */
  readonly isOutOfSight: boolean;
  readonly stats: { readonly error: PictureError; readonly keepsMaxError: boolean };
  readonly error: CoveredError;
  readonly level: { readonly samplesAVoxel: number; readonly substeps: number };
}

/** All scenes' names, with their kinds. */
export function listHard(): string[] {
  return hardScenes.map(({ kind, name }) => `${kind}: ${name}`);
}

/** @param wanted - as `listHard` names it */
export async function measureHard(wanted: string): Promise<HardResult> {
  const { kind, name, make } = hardScenes.find((one) => `${one.kind}: ${one.name}` === wanted)!;
  const host = document.createElement('div');
  document.body.append(host);
  // Each has a scene of its own: nothing of the one before is left.
  const gpu = await VolumeScene.create(host, host, () => {}, fieldProviders);
  const scene = make();
  const {
    stated,
    isKept,
    error,
    samplesAVoxel,
    level: { substeps },
  } = await measureAtRest(gpu, scene, true);
  gpu.dispose();
  host.remove();
  return {
    kind,
    name,
    maxError: scene.maxError ?? 1,
    isOutOfSight: scene.isOutOfSight ?? false,
    stats: { error: stated, keepsMaxError: isKept },
    error,
    level: { samplesAVoxel, substeps },
  };
}
