import { stretchOf } from '../../radar/polar-geometry.ts';
import type { GridFrame } from '../../volume/grid.ts';
import { cutRegion } from '../../volume/region.ts';
import { invalid } from '../model/parse-attributes.ts';
import type { ScanModel } from '../model/scan-model.ts';

/**
 * The region that an author requests.
 * @param box - two opposite corners, world units; null for the whole volume
 * @throws {VolumeViewError} `attribute/invalid`
 */
export function readRegion(box: readonly number[] | null, volume: ScanModel): GridFrame | null {
  if (!box) return null;
  const region = cutRegion(volume.grid, box, stretchOf(volume.grid));
  if (!region)
    throw invalid(
      'region',
      box.join(' '),
      'two opposite corners of a box that holds some of the volume, "x0 y0 z0 x1 y1 z1"',
    );
  return region;
}
