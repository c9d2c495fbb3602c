import type { Vector3 } from '../../volume/matrix.ts';
import type { Surface } from '../../volume/surface.ts';

/** The number of vertices that stand for all: enough that none of the others is visibly outside them. */
const maxPlaces = 2000;

/**
 * Places that must be in the picture of a camera that frames a surface. For terrain there are none: it is the ground as far as a
 * radar reaches.
 */
export function placesOf({ parts, terrain }: Surface): Vector3[] {
  if (terrain) return [];
  const count = parts.reduce((sum, { positions }) => sum + positions.length / 3, 0);
  const every = Math.ceil(count / maxPlaces);
  const places: Vector3[] = [];
  const ends: (Vector3 | null)[] = [null, null, null, null, null, null];
  let number = 0;
  for (const { positions } of parts) {
    for (let at = 0; at < positions.length; at += 3) {
      const place: Vector3 = [positions[at], positions[at + 1], positions[at + 2]];
      if (number++ % every === 0) places.push(place);
      for (let end = 0; end < 6; end++) {
        const sign = end < 3 ? 1 : -1;
        if (!ends[end] || sign * place[end % 3] > sign * ends[end]![end % 3]) ends[end] = place;
      }
    }
  }
  return [...places, ...ends.filter((place) => place !== null)];
}
