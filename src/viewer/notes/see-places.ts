// How much of the light of places reaches the eye, by rays that the CPU casts: loaded with notes.
import { invertAffine, transformPoint } from '../../volume/matrix.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import { finestSpacing, longestDiagonal, unitToWorld } from '../../volume/grid.ts';
import { loadPart } from '../../core/load-part.ts';
import { rayToPlace, thickness, transmittanceTo } from '../../optics/transmittance.ts';
import { maxSubsteps } from '../../optics/transfer/substep-limits.ts';
import { inPieces } from '../../core/in-pieces.ts';
import { socketOf } from '../model/view-socket.ts';
import { raysOfView } from '../picking/view-rays.ts';
import type { Viewer } from '../view/viewer.ts';

/** Maximum number of steps of a ray; each of them may be cut into substeps. */
const maxSteps = 1500;

/** How well a note is seen. */
export type NoteSight = 'plain' | 'veiled' | 'hidden';

/** @param transmittance - of the matter in front of it; null where it is not known */
export function sightOf(transmittance: number | null): NoteSight {
  return transmittance === null || transmittance >= 0.5 ? 'plain' : transmittance >= 0.05 ? 'veiled' : 'hidden';
}

/**
 * The transmittance from each place to the eye, 0..1: 1 minus the opacity of the ray that ends there. In a projection nothing is in front
 * of anything: then it is 1. Shapes of X3D are left out.
 * @param places - in the world as it is drawn
 * @param isWanted - the work ends where it returns false
 * @param isMoving - whether the camera moves: then steps are twice as long and not cut, and the result is close, but not exact
 * @returns null where it is not known: before there is a picture, or not wanted any longer. A place behind the eye has null
 * @throws {VolumeViewError} `format/unsupported` where a part of the package could not be loaded
 */
export async function seePlaces(
  viewer: Viewer,
  places: readonly Vector3[],
  isWanted: () => boolean,
  isMoving = false,
): Promise<(number | null)[] | null> {
  const { host } = viewer.place;
  const surfaces = socketOf(host).last('surface')
    ? await loadPart(import('../picking/pick-surfaces.ts'), 'picks surfaces')
    : null;
  const rays = await raysOfView(viewer, { placesOnly: true });
  if (!rays || !isWanted()) return null;
  const { setup, volume, optics } = rays;
  const toWorld = unitToWorld(volume.grid);
  const toUnit = invertAffine(toWorld);
  if (!toUnit) return null;
  const stepLength = Math.max(finestSpacing(volume.grid), longestDiagonal(viewer.shown.grid) / maxSteps);
  const stages = rays.stages(isMoving ? { stepLength: 2 * stepLength, maxSubsteps: 1 } : { stepLength, maxSubsteps });
  const see = (place: Vector3): number | null => {
    const unit = transformPoint(toUnit, place);
    const to = rayToPlace(setup, unit);
    if (!to) return null;
    if (optics.projection) return 1;
    const end = surfaces?.endAtSurface(host, to.ray, toWorld, setup.eyeT);
    if (end && end.hit.t < to.t - thickness / to.ray.lengthPerT) return 0;
    return transmittanceTo(stages, to.ray, to.t);
  };
  return inPieces(
    (function* (): Generator<void, (number | null)[]> {
      const seen: (number | null)[] = [];
      for (const place of places) {
        seen.push(see(place));
        yield;
      }
      return seen;
    })(),
    isWanted,
  );
}
