import type { CartesianGrid } from '../volume/grid.ts';
import { add, scale } from '../volume/matrix.ts';
import type { Samples } from '../volume/volume.ts';
import { exactMeans } from './emission.ts';
import type { SpanMeans } from './emission.ts';
import { interpolate } from './interpolate.ts';
import { intersectUnitCube, rayThrough } from './rays.ts';
import type { Ray, RaySetup } from './rays.ts';
import { classifySegment, composite } from './segment.ts';
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
  const means = exactMeans(scene.transferFunction);
  for (let row = 0; row < height; row++) {
    for (let column = 0; column < width; column++) {
      const x = ((column + 0.5) / width) * 2 - 1;
      const y = 1 - ((row + 0.5) / height) * 2;
      picture.set(castRay(scene, rays, rayThrough(rays, x, y), means), (row * width + column) * 4);
    }
  }
  return picture;
}

/**
 * Emission and absorption along one ray, front to back: the ray is cut into steps from where it enters, the last one
 * being what is left, and on each step the data value is taken to run in a straight line between the values at its ends.
 */
export function castRay(scene: ReferenceScene, setup: RaySetup, ray: Ray, means = exactMeans(scene.transferFunction)): Premultiplied {
  const [entry, exit] = intersectUnitCube(ray.point, ray.direction);
  const start = Math.max(entry, setup.eyeT);
  const total = (Math.min(exit, scene.surfaceT?.(ray) ?? Infinity) - start) * ray.lengthPerT;
  const accumulated: Premultiplied = [0, 0, 0, 0];
  if (!(total > 0)) return accumulated;
  const step = scene.stepLength / setup.diameter;
  const count = countSteps(total, step);
  const valueAt = (length: number): number => {
    const t = start + length / ray.lengthPerT;
    return scene.slope * interpolate(scene.samples, scene.grid.dimensions, add(ray.point, scale(ray.direction, t))) + scene.intercept;
  };
  let front = valueAt(0);
  for (let i = 0; i < count; i++) {
    const end = i < count - 1 ? (i + 1) * step : total;
    const back = valueAt(end);
    const ratio = ((end - i * step) * setup.diameter * scene.opacityFactor) / scene.referenceLength;
    composite(accumulated, classifyEnds(means, [front, back], ratio, scene.lightFactor));
    front = back;
  }
  return accumulated;
}

/** A segment of which one end or both may have no data: the half next to an end without data is empty. */
function classifyEnds(
  means: SpanMeans,
  [front, back]: readonly [number, number],
  ratio: number,
  lightFactor: number,
): Premultiplied {
  const [noFront, noBack] = [Number.isNaN(front), Number.isNaN(back)];
  if (noFront && noBack) return [0, 0, 0, 0];
  if (!noFront && !noBack) return classifySegment(means, [front, back], ratio, lightFactor);
  const only = noFront ? back : front;
  return classifySegment(means, [only, only], ratio / 2, lightFactor);
}

/** Steps on a ray: a rest shorter than a thousandth of a step is no step, but makes the last one longer. */
export function countSteps(total: number, step: number): number {
  return Math.max(1, Math.ceil(total / step - 1e-3));
}
