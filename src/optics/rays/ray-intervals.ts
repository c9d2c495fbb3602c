import type { IntervalStage } from './ray-stages.ts';
import { crossVolume } from './rays.ts';
import type { Ray, RaySetup } from './rays.ts';

/** Limits rays to the unit cube and to the region in it. Twin: shaders/chunks/walk/region.glsl */
export function boxInterval(setup: RaySetup): IntervalStage {
  return (ray, { entry, exit, behind }) => {
    const [from, to] = crossVolume(setup, ray);
    return { entry: Math.max(entry, from), exit: Math.min(exit, to), behind };
  };
}

/**
 * Ends rays at opaque shapes. Something else draws the shapes.
 * @param surfaceT - t of the nearest shape; Infinity if there is none
 * Twin: shaders/chunks/depth/scene-depth.glsl
 */
export function shapeInterval(surfaceT: (ray: Ray) => number): IntervalStage {
  return (ray, interval) => ({ ...interval, exit: Math.min(interval.exit, surfaceT(ray)) });
}
