// What coarse bricks do to a picture, estimated from what is known of them: rays are cast through what is resident, and at each step
// the values that the voxels may have there are put through the transfer function.
import { atOnce } from '../core/waiting.ts';
import type { Waiting } from '../core/waiting.ts';
import { crossVolume, rayThrough } from '../optics/rays/rays.ts';
import type { DetailListener, DetailScene, RayDetail } from './detail-scene.ts';
import { estimateExtremes } from './extreme-detail.ts';
import { estimateSeen } from './seen-detail.ts';

/** The estimate. */
export interface DetailEstimate {
  /** By cell * number of levels + level: how much less the energy is if the cell has this level; 0 from its present level on. */
  readonly gains: Float64Array;
  /** The root mean square of the differences over the rays that show something, in 1/255. */
  readonly rms: number;
}

/** Estimates what the coarse bricks of a picture hide, and what finer ones would bring. @param cells - their number */
export function estimateDetail(scene: DetailScene, cells: number): DetailEstimate {
  const { levels } = scene.field;
  const gains = new Float64Array(cells * levels);
  const { rms } = atOnce(
    seekDetail(scene, { gain: (cell, level, energy) => (gains[cell * levels + level] += energy) }),
  );
  return { gains, rms };
}

/**
 * The same, with a pause after each row of rays.
 * @returns the differences over the rays that show something, in 1/255: their root mean square, and what 99 % of the rays stay below. A ray that shows nothing yet
 * counts by the opacity that is expected of it: empty pixels next to a thing would dilute what is wrong with it. And the finest level that counts anywhere, 0 where nothing shows.
 */
export function* seekDetail(
  scene: DetailScene,
  listener: DetailListener,
): Waiting<{ readonly rms: number; readonly p99: number; readonly finest: number; readonly energy: number }> {
  const { field, rays, step, across, shift = [0.5, 0.5] } = scene;
  const isLossAsked = listener.loss !== undefined;
  const estimateRay = scene.extreme ? estimateExtremes(scene, isLossAsked) : estimateSeen(scene, isLossAsked);
  const found: RayDetail[] = [];
  let finest = field.levels;
  for (let row = 0; row < across; row++) {
    for (let column = 0; column < across; column++) {
      const ray = rayThrough(rays, ((column + shift[0]) / across) * 2 - 1, 1 - ((row + shift[1]) / across) * 2);
      const [enter, exit] = crossVolume(rays, ray);
      const entry = Math.max(enter, rays.eyeT);
      if (!(exit > entry)) continue;
      const seen = estimateRay({ ...ray, entry, exit, dt: step / ray.lengthPerT }, listener);
      if (!seen) continue;
      finest = Math.min(finest, seen.finest);
      found.push(seen);
    }
    yield;
  }
  const sum = found.reduce((all, { energy }) => all + energy, 0);
  const covered = found.reduce((all, { cover }) => all + cover, 0);
  found.sort((a, b) => b.energy - a.energy);
  let above = 0;
  const p99 = found.find(({ cover }) => (above += cover) > 0.01 * covered)?.energy ?? 0;
  const inBytes = (energy: number): number => Math.min(255, 255 * Math.sqrt(energy));
  // All of a ray's difference may be in one channel.
  return {
    rms: covered > 0 ? inBytes(sum / (4 * covered)) : 0,
    p99: inBytes(p99),
    energy: sum,
    finest: found.length > 0 ? finest : 0,
  };
}
