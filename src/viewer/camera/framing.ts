import { framePlaces } from '../../optics/rays/frame-places.ts';
import { findSeenPlaces } from '../../optics/transfer/seen-places.ts';
import type { TransferFunction } from '../../optics/transfer/transfer-function.ts';
import type { GridFrame } from '../../volume/grid.ts';
import type { Volume } from '../../volume/volume.ts';
import { socketOf } from '../model/view-socket.ts';
import type { ViewPart } from '../model/view-socket.ts';
import type { Framing } from './camera-rig.ts';
import { faceSlice } from './face-slice.ts';

/**
 * Frames the visible part of a volume, and the parts that the element has at the time of the next picture, or whose files were
 * still loading then: parts that are added later do not move the camera. This code is loaded where the author gives no distance
 * for the camera.
 */
export function createFraming(volume: Volume, appearance: TransferFunction, shown: GridFrame, host?: Element): Framing {
  const places = findSeenPlaces(volume, appearance, shown);
  const listParts = (): readonly ViewPart[] => (host ? socketOf(host).parts : []);
  let first: readonly ViewPart[] | null = null;
  host?.addEventListener('render', () => (first = listParts()), { once: true });
  const frame: Framing = (view, target) => {
    const framed = listParts().filter((part) => !first || part.isExpected || first.includes(part));
    const all = [...places, ...framed.flatMap((part) => part.bounds?.() ?? [])];
    return all.length > 0 ? framePlaces(all, view, target) : null;
  };
  return Object.assign(frame, { usual: faceSlice(volume) });
}
