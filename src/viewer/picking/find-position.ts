// The place that is seen at a point of the picture, and how much of its light reaches the eye: loaded with the first such question.
import { transmittanceTo } from '../../optics/transmittance.ts';
import { stretchOf } from '../../radar/polar-geometry.ts';
import { dot, subtract } from '../../volume/matrix.ts';
import type { EarthPlace, RadarPlace, VolumePosition } from '../model/volume-pick.ts';
import type { Viewer } from '../view/viewer.ts';
import { pickOnRay } from './pick.ts';

/**
 * The place in the volume that is seen at a place of the picture: where half of the ray's final opacity is reached; with a projection, the
 * place of the value that the ray shows.
 * @returns and @throws as `pick`
 */
export async function findPosition(
  viewer: Viewer | null,
  at: readonly [x: number, y: number],
): Promise<VolumePosition | null> {
  const picked = await pickOnRay(viewer, at, { at: 'half' });
  if (!picked) return null;
  const { rays, stages, ray, place, pick: found } = picked;
  const { volume, optics } = rays;
  const { value, unit, label, labelName, radar, surface } = found;
  const along = dot(subtract(place, ray.point), ray.direction) / dot(ray.direction, ray.direction);
  const [x, y, z] = found.world;
  return {
    position: [x, y, z / stretchOf(volume.grid)],
    value,
    unit,
    transmittance: optics.projection ? 1 : transmittanceTo(stages, ray, along),
    ...(label === undefined ? {} : { label }),
    ...(labelName === undefined ? {} : { labelName }),
    earth: earthOf(radar ?? surface?.radar ?? null),
  };
}

function earthOf(beam: Omit<RadarPlace, 'gate'> | null): EarthPlace | null {
  if (!beam || beam.latitude === null || beam.longitude === null) return null;
  const { latitude, longitude, heightAboveSea, heightAboveAntenna } = beam;
  return { latitude, longitude, height: heightAboveSea ?? heightAboveAntenna };
}
