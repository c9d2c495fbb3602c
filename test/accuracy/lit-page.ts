// In the browser: what is stated of lit scenes with some steps, and at rest, and what is true of them.
import { fieldProviders } from '../../components/internal/field-providers.ts';
import { allSubsteps } from '../../src/optics/cells/substeps.ts';
import { maxSubsteps } from '../../src/optics/transfer/substep-limits.ts';
import type { PictureError } from '../../src/quality/error-estimate.ts';
import { stateError } from '../../src/quality/largest-error.ts';
import { autoSteps, stepLengthOf } from '../../src/quality/steps.ts';
import { measureError } from '../../src/viewer/frames/measure-quality.ts';
import { QualityControl } from '../../src/viewer/frames/quality-control.ts';
import { defaultTargets } from '../../src/viewer/model/quality-targets.ts';
import { VolumeScene } from '../../src/x3d/scene.ts';
import { changePlan, drawAt } from '../helpers/change-plan.ts';
import { settle } from '../helpers/at-rest.ts';
import type { CoveredError } from '../helpers/covered-error.ts';
import { measureTrueError } from './compare-shown.ts';
import { eachLitScene } from './lit-scenes.ts';
import type { LitErrorScene } from './lit-scenes.ts';
import { probe } from '../helpers/probe.ts';
import '../helpers/provide-substeps.ts';

/** What is stated of a scene's errors, and what they are. */
export interface LitResult {
  readonly kind: string;
  readonly name: string;
  readonly maxError: number;
  /** With steps that nobody chose by the error. */
  readonly coarse: { readonly stated: PictureError; readonly error: CoveredError };
  /** At rest, with the steps that the controller chose. */
  readonly stats: { readonly error: PictureError; readonly keepsMaxError: boolean };
  readonly error: CoveredError;
  readonly level: { readonly steps: number; readonly substeps: number; readonly samplesAVoxel: number };
  /** RMS difference of full rays and such with half as many steps, 1/255. */
  readonly uncertain: number;
}

const size = { width: 96, height: 72 };

/** Steps of full rays, as multiples of those that nobody chose and of one a voxel. */
const full = { coarse: 10, aVoxel: 24 };

/** @param quick - whether some of each kind are enough @param notify - what is being done */
export async function measureLit(quick: boolean, notify: (what: string) => void): Promise<LitResult[]> {
  const results: LitResult[] = [];
  const host = document.createElement('div');
  document.body.append(host);
  const scene = await VolumeScene.create(host, host, () => {}, fieldProviders);
  changePlan(scene, { picture: size });
  for await (const one of eachLitScene(quick)) {
    notify(`scene ${results.length + 1}: ${one.kind}: ${one.name}`);
    results.push(await measureScene(scene, one));
  }
  scene.dispose();
  host.remove();
  return results;
}

async function measureScene(scene: VolumeScene, one: LitErrorScene): Promise<LitResult> {
  const { kind, name, volume, steps } = one;
  await show(scene, one);
  changePlan(scene, { substeps: allSubsteps });
  drawAt(scene, stepLengthOf(volume.grid, steps));
  const stated = measureError(scene, volume.grid, { steps, substeps: maxSubsteps }, size);
  const finest = Math.max(full.coarse * steps, full.aVoxel * autoSteps(volume.grid));
  changePlan(scene, { substeps: allSubsteps });
  const lattice = { stride: 1, first: [0, 0], ...size } as const;
  const [coarse, half, limit] =
    probe(
      scene,
      [steps, finest / 2, finest].map((n) => stepLengthOf(volume.grid, n)),
      lattice,
      size,
    ) ?? [];
  if (!stated || !limit) throw new Error('this device can not probe rays');
  const rest = await drawAtRest(scene, one);
  return {
    kind,
    name,
    ...rest,
    coarse: { stated: stateError(stated, 1, 1).error, error: measureTrueError(toBytes(coarse), limit, half) },
    error: measureTrueError(rest.shown, limit, half),
    uncertain: 255 * Math.sqrt(limit.reduce((sum, x, i) => sum + (x - half[i]) ** 2, 0) / limit.length),
  };
}

async function show(
  scene: VolumeScene,
  { volume, style, overlay, transferFunction, referenceLength, camera }: LitErrorScene,
): Promise<void> {
  const optics = { transferFunction, referenceLength, opacityFactor: 1, lightFactor: 1 };
  await scene.setOverlay(null);
  await scene.prepare(volume, optics);
  scene.setVolume(volume);
  await scene.setAppearance({ style });
  await scene.setAppearance({ optics });
  await scene.setOverlay(overlay ?? null);
  changePlan(scene, { camera });
}

/** What a screen shows of it. */
function toBytes(picture: Float32Array): Uint8Array {
  return Uint8Array.from(picture, (x) => Math.round(x * 255));
}

async function drawAtRest(
  scene: VolumeScene,
  { volume }: LitErrorScene,
): Promise<Pick<LitResult, 'maxError' | 'stats' | 'level'> & { readonly shown: Uint8Array }> {
  const control = new QualityControl();
  const { steps, substeps } = await settle(control, scene, { volume, size });
  const level = { steps, substeps, samplesAVoxel: steps / autoSteps(volume.grid) };
  const stats = { error: control.error!, keepsMaxError: control.isKept };
  return { shown: scene.readPicture().data, maxError: defaultTargets.maxError, stats, level };
}
