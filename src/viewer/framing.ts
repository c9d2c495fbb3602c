import { framePlaces } from '../optics/frame-places.ts';
import { findSeenPlaces } from '../optics/seen-places.ts';
import type { TransferFunction } from '../optics/transfer-function.ts';
import type { GridFrame } from '../volume/grid.ts';
import type { Volume } from '../volume/volume.ts';
import type { Framing } from './camera-rig.ts';

/** Frames what a look shows of a volume. It is loaded where an author leaves the distance to the camera. @returns null where nothing is seen */
export function createFraming(volume: Volume, look: TransferFunction, shown: GridFrame): Framing | null {
  const places = findSeenPlaces(volume, look, shown);
  return places.length > 0 ? (view, target) => framePlaces(places, view, target) : null;
}
