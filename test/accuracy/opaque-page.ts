// In the browser: what is stated of pictures with opaque steps, and what is true of them.
import { fieldProviders } from '../../components/internal/field-providers.ts';
import { allSubsteps } from '../../src/optics/cells/substeps.ts';
import type { PictureError } from '../../src/quality/error-estimate.ts';
import { autoSteps, stepLengthOf } from '../../src/quality/steps.ts';
import { VolumeScene } from '../../src/x3d/scene.ts';
import { changePlan } from '../helpers/change-plan.ts';
import { drawAtRest, measureAtRest } from '../helpers/at-rest.ts';
import { compareCovered } from '../helpers/covered-error.ts';
import type { CoveredError } from '../helpers/covered-error.ts';
import { probe } from '../helpers/probe.ts';
import { measureTrueError } from './compare-shown.ts';
import { ExactCells } from './exact-cells.ts';
import { listOpaqueScenes } from './opaque-scenes.ts';
import '../helpers/provide-substeps.ts';

/** What is stated of a scene's error, and what it is. */
export interface OpaqueResult {
  readonly kind: string;
  readonly name: string;
  readonly maxError: number;
  readonly stats: { readonly error: PictureError; readonly keepsMaxError: boolean };
  readonly error: CoveredError;
  /** Pixels that are off by more than 8/255; null where they were not counted. */
  readonly off: number | null;
  readonly level: { readonly samplesAVoxel: number; readonly substeps: number };
  /** E of the finest picture of no more than 2,048 steps; null where `max-error` is kept, and where it is not known. */
  readonly finest: number | null;
  readonly webgl: number;
}

/** No picture that could be kept with so many steps may stop before. */
const affordable = 2048;

/** @param called - a volume, see `opaqueVolumes` @param notify - what is being done @returns null where there is no such file */
export async function measureOpaque(called: string, notify: (what: string) => void): Promise<OpaqueResult[] | null> {
  const scenes = await listOpaqueScenes(called);
  if (!scenes) return null;
  const results: OpaqueResult[] = [];
  for (const { kind, name, scene } of scenes) {
    notify(name);
    const host = document.createElement('div');
    document.body.append(host);
    // Each has a scene of its own: nothing of the one before is left.
    const gpu = await VolumeScene.create(host, host, () => {}, fieldProviders);
    const { volume, transferFunction, size, maxError = 1, optics } = scene;
    if (kind === 'others') {
      const { stated, isKept, level, samplesAVoxel, error } = await measureAtRest(gpu, scene, true);
      results.push({
        kind,
        name,
        maxError,
        error,
        stats: { error: stated, keepsMaxError: isKept },
        off: null,
        level: { samplesAVoxel, substeps: level.substeps },
        finest: null,
        webgl: gpu.device.webgl2 ? 2 : 1,
      });
      gpu.dispose();
      host.remove();
      continue;
    }
    const { stated, isKept, level, shown, samplesAVoxel } = await drawAtRest(gpu, scene);
    const exact = new ExactCells({ volume, transferFunction, referenceLength: optics!.referenceLength! }).draw(
      gpu.viewAt(size),
      size,
    )!;
    const error = measureTrueError(shown, exact);
    results.push({
      kind,
      name,
      maxError,
      error,
      stats: { error: stated, keepsMaxError: isKept },
      off: countOff(shown, exact),
      level: { samplesAVoxel, substeps: level.substeps },
      finest: isKept ? null : measureFinest(gpu, scene, exact),
      webgl: gpu.device.webgl2 ? 2 : 1,
    });
    gpu.dispose();
    host.remove();
  }
  return results;
}

function countOff(shown: Uint8Array, exact: Float32Array): number {
  let off = 0;
  for (let i = 0; i < shown.length; i += 4)
    off += Number([0, 1, 2, 3].some((c) => Math.abs(shown[i + c] - 255 * exact[i + c]) > 8));
  return off;
}

function measureFinest(
  gpu: VolumeScene,
  {
    volume: { grid },
    size,
  }: { readonly volume: Parameters<VolumeScene['setVolume']>[0]; readonly size: { width: number; height: number } },
  exact: Float32Array,
): number {
  changePlan(gpu, { substeps: allSubsteps });
  const steps = Math.min(affordable, 8 * autoSteps(grid));
  const [finest] = probe(gpu, [stepLengthOf(grid, steps)], { stride: 1, first: [0, 0], ...size }, size)!;
  return compareCovered(
    finest.map((x) => Math.round(255 * x) / 255),
    exact,
    255,
  ).e;
}
