import { finestSpacing } from '../volume/grid.ts';
import type { GridFrame } from '../volume/grid.ts';
import { add, scale } from '../volume/matrix.ts';
import type { Vector3 } from '../volume/matrix.ts';
import type { Samples } from '../volume/volume.ts';
import { brighten } from './brighten.ts';
import { exactMeans } from './emission.ts';
import type { SpanMeans } from './emission.ts';
import { buildSubstepTable } from './substep-table.ts';
import type { SubstepTable } from './substep-table.ts';
import { interpolate } from './interpolate.ts';
import { crossVolume, rayThrough } from './rays.ts';
import type { Ray, RaySetup } from './rays.ts';
import { attenuate, composite, countSubsteps, maxSubsteps } from './segment.ts';
import { integrateForTable } from './preintegration-table.ts';
import type { Color, OpticalFactors, Premultiplied, TransferFunction } from './transfer-function.ts';

/** Where a ray meets a slice, and what is painted there. */
export interface SliceHit {
  readonly t: number;
  /** Straight. */
  readonly color: Color;
}

/** Everything that a picture depends on. */
export interface ReferenceScene extends OpticalFactors {
  readonly grid: GridFrame;
  readonly samples: Samples;
  readonly slope: number;
  readonly intercept: number;
  readonly transferFunction: TransferFunction;
  /** World length over which a stop's opacity holds. */
  readonly referenceLength: number;
  /** World length of a step. */
  readonly stepLength: number;
  /** No step is cut into more parts; as the shader does where absent. */
  readonly maxSubsteps?: number;
  /** Stored value at a point of the unit cube, NaN where there is no data; tri-linear on the grid where absent. */
  readonly valueAt?: (point: Vector3) => number;
  /** Stored values more than this apart are on two sides of a fold; absent where values do not fold. */
  readonly foldFrom?: number;
  /** t at which an opaque shape ends a ray, Infinity where none does; no shapes where absent. */
  readonly surfaceT?: (ray: Ray) => number;
  /** The nearest slice that a ray meets between two t, see radar/slices.ts; no slices where absent. */
  readonly meetSlices?: (ray: Ray, span: readonly [number, number]) => SliceHit | null;
}

/**
 * The picture in plain float64: what every GPU result is compared with. No early termination, no tables.
 * @returns Float64Array of shape [height, width, 4], top row first, premultiplied, 0..1
 */
export function renderReference(scene: ReferenceScene, rays: RaySetup, width: number, height: number): Float64Array {
  const picture = new Float64Array(width * height * 4);
  const optics = opticsOf(scene);
  for (let row = 0; row < height; row++) {
    for (let column = 0; column < width; column++) {
      const x = ((column + 0.5) / width) * 2 - 1;
      const y = 1 - ((row + 0.5) / height) * 2;
      picture.set(castRay(scene, rays, rayThrough(rays, x, y), optics), (row * width + column) * 4);
    }
  }
  return picture;
}

/**
 * Emission and absorption along one ray, front to back: the ray is cut into steps from where it enters, the last one
 * being what is left, and steps on which something may be seen into parts. On each part the data value is taken to run
 * in a straight line between the values at its ends. A slice ends it, and stands behind what has been gathered.
 */
export function castRay(scene: ReferenceScene, setup: RaySetup, ray: Ray, { means, substeps: table } = opticsOf(scene)): Premultiplied {
  const [entry, exit] = crossVolume(setup, ray);
  const start = Math.max(entry, setup.eyeT);
  const beforeSlices = Math.min(exit, scene.surfaceT?.(ray) ?? Infinity);
  const slice = (start < beforeSlices && scene.meetSlices?.(ray, [start, beforeSlices])) || null;
  const total = ((slice?.t ?? beforeSlices) - start) * ray.lengthPerT;
  const accumulated: Premultiplied = [0, 0, 0, 0];
  if (!(total > 0)) return accumulated;
  const step = scene.stepLength / setup.diameter;
  const count = countSteps(total, step);
  const ratioPerLength = (setup.diameter * scene.opacityFactor) / scene.referenceLength;
  const foldFrom = (scene.foldFrom ?? Infinity) * Math.abs(scene.slope);
  const storedAt = scene.valueAt ?? ((point: Vector3) => interpolate(scene.samples, scene.grid.dimensions, point));
  const valueAt = (length: number): number =>
    scene.slope * storedAt(add(ray.point, scale(ray.direction, start + length / ray.lengthPerT))) + scene.intercept;
  let front = valueAt(0);
  for (let i = 0; i < count; i++) {
    const begin = i * step;
    const end = i < count - 1 ? begin + step : total;
    const last = valueAt(end);
    const wished = hasData(front, last) ? countSubsteps(table, dataEnds(front, last), 1 - accumulated[3]) : 1;
    const substeps = Math.min(scene.maxSubsteps ?? maxSubsteps, wished);
    const length = (end - begin) / substeps;
    for (let part = 1; part <= substeps; part++) {
      const back = part < substeps ? valueAt(begin + part * length) : last;
      composite(accumulated, classifyEnds(means, [front, back], length * ratioPerLength, foldFrom));
      front = back;
    }
  }
  if (slice) composite(accumulated, [...slice.color, 1]);
  return accumulated;
}

function hasData(front: number, back: number): boolean {
  return !Number.isNaN(front) || !Number.isNaN(back);
}

/** The values at both ends, of which one stands for the other where that has no data. */
function dataEnds(front: number, back: number): [number, number] {
  return [Number.isNaN(front) ? back : front, Number.isNaN(back) ? front : back];
}

/**
 * A length of which one end or both may have no data: the half next to an end without data is empty. Where a velocity folds
 * in between, half of it is of either end.
 */
function classifyEnds(means: SpanMeans, [front, back]: readonly [number, number], ratio: number, foldFrom: number): Premultiplied {
  if (!hasData(front, back)) return [0, 0, 0, 0];
  const [from, to] = dataEnds(front, back);
  if (Math.abs(to - from) > foldFrom) {
    const [near, far] = [means.mean(from, from), means.mean(to, to)];
    return attenuate(near.map((x, c) => (x + far[c]) / 2) as Premultiplied, ratio);
  }
  const isWhole = !Number.isNaN(front) && !Number.isNaN(back);
  return attenuate(means.mean(from, to), isWhole ? ratio : ratio / 2);
}

/** What `castRay` needs of its scene's transfer function: worth keeping for many rays. */
export interface RayOptics {
  readonly means: SpanMeans;
  readonly substeps: SubstepTable;
}

export function opticsOf({ transferFunction, lightFactor, grid, opacityFactor, referenceLength }: ReferenceScene): RayOptics {
  const bright = brighten(transferFunction, lightFactor);
  const voxelRatio = (finestSpacing(grid) / referenceLength) * opacityFactor;
  return { means: exactMeans(bright), substeps: buildSubstepTable(integrateForTable(bright), voxelRatio) };
}

/** Steps on a ray: a rest shorter than a thousandth of a step is no step, but makes the last one longer. */
export function countSteps(total: number, step: number): number {
  return Math.max(1, Math.ceil(total / step - 1e-3));
}
