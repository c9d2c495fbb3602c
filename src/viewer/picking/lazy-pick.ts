import { loadPart } from '../../core/load-part.ts';
import { placeInElement } from '../../page/pointer-place.ts';
import type { PagePoint } from '../../page/pointer-place.ts';
import type { PickedView } from './pick-clicks.ts';
import type { Viewer } from '../view/viewer.ts';
import type { PickOptions, VolumePick, VolumePosition } from '../model/volume-pick.ts';

/** Find what is at a place of a picture, see `pick` of src/viewer/picking/pick.ts. @throws {VolumeViewError} `format/unsupported` */
export async function pickIn(
  viewer: Viewer | null,
  place: readonly [x: number, y: number],
  options?: PickOptions,
): Promise<VolumePick | null> {
  const { pick } = await loadPart(import('./pick.ts'), 'picks');
  return pick(viewer, place, options);
}

/** Find the place that is seen at a point, see src/viewer/picking/find-position.ts. @param point - client coordinates of the page @throws {VolumeViewError} `format/unsupported` */
export async function positionIn(viewer: Viewer | null, point: PagePoint): Promise<VolumePosition | null> {
  if (!viewer) return null;
  const place = placeInElement(viewer.place.host, point); // Before the page scrolls.
  const { findPosition } = await loadPart(import('./find-position.ts'), 'picks');
  return findPosition(viewer, place);
}

/** Let clicks on an element fire `volume-pick` where it is `pickable`. If that part can't be loaded, the picture stays as it is. */
export async function followClicks(view: HTMLElement & Partial<PickedView>): Promise<void> {
  if (!view.pickable) return;
  await import('./pick-clicks.ts').then(({ clicksOn }) => clicksOn(view as PickedView), console.warn);
}
