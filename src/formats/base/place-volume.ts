import { cartesianGrid } from '../../volume/grid.ts';
import type { DecodedCartesianVolume, DecodeSettings } from './decoded-volume.ts';
import { respace } from './respace.ts';

/**
 * Sets a volume's place. A manifest's place in the world overrides the file's, and the spacing of an attribute or a
 * manifest overrides the file's.
 */
export function placeVolume(volume: DecodedCartesianVolume, settings: DecodeSettings): DecodedCartesianVolume {
  const { dimensions, indexToWorld } = volume.grid;
  const own = settings.indexToWorld ?? indexToWorld;
  return {
    ...volume,
    grid: cartesianGrid(dimensions, settings.spacing ? respace(own, dimensions, settings.spacing) : own),
  };
}
