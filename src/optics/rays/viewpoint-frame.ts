import { add, cross, dot, length, normalize, scale, subtract } from '../../volume/matrix.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import type { Camera } from './camera.ts';

/** A viewpoint, as a frame in which it can turn around a target. */
export interface ViewpointFrame {
  /** Unit vectors: to the right, to the eye, and up. */
  readonly frame: readonly [Vector3, Vector3, Vector3];
  readonly target: Vector3;
  /** Radians. */
  readonly fieldOfView: number;
  /** World length from the target to the eye. */
  readonly radius: number;
}

/**
 * The frame in which a camera turns around its centre of rotation. If there is none, or the camera stands at it or right above it, it turns
 * around the point of its axis that is nearest to the subject.
 */
export function frameViewpoint(
  camera: Camera,
  centerOfRotation: Vector3 | null,
  subject: { center: Vector3; radius: number },
): ViewpointFrame {
  const forward = normalize(subtract(camera.target, camera.eye));
  const ahead = dot(subtract(subject.center, camera.eye), forward);
  const target = centerOfRotation ?? add(camera.eye, scale(forward, Math.max(ahead, subject.radius * 0.1)));
  const toEye = normalize(subtract(camera.eye, target));
  const right = normalize(cross(camera.up, toEye));
  const frame = [scale(right, -1), toEye, cross(toEye, right)] as const;
  if (centerOfRotation && !frame.flat().every(Number.isFinite)) return frameViewpoint(camera, null, subject);
  return { frame, target, fieldOfView: camera.fieldOfView, radius: length(subtract(camera.eye, target)) };
}
