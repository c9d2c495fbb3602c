// In the browser: scenes of which frames are taken in turns.
import { fieldProviders } from '../../components/internal/field-providers.ts';
import { framingDistance, orbitCamera } from '../../src/optics/rays/camera.ts';
import type { TransferFunction } from '../../src/optics/transfer/transfer-function.ts';
import { boundingSphere } from '../../src/volume/grid.ts';
import type { GridFrame } from '../../src/volume/grid.ts';
import type { Volume } from '../../src/volume/volume.ts';
import { VolumeScene } from '../../src/x3d/scene.ts';
import { changePlan } from '../helpers/change-plan.ts';
import '../helpers/provide-substeps.ts';

/** Processor time of the process that draws; other programs on the machine do not count. Given by turns.mjs. */
export const processorSeconds = (): Promise<number> =>
  (window as unknown as { processorSeconds: () => Promise<number> }).processorSeconds();

/** What is looked at. */
export interface TurnScene {
  readonly volume: Volume;
  readonly transferFunction: TransferFunction;
  /** A share of the volume's radius. */
  readonly referenceLength: number;
  /** Pixels along each side. */
  readonly size: number;
  /** What is in sight; the volume itself, if absent. */
  readonly around?: GridFrame;
}

/** A volume in a canvas of its own, all of it in sight. */
export async function openTurnScene({
  volume,
  transferFunction,
  referenceLength,
  size,
  around = volume.grid,
}: TurnScene): Promise<{ scene: VolumeScene; dispose: () => void }> {
  const { center, radius } = boundingSphere(around);
  const optics = { transferFunction, referenceLength: referenceLength * radius, opacityFactor: 1, lightFactor: 1 };
  const host = document.createElement('div');
  document.body.append(host);
  const scene = await VolumeScene.create(host, host, () => {}, fieldProviders);
  await scene.prepare(volume, optics);
  scene.setVolume(volume);
  await scene.setAppearance({ optics });
  changePlan(scene, { picture: { width: size, height: size } });
  changePlan(scene, {
    camera: orbitCamera({ theta: 0.6, phi: 1.2, radius: framingDistance(radius, 0.5, 1) }, center, 0.5),
  });
  return { scene, dispose: () => (scene.dispose(), host.remove()) };
}
