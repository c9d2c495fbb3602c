// What hands do to a camera. Places in the picture are in half its height, from its middle, to the right and up.
import { placeInElement } from '../../page/pointer-place.ts';
import type { PagePoint } from '../../page/pointer-place.ts';
import { add, cross, length, normalize, scale, subtract } from '../../volume/matrix.ts';
import type { CameraRig } from './camera-rig.ts';

/** How far from the middle of the subject a person gets what they look at, in its radii: some of it is always in the picture. */
const reach = 1;

/** Nearer to a limit than this share of the distance, the camera is there: no picture shows it. */
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

/** Whether the camera comes closer (factor below 1) or goes away: at its limit it does not. */
export function canZoom(rig: CameraRig, factor: number): boolean {
  const { goal } = rig;
  return Math.abs(rig.within({ ...goal, radius: goal.radius * factor }).radius / goal.radius - 1) > limitSlack;
}

/** Move what is seen in the plane of what is looked at: it goes with the hand. */
export function pan(rig: CameraRig, [x, y]: readonly [x: number, y: number]): void {
  const { goal } = rig;
  const { eye, target, up, fieldOfView } = rig.cameraAt(goal);
  const right = normalize(cross(up, subtract(eye, target)));
  const halfHeight = goal.radius * Math.tan(fieldOfView / 2);
  const { center, radius } = rig.subject;
  const before = subtract(target, center);
  const after = add(before, add(scale(right, -x * halfHeight), scale(up, -y * halfHeight)));
  // The subject can't be lost; an author may look farther beside it.
  const share = Math.min(1, Math.max(reach * radius, length(before)) / length(after));
  rig.aim({ ...goal, target: add(center, scale(after, share)) }, true);
}

/** Come closer (factor below 1) or go away; what lies at a place of the picture stays there. */
export function zoomAt(rig: CameraRig, factor: number, [x, y]: readonly [x: number, y: number]): void {
  const before = rig.goal.radius;
  zoom(rig, factor);
  // Less than the factor where the camera can't come nearer.
  const share = before / rig.goal.radius - 1;
  if (share !== 0) pan(rig, [-x * share, -y * share]);
}

/**
 * The same, of what has no hold on the picture: a wheel, a key, a button. Going away, the camera never comes to look farther beside what it
 * looked at first, and beyond the distance where it stood first it comes back to that.
 */
export function zoomFrom(rig: CameraRig, factor: number, place: readonly [x: number, y: number]): void {
  const before = rig.goal;
  zoomAt(rig, factor, place);
  if (!(factor > 1)) return;
  const { goal, home } = rig;
  const [was, is] = [before.target, goal.target].map((target) => subtract(target, home.target));
  const [near, far] = [length(was), length(is)];
  const rounding = 1e-9 * goal.radius;
  // At the limit too, where it does not go away any more.
  const share = far > near + rounding ? 1 / factor : Math.min(1, Math.max(before.radius, home.radius) / (before.radius * factor));
  if (far > share * near + rounding) rig.aim({ ...goal, target: add(home.target, scale(was, share)) }, true);
}

/** Where in an element's picture a pointer is. */
export function placeIn(element: HTMLElement, point: PagePoint): [x: number, y: number] {
  const [x, y] = placeInElement(element, point);
  const { clientWidth, clientHeight } = element;
  return [(2 * x - clientWidth) / clientHeight, (clientHeight - 2 * y) / clientHeight];
}
