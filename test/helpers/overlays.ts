import type { ShownOverlay } from '../../src/optics/attachments/overlay.ts';
import { unitToWorld } from '../../src/volume/grid.ts';
import { multiply, scaleAndTranslate } from '../../src/volume/matrix.ts';
import type { Matrix4, Vector3 } from '../../src/volume/matrix.ts';
import type { Volume } from '../../src/volume/volume.ts';

/** A transfer function for values of both signs; values around zero are clear. */
export const signed: ShownOverlay['transferFunction'] = [
  { value: -1, color: [0.6, 0.9, 1], opacity: 0.4 },
  { value: -0.2, color: [0.1, 0.2, 0.6], opacity: 0 },
  { value: 0.2, color: [0.6, 0.1, 0.1], opacity: 0 },
  { value: 1, color: [1, 0.9, 0.3], opacity: 0.5 },
];

/** A smooth field of both signs on the unit cube, without any symmetry. */
export function waves(x: number, y: number, z: number): number {
  return Math.sin(4.2 * x + 0.6) * Math.cos(3.1 * y - 0.4) * Math.sin(2.7 * z + 0.9);
}

/** The affine of a grid that is not aligned with another one: rotated, sheared, and smaller or larger. */
export function askew({ grid }: Volume, dimensions: Vector3, size = 0.8): Matrix4 {
  const turned: Matrix4 = [
    size * 0.9,
    -size * 0.3,
    0.05,
    0.5,
    size * 0.25,
    size * 0.85,
    -0.1,
    0.5,
    0.02,
    0.1,
    size,
    0.5,
    0,
    0,
    0,
    1,
  ];
  // From the voxel index to [-0.5, 0.5], then into the other grid's unit cube, then to the world.
  const centred = scaleAndTranslate(
    dimensions.map((n) => 1 / n) as unknown as Vector3,
    dimensions.map((n) => 0.5 / n - 0.5) as unknown as Vector3,
  );
  return multiply(unitToWorld(grid), multiply(turned, centred));
}

/** @param volume - the volume of the layer */
export function overlayOf(over: Volume, volume: Volume, more: Partial<ShownOverlay> = {}): ShownOverlay {
  return { volume, over, transferFunction: signed, blend: 'mix', opacityFactor: 1, missing: null, ...more };
}
