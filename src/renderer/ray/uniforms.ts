import type { RaySetup } from '../../optics/rays/rays.ts';
import { mapShares } from '../../optics/transfer/share-map.ts';
import type { Uniforms } from '../device/inputs.ts';
import type { RayFrame } from './ray-module.ts';

/** The t at which a ray of a parallel projection starts: in front of any volume. */
const farBehind = -1e9;

/**
 * @param picture - the size of the picture of these rays, in pixels
 * @param stepLength - in world units
 */
export function rayUniforms(
  rays: RaySetup,
  picture: { readonly width: number; readonly height: number },
  stepLength: number,
): Uniforms {
  const m = rays.unitToDiameters;
  const r = rays.unitToRegion;
  return {
    uPoint: rays.point[0],
    uPointX: rays.point[1],
    uPointY: rays.point[2],
    uDirection: rays.direction[0],
    uDirectionX: rays.direction[1],
    uDirectionY: rays.direction[2],
    uDevicePerPixel: [2 / picture.width, 2 / picture.height],
    uBounds: rays.bounds,
    uEyeT: Math.max(rays.eyeT, farBehind),
    uStepLength: stepLength / rays.diameter,
    // Column by column.
    uUnitToDiameters: [m[0], m[3], m[6], m[1], m[4], m[7], m[2], m[5], m[8]],
    uRegionTurn: [r[0], r[4], r[8], r[1], r[5], r[9], r[2], r[6], r[10]],
    uRegionShift: [r[3], r[7], r[11]],
  };
}

/** Uniforms that map a stored value to its share of the transfer function's domain. */
export function valueUniforms({
  volume,
  field: { storedScale },
  domain,
}: Pick<RayFrame, 'volume' | 'domain'> & { readonly field: { readonly storedScale: number } }): Uniforms {
  const { from, scale } = mapShares({ ...volume, storedScale }, domain);
  return { uDimensions: volume.grid.dimensions, uTableDomain: [scale, from] };
}
