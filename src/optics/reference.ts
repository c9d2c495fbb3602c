import type { CartesianGrid } from '../volume/grid.ts';
import { add, scale } from '../volume/matrix.ts';
import type { Samples } from '../volume/volume.ts';
import { interpolate } from './interpolate.ts';
import { intersectUnitCube, rayThrough } from './rays.ts';
import type { Ray, RaySetup } from './rays.ts';
import { classifyStep } from './transfer-function.ts';
import type { OpticalFactors, Premultiplied, TransferFunction } from './transfer-function.ts';

/** Everything that a picture depends on. */
export interface ReferenceScene extends OpticalFactors {
  readonly grid: CartesianGrid;
  readonly samples: Samples;
  readonly slope: number;
  readonly intercept: number;
  readonly transferFunction: TransferFunction;
  /** World length over which a stop's opacity holds. */
  readonly referenceLength: number;
  /** World length of a step. */
  readonly stepLength: number;
  /** t at which an opaque shape ends a ray, Infinity where none does; no shapes where absent. */
  readonly surfaceT?: (ray: Ray) => number;
}

/**
 * The picture in plain float64: what every GPU result is compared with. No early termination, no tables.
 * @returns Float64Array of shape [height, width, 4], top row first, premultiplied, 0..1
 */
export function renderReference(scene: ReferenceScene, rays: RaySetup, width: number, height: number): Float64Array {
  const picture = new Float64Array(width * height * 4);
  for (let row = 0; row < height; row++) {
    for (let column = 0; column < width; column++) {
      const x = ((column + 0.5) / width) * 2 - 1;
      const y = 1 - ((row + 0.5) / height) * 2;
      picture.set(castRay(scene, rays, rayThrough(rays, x, y)), (row * width + column) * 4);
    }
  }
  return picture;
}

/**
 * Emission and absorption along one ray, front to back: the ray is cut into steps from where it enters, the last one
 * being what is left, and each step takes the data value at its middle.
 */
export function castRay(scene: ReferenceScene, setup: RaySetup, ray: Ray): Premultiplied {
  const [entry, exit] = intersectUnitCube(ray.point, ray.direction);
  const start = Math.max(entry, setup.eyeT);
  const end = Math.min(exit, scene.surfaceT?.(ray) ?? Infinity);
  const total = (end - start) * ray.lengthPerT;
  const accumulated: Premultiplied = [0, 0, 0, 0];
  if (!(total > 0)) return accumulated;
  const step = scene.stepLength / setup.diameter;
  const count = countSteps(total, step);
  for (let i = 0; i < count; i++) {
    const length = i < count - 1 ? step : total - i * step;
    const t = start + (i * step + length / 2) / ray.lengthPerT;
    const stored = interpolate(scene.samples, scene.grid.dimensions, add(ray.point, scale(ray.direction, t)));
    if (Number.isNaN(stored)) continue;
    const value = scene.slope * stored + scene.intercept;
    const ratio = (length * setup.diameter) / scene.referenceLength;
    const sample = classifyStep(scene.transferFunction, value, ratio, scene);
    const visible = 1 - accumulated[3];
    for (let channel = 0; channel < 4; channel++) accumulated[channel] += visible * sample[channel];
  }
  return accumulated;
}

/** Steps on a ray: a rest shorter than a thousandth of a step is no step, but makes the last one longer. */
export function countSteps(total: number, step: number): number {
  return Math.max(1, Math.ceil(total / step - 1e-3));
}
