// The rays of a viewer's picture in plain float64: loaded when somebody points at it, or checks it.
import { viewMatrix } from '../../optics/rays/camera.ts';
import type { RayStages } from '../../optics/rays/ray-stages.ts';
import { setUpRays } from '../../optics/rays/rays.ts';
import type { RaySetup } from '../../optics/rays/rays.ts';
import { brighten } from '../../optics/transfer/brighten.ts';
import type { TransferFunction } from '../../optics/transfer/transfer-function.ts';
import { composeTwins, loadTwins } from '../../renderer/ray/compose-twins.ts';
import type { TwinWalk } from '../../renderer/ray/compose-twins.ts';
import type { Volume } from '../../volume/volume.ts';
import { isOn } from './pick-label.ts';
import type { Viewer } from '../view/viewer.ts';
import type { VolumeOptics } from '../model/volume-info.ts';

/** What a viewer shows, and the rays of its picture. Meshes and other shapes end none of them. */
export interface ViewRays {
  readonly volume: Volume;
  readonly optics: VolumeOptics;
  readonly setup: RaySetup;
  /** Brightened. */
  readonly transferFunction: TransferFunction;
  /** Brightened: of groups of labels, from 1. */
  readonly functions: readonly TransferFunction[];
  /** Whether surfaces of values are shown. */
  readonly hasSurfaces: boolean;
  stages(walk: TwinWalk): RayStages;
}

/**
 * @param placesOnly - whether only places and opacities matter, which light leaves as they are
 * @param looks - whether rays look for what is opaque at once, as in pictures at rest
 * @returns null before there is a picture, and where a coarser volume stands for what is on its way
 * @throws {VolumeViewError} `format/unsupported` where a part of the package is not there
 */
export async function raysOfView(viewer: Viewer, { placesOnly, looks = true }: { readonly placesOnly: boolean; readonly looks?: boolean }): Promise<ViewRays | null> {
  const { volume, optics, drawn, pictures: { parts: { keeper, shown: { labels } } } } = viewer;
  const twins = keeper.twins(looks);
  // What stands for a larger volume until that is there has none of its voxels.
  if (!volume || !optics || !drawn || volume.coarse || twins?.volume !== volume) return null;
  const setup = setUpView(viewer, volume);
  if (!setup) return null;
  const frame = { volume, optics: twins.optics, rays: setup, placesOnly };
  await loadTwins(twins, frame);
  const functions = !optics.projection && labels?.shown && isOn(labels.shown, volume) ? (labels.shown.functions ?? []) : [];
  return {
    volume,
    optics,
    setup,
    transferFunction: brighten(optics.transferFunction, optics.lightFactor),
    functions: functions.map((one) => brighten(one, optics.lightFactor)),
    hasSurfaces: showsSurfaces(volume, optics),
    stages: (walk) => composeTwins(twins, frame, walk),
  };
}

/** The rays of the picture: those of the scene, or else of where its camera stood when it went. */
function setUpView({ pictures: { parts }, rig, place: { host } }: Viewer, { grid }: Volume): RaySetup | null {
  const { region } = parts.shown.cuts;
  const view = parts.keeper.scene?.getView();
  if (view) return setUpRays(grid, view.view, view.projection, region);
  const { camera } = rig;
  const reach = 1 / Math.tan(camera.fieldOfView / 2);
  // Where rays run does not depend on how depth is written.
  return setUpRays(grid, viewMatrix(camera), [(reach * host.clientHeight) / host.clientWidth, 0, 0, 0, 0, reach, 0, 0, 0, 0, 0, 0, 0, 0, -1, 0], region);
}

/** Neither values that are projected nor labels have surfaces. */
function showsSurfaces({ isDiscrete }: Volume, { projection, surfaces }: VolumeOptics): boolean {
  return surfaces !== null && !projection && !isDiscrete;
}
