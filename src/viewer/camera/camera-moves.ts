// Movements of a camera by a person. Places in the picture are in units of half its height, from its middle, to the right and up.
import { placeInElement } from '../../page/pointer-place.ts';
import type { PagePoint } from '../../page/pointer-place.ts';
import { add, cross, length, normalize, scale, subtract } from '../../volume/matrix.ts';
import type { CameraRig } from './camera-rig.ts';

/**
 * How far a person can move the camera's target from the middle of the subject, in radii of the subject: some of the subject is
 * always in the picture.
 */
const reach = 1;

/** If the camera is nearer to a limit than this share of the distance, it counts as at the limit: no picture shows the difference. */
const limitSlack = 1e-6;

/** Turn by angles in radians. */
export function rotate(rig: CameraRig, theta: number, phi: number): void {
  if (!isFinite(theta + phi)) return;
  const { goal } = rig;
  rig.aim({ ...goal, theta: goal.theta + (theta % (2 * Math.PI)), phi: goal.phi + phi }, true);
}

/** Come closer (factor below 1) or go away. */
export function zoom(rig: CameraRig, factor: number): void {
  if (factor > 0) rig.aim({ ...rig.goal, radius: rig.goal.radius * factor }, true);
}

/** Whether the camera can come closer (factor below 1) or go away: at its limit it can't. */
export function canZoom(rig: CameraRig, factor: number): boolean {
  const { goal } = rig;
  return Math.abs(rig.within({ ...goal, radius: goal.radius * factor }).radius / goal.radius - 1) > limitSlack;
}

/** Move the volume in the plane of the camera's target, so that it follows the pointer. */
export function pan(rig: CameraRig, [x, y]: readonly [x: number, y: number]): void {
  const { goal } = rig;
  const { eye, target, up, fieldOfView } = rig.cameraAt(goal);
  const right = normalize(cross(up, subtract(eye, target)));
  const halfHeight = goal.radius * Math.tan(fieldOfView / 2);
  const { center, radius } = rig.subject;
  const before = subtract(target, center);
  const after = add(before, add(scale(right, -x * halfHeight), scale(up, -y * halfHeight)));
  // A person can't lose the subject; an author may look farther to its side.
  const share = Math.min(1, Math.max(reach * radius, length(before)) / length(after));
  rig.aim({ ...goal, target: add(center, scale(after, share)) }, true);
}

/** Come closer (factor below 1) or go away; the place under the pointer stays where it is in the picture. */
export function zoomAt(rig: CameraRig, factor: number, [x, y]: readonly [x: number, y: number]): void {
  const before = rig.goal.radius;
  zoom(rig, factor);
  // The change is smaller than the factor where the camera can't come nearer.
  const share = before / rig.goal.radius - 1;
  if (share !== 0) pan(rig, [-x * share, -y * share]);
}

/**
 * The same for input that holds no place of the picture: a wheel, a key, a button. While the camera goes away, its target never
 * moves farther from the first target; beyond the first distance it returns to the first target.
 */
export function zoomFrom(rig: CameraRig, factor: number, place: readonly [x: number, y: number]): void {
  const before = rig.goal;
  zoomAt(rig, factor, place);
  if (!(factor > 1)) return;
  const { goal, home } = rig;
  const [was, is] = [before.target, goal.target].map((target) => subtract(target, home.target));
  const [near, far] = [length(was), length(is)];
  const rounding = 1e-9 * goal.radius;
  // Also at the limit, where the camera no longer goes away.
  const share =
    far > near + rounding ? 1 / factor : Math.min(1, Math.max(before.radius, home.radius) / (before.radius * factor));
  if (far > share * near + rounding) rig.aim({ ...goal, target: add(home.target, scale(was, share)) }, true);
}

/** The place of a pointer in an element's picture. */
export function placeIn(element: HTMLElement, point: PagePoint): [x: number, y: number] {
  const [x, y] = placeInElement(element, point);
  const { clientWidth, clientHeight } = element;
  return [(2 * x - clientWidth) / clientHeight, (clientHeight - 2 * y) / clientHeight];
}
