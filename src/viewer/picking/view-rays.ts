// The rays of a viewer's picture in plain float64: loaded with the first pick or check.
import { viewMatrix } from '../../optics/rays/camera.ts';
import type { RayStages } from '../../optics/rays/ray-stages.ts';
import { setUpRays } from '../../optics/rays/rays.ts';
import type { RaySetup } from '../../optics/rays/rays.ts';
import { brighten } from '../../optics/transfer/brighten.ts';
import type { TransferFunction } from '../../optics/transfer/transfer-function.ts';
import { composeTwins, loadTwins } from '../../renderer/ray/compose-twins.ts';
import type { TwinWalk } from '../../renderer/ray/compose-twins.ts';
import type { RayTwins } from '../../renderer/ray/ray-twin.ts';
import type { Volume } from '../../volume/volume.ts';
import { isOn } from './pick-label.ts';
import type { Viewer } from '../view/viewer.ts';
import type { VolumeOptics } from '../model/volume-info.ts';

/** What a viewer shows, and the rays of its picture. No ray ends at a mesh or another shape. */
export interface ViewRays {
  readonly volume: Volume;
  readonly optics: VolumeOptics;
  readonly setup: RaySetup;
  /** Brightened. */
  readonly transferFunction: TransferFunction;
  /** Brightened: the functions of groups of labels, from 1. */
  readonly functions: readonly TransferFunction[];
  /** Whether surfaces of values are shown. */
  readonly hasSurfaces: boolean;
  stages(walk: TwinWalk): RayStages;
}

/**
 * The rays of the picture on the page. If a new volume has replaced the one in the picture, we wait for its first picture: until then the
 * scene has the new volume, but the region, cuts and slices of the old one, such as a sweep that the new one does not have.
 * @param placesOnly - whether only places and opacities matter: light does not change them
 * @param looks - whether rays look for opaque matter at once, as in pictures at rest
 * @returns null before there is a picture, where no picture will come, and while a coarser volume is shown in place of one that is loading
 * @throws {VolumeViewError} `format/unsupported` where a part of the package could not be loaded
 */
export async function raysOfView(
  viewer: Viewer,
  { placesOnly, looks = true }: { readonly placesOnly: boolean; readonly looks?: boolean },
): Promise<ViewRays | null> {
  const isDrawn = (): boolean => viewer.drawn === viewer.volume;
  if (!viewer.drawn) return null;
  if (!isDrawn()) await viewer.place.visibility.ask(() => viewer.loop.settled(isDrawn));
  const {
    volume,
    optics,
    controller,
    shown: { labels },
  } = viewer;
  const twins = controller.twins(looks);
  // The coarse volume that is shown until a larger one is loaded has other voxels.
  if (!isDrawn() || !volume || !optics || volume.coarse || twins?.volume !== volume) return null;
  const setup = setUpView(viewer, twins);
  if (!setup) return null;
  const frame = { volume, optics: twins.optics, rays: setup, placesOnly };
  await loadTwins(twins, frame);
  if (viewer.volume !== volume) return raysOfView(viewer, { placesOnly, looks }); // Another volume has come meanwhile.
  const functions =
    !optics.projection && labels?.shown && isOn(labels.shown, volume) ? (labels.shown.functions ?? []) : [];
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

/** The rays of the picture: those of the scene, or, where the scene is gone, those of its last camera. */
function setUpView({ scene, rig, place: { host } }: Viewer, { volume: { grid }, region }: RayTwins): RaySetup | null {
  const view = scene?.getView();
  if (view) return setUpRays(grid, view.view, view.projection, region);
  const { camera } = rig;
  const reach = 1 / Math.tan(camera.fieldOfView / 2);
  // The depth part of the projection does not change the path of rays.
  return setUpRays(
    grid,
    viewMatrix(camera),
    [(reach * host.clientHeight) / host.clientWidth, 0, 0, 0, 0, reach, 0, 0, 0, 0, 0, 0, 0, 0, -1, 0],
    region,
  );
}

/** Whether surfaces of values are visible: there are none in projections, and none of labels. */
function showsSurfaces({ isDiscrete }: Volume, { projection, surfaces }: VolumeOptics): boolean {
  return surfaces !== null && !projection && !isDiscrete;
}
