// In the browser: what is stated of projections, and what is true by all of their rays in float64, in which nothing is missed.
import { fieldProviders } from '../../components/internal/field-providers.ts';
import { projectionMatrix, viewMatrix } from '../../src/optics/rays/camera.ts';
import { projectionGather } from '../../src/optics/rays/projection.ts';
import { setUpRays } from '../../src/optics/rays/rays.ts';
import { renderReference } from '../../src/optics/reference.ts';
import { QualityControl } from '../../src/viewer/frames/quality-control.ts';
import { defaultTargets } from '../../src/viewer/model/quality-targets.ts';
import { finestSpacing } from '../../src/volume/grid.ts';
import { VolumeScene } from '../../src/x3d/scene.ts';
import { changePlan } from '../helpers/change-plan.ts';
import { settle } from '../helpers/at-rest.ts';
import type { RestScene } from '../helpers/at-rest.ts';
import { measureTrueError } from './compare-shown.ts';
import type { HardResult } from './hard-page.ts';
import { projectedScenes } from './projected-scenes.ts';
import '../helpers/provide-substeps.ts';

/** All scenes' names, with their kinds. */
export function listProjected(): string[] {
  return projectedScenes.map(({ kind, name }) => `${kind}: ${name}`);
}

/** @param wanted - as `listProjected` names it */
export async function measureProjected(wanted: string): Promise<HardResult> {
  const { kind, name, make } = projectedScenes.find((one) => `${one.kind}: ${one.name}` === wanted)!;
  const host = document.createElement('div');
  document.body.append(host);
  const gpu = await VolumeScene.create(host, host, () => {}, fieldProviders);
  try {
    const scene = make();
    return { kind, name, maxError: 1, isOutOfSight: false, ...(await compareProjected(gpu, scene)) };
  } finally {
    gpu.dispose();
    host.remove();
  }
}

/** What an element would state of a projection at rest, and what is true of it. */
export async function compareProjected(
  gpu: VolumeScene,
  scene: RestScene,
): Promise<Pick<HardResult, 'stats' | 'error' | 'level'>> {
  const { volume, style, transferFunction, camera, size } = scene;
  const optics = { transferFunction, referenceLength: 1, opacityFactor: 1, lightFactor: 1, ...scene.optics };
  changePlan(gpu, { picture: size });
  await gpu.prepare(volume, optics);
  gpu.setVolume(volume);
  await gpu.setAppearance({ style });
  await gpu.setAppearance({ optics });
  changePlan(gpu, { camera });
  const control = new QualityControl();
  control.set(defaultTargets);
  const { steps, substeps } = await settle(control, gpu, { volume, size });
  const shown = gpu.readPicture().data;
  const rays = setUpRays(
    volume.grid,
    viewMatrix(camera),
    projectionMatrix(camera.fieldOfView, size.width / size.height, 1, 2),
  )!;
  const exact = renderReference(
    { ...volume, ...optics, stepLength: finestSpacing(volume.grid) / 16, gather: projectionGather(style!.projection!) },
    rays,
    size.width,
    size.height,
  );
  return {
    stats: { error: control.error!, keepsMaxError: control.isKept },
    error: measureTrueError(shown, bottomUp(exact, size.width)),
    level: { samplesAVoxel: steps, substeps },
  };
}

/** Rows from the bottom. */
function bottomUp(picture: Float64Array, width: number): Float32Array {
  const rows = picture.length / (4 * width);
  return Float32Array.from(
    picture,
    (_, i) => picture[(rows - 1 - Math.floor(i / (4 * width))) * 4 * width + (i % (4 * width))],
  );
}
