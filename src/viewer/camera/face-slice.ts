import type { Orbit } from '../../optics/rays/camera.ts';
import { cross, normalize } from '../../volume/matrix.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import { isSingleSlice } from '../../volume/volume.ts';
import type { Volume } from '../../volume/volume.ts';

/**
 * From where a volume of one slice is looked at, so that nobody sees a single picture from its edge: in front of it, as radiologists see it, from
 * the patient's feet, the front or the left; a slice of a radar from above, with the north up. A slice that is nearly level is looked at along the
 * vertical axis, as upright cameras can't turn around what they look along.
 */
export function faceSlice({ grid, radar }: Pick<Volume, 'grid' | 'radar'>): Pick<Orbit, 'theta' | 'phi'> | undefined {
  if (!isSingleSlice(grid)) return undefined;
  const m = grid.indexToWorld;
  const [one, other] = [0, 1, 2]
    .filter((axis) => grid.dimensions[axis] > 1)
    .map((axis): Vector3 => [m[axis], m[4 + axis], m[8 + axis]]);
  const [x, y, z] = normalize(cross(one, other));
  if (Math.abs(z) >= Math.max(Math.abs(x), Math.abs(y)))
    return radar ? { theta: Math.PI, phi: 0 } : { theta: 0, phi: Math.PI };
  const sign = Math.abs(y) >= Math.abs(x) ? Math.sign(y) : -Math.sign(x);
  return { theta: Math.atan2(-sign * x, sign * y), phi: Math.acos(sign * z) };
}
