import type { PixelLattice, RaySetup } from '../optics/rays.ts';
import type { PreintegrationTable } from '../optics/preintegration-table.ts';
import type { OpticalFactors } from '../optics/transfer-function.ts';
import { cellSize } from '../volume/macrocells.ts';
import type { Matrix4 } from '../volume/matrix.ts';
import type { Volume } from '../volume/volume.ts';
import type { EmptySpaceTexture, VolumeTexture } from './textures.ts';

export type Uniforms = Record<string, number | readonly number[]>;

/** How deep a ray of a parallel projection starts: ahead of any volume. */
const farBehind = -1e9;

/**
 * @param picture - pixels across and down, of which these are the rays
 * @param stepLength - world length
 */
export function rayUniforms(rays: RaySetup, picture: { readonly width: number; readonly height: number }, stepLength: number): Uniforms {
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

/** Factors stay below this, so that the shader's products stay numbers. */
const largestFactor = 1e30;

/** Shares of the table's domain stay below this, so that their differences stay numbers. */
const largestShare = 1e38;

/**
 * Added to shares of the table's domain, so that values that rounding put before a jump at an end of the domain are on
 * its right, where they belong. A five-hundredth of a column.
 */
const shareNudge = 1e-6;

/** Where the voxels lie in their texture, and which share of the table's domain a stored value means. */
export function volumeUniforms(volume: Volume, texture: VolumeTexture, table: PreintegrationTable): Uniforms {
  const toShare = 1 / (table.high - table.low);
  const [scale, offset] = [volume.slope * texture.storedScale * toShare, (volume.intercept - table.low) * toShare];
  // A domain that is next to nothing of the data's range becomes as wide as floats can tell from it.
  const shares = volume.range.map((value) => (value - table.low) * toShare);
  const fit = largestShare / Math.max(largestShare, ...[scale, offset, ...shares].map(Math.abs));
  const uniforms: Uniforms = {
    uDimensions: volume.grid.dimensions,
    uTableSize: [table.columns, table.rows],
    uTableDomain: [scale * fit, offset * fit + shareNudge],
    uTableFirst: table.first,
    uTableLast: table.last,
  };
  Object.assign(uniforms, texture.polar?.uniforms);
  if (texture.atlas) {
    const { columns, rows, width: across, height: down } = texture.atlas;
    uniforms.uMosaic = [columns, rows, 1 / across, 1 / down];
  }
  return uniforms;
}

/** Where the macrocells lie in their texture. */
export function emptySpaceUniforms({ cells, atlas }: EmptySpaceTexture): Uniforms {
  return {
    uCells: [...cells, cellSize],
    uCellMosaic: [atlas.columns, atlas.rows, 1 / atlas.width, 1 / atlas.height],
  };
}

/** @param optics - referenceLength: world length over which a stop's opacity holds */
export function opticalUniforms(rays: RaySetup, optics: OpticalFactors & { readonly referenceLength: number }): Uniforms {
  return { uOpticalScale: Math.min(largestFactor, (rays.diameter / optics.referenceLength) * optics.opacityFactor) };
}

/** Where a lattice's pixels lie in a picture's depth buffer, and what its values mean. */
export function surfaceUniforms(
  rays: RaySetup,
  projection: Matrix4,
  picture: { readonly width: number; readonly height: number },
  { stride, first }: PixelLattice,
): Uniforms {
  const shift = first + 0.5 - 0.5 * stride;
  return {
    uPixelToDepth: [stride / picture.width, stride / picture.height, shift / picture.width, shift / picture.height],
    uDepthTerms: [projection[10], projection[11], projection[14], projection[15]],
    uDepthToT: [rays.planeDepth, rays.diameter],
  };
}
