import { framePlaces } from '../../optics/rays/frame-places.ts';
import { findSeenPlaces } from '../../optics/transfer/seen-places.ts';
import type { TransferFunction } from '../../optics/transfer/transfer-function.ts';
import type { GridFrame } from '../../volume/grid.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import type { Volume } from '../../volume/volume.ts';
import { socketOf } from '../model/view-socket.ts';
import type { Framing } from './camera-rig.ts';

/**
 * Frames the visible part of a volume, and the parts that the element has at the time of the next picture: later parts do not move
 * the camera. This code is loaded where the author gives no distance for the camera.
 */
export function createFraming(volume: Volume, appearance: TransferFunction, shown: GridFrame, host?: Element): Framing {
  const places = findSeenPlaces(volume, appearance, shown);
  const findMore = (): Vector3[] => (host ? socketOf(host).parts : []).flatMap((part) => part.bounds?.() ?? []);
  let more: Vector3[] | null = null;
  host?.addEventListener('render', () => (more = findMore()), { once: true });
  return (view, target) => {
    const all = [...places, ...(more ?? findMore())];
    return all.length > 0 ? framePlaces(all, view, target) : null;
  };
}
