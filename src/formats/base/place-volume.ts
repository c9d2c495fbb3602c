import { cartesianGrid } from '../../volume/grid.ts';
import type { DecodedCartesianVolume, DecodeSettings } from './decoded-volume.ts';
import { respace } from './respace.ts';

/** A manifest's place in the world comes before the file's own, and a spacing of an attribute or a manifest before the file's. */
export function placeVolume(volume: DecodedCartesianVolume, settings: DecodeSettings): DecodedCartesianVolume {
  const { dimensions, indexToWorld } = volume.grid;
  const own = settings.indexToWorld ?? indexToWorld;
  return { ...volume, grid: cartesianGrid(dimensions, settings.spacing ? respace(own, dimensions, settings.spacing) : own) };
}
