// The rays of an element's picture in float64, with what ends them: no tables, no textures, no graphics processor.
import type { VolumeView } from '../../components/volume-view/volume-view.ts';
import { castRay } from '../../src/optics/rays/cast-ray.ts';
import { shapeInterval } from '../../src/optics/rays/ray-intervals.ts';
import { rayThrough } from '../../src/optics/rays/rays.ts';
import type { Ray } from '../../src/optics/rays/rays.ts';
import { composite } from '../../src/optics/rays/segment.ts';
import type { Premultiplied } from '../../src/optics/transfer/transfer-function.ts';
import { raysOfView } from '../../src/viewer/picking/view-rays.ts';
import { maxSubsteps } from '../../src/optics/transfer/substep-limits.ts';
import { finestSpacing } from '../../src/volume/grid.ts';
import { rayInWorld } from '../helpers/picture.ts';
import { meetShape, shapeColor } from './among-shapes.ts';
import type { LoneShape } from './among-shapes.ts';

/** Rays along each axis of a pixel through which the edge of a shape runs. */
const fine = 4;

/** A view whose pixels can be cast. */
export interface ExactView {
  /** Cuts, and planes that are painted. */
  readonly ends: number;
  /** @param row - from the bottom */
  cast(column: number, row: number): Premultiplied;
  /** Whether a shape covers a part of a pixel, and not all of it. */
  isEdge(column: number, row: number): boolean;
}

/** How it is cast. */
interface HowCast {
  readonly shape: LoneShape | null;
  readonly size: number;
  readonly stepsPerVoxel: number;
}

/** @param element - whose picture is at rest; what it shows, it shows at its own camera */
export async function exactView(element: VolumeView, { shape, size, stepsPerVoxel }: HowCast): Promise<ExactView> {
  const rays = (await raysOfView(element._session.viewer!, { placesOnly: true }))!;
  const { setup, volume } = rays;
  const stages = rays.stages({ stepLength: finestSpacing(volume.grid) / stepsPerVoxel, maxSubsteps });
  const rayAt = (x: number, y: number): Ray => rayThrough(setup, (2 * x) / size - 1, (2 * y) / size - 1);
  const surfaceT = (ray: Ray): number => {
    const { origin, direction } = rayInWorld(volume, ray);
    return shape ? meetShape(shape, origin, direction) : Infinity;
  };
  /** A ray that ends at the shape, and what of it is seen where that is translucent. */
  const endAt = (ray: Ray, t: number): Premultiplied => {
    const before: Premultiplied = [
      ...castRay({ ...stages, intervals: [...stages.intervals, shapeInterval(() => t)] }, ray),
    ];
    composite(before, [...shapeColor, 1]);
    return shape!.opacity === 1 ? before : mix(castRay(stages, ray), before, shape!.opacity);
  };
  /** Where some rays of a pixel meet the shape, and for which share of it. */
  const meet = (column: number, row: number): { readonly t: number; readonly share: number } => {
    const all = Array.from({ length: shape ? fine ** 2 : 0 }, (_, i) =>
      surfaceT(rayAt(column + ((i % fine) + 0.5) / fine, row + (Math.floor(i / fine) + 0.5) / fine)),
    );
    const met = all.filter((t) => t < Infinity);
    return { t: met.reduce((sum, t) => sum + t, 0) / met.length, share: met.length / Math.max(1, all.length) };
  };
  const isEdge = (column: number, row: number): boolean => {
    const { share } = meet(column, row);
    return share > 0 && share < 1;
  };
  return {
    ends: stages.intervals.length - 1,
    isEdge,
    cast(column, row) {
      const ray = rayAt(column + 0.5, row + 0.5);
      const { t, share } = meet(column, row);
      if (share === 0) return castRay(stages, ray);
      return share === 1 ? endAt(ray, surfaceT(ray)) : mix(castRay(stages, ray), endAt(ray, t), share);
    },
  };
}

function mix(from: Premultiplied, to: Premultiplied, share: number): Premultiplied {
  return from.map((x, c) => (1 - share) * x + share * to[c]) as unknown as Premultiplied;
}
