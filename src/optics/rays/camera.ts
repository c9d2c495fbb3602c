import { add, cross, dot, normalize, scale, subtract, length } from '../../volume/matrix.ts';
import type { Matrix4, Vector3 } from '../../volume/matrix.ts';

/** A pinhole camera in world coordinates. */
export interface Camera {
  readonly eye: Vector3;
  readonly target: Vector3;
  readonly up: Vector3;
  /** Vertical field of view, radians. */
  readonly fieldOfView: number;
}

/** Where a camera stands on a sphere around its target. Names and signs are those of `<model-viewer>`. */
export interface Orbit {
  /** Radians around the vertical axis (world z), counted to the right of the front (world +y). */
  readonly theta: number;
  /** Radians from the zenith: 0 looks straight down, pi / 2 along the horizon. */
  readonly phi: number;
  /** World length from the target to the eye. */
  readonly radius: number;
}

/** The camera of an orbit. At the poles, the up vector is the limit as seen from the front, so nothing flips. */
export function orbitCamera(orbit: Orbit, target: Vector3, fieldOfView: number): Camera {
  const { theta, phi, radius } = orbit;
  const toEye: Vector3 = [-Math.sin(phi) * Math.sin(theta), Math.sin(phi) * Math.cos(theta), Math.cos(phi)];
  const up: Vector3 = [Math.cos(phi) * Math.sin(theta), -Math.cos(phi) * Math.cos(theta), Math.sin(phi)];
  return { eye: add(target, scale(toEye, radius)), target, up, fieldOfView };
}

/** The orbit of an upright camera: the inverse of `orbitCamera`. */
export function orbitOf({ eye, target, up }: Camera): Orbit {
  const radius = length(subtract(eye, target));
  const [x, y, z] = scale(subtract(eye, target), 1 / radius);
  // Straight above and below, only the up vector gives the angle around the axis: this combination of both vectors works
  // everywhere.
  const flat = Math.hypot(x, y);
  return { theta: Math.atan2(up[0] * z - x * flat, y * flat - up[1] * z), phi: Math.atan2(flat, z), radius };
}

/** Row-major world-to-eye matrix. The eye looks along -z, and y is up. */
export function viewMatrix({ eye, target, up }: Camera): Matrix4 {
  const backward = normalize(subtract(eye, target));
  const right = normalize(cross(up, backward));
  const upward = cross(backward, right);
  return [...right, -dot(right, eye), ...upward, -dot(upward, eye), ...backward, -dot(backward, eye), 0, 0, 0, 1];
}

/** Row-major perspective projection. */
export function projectionMatrix(fieldOfView: number, aspect: number, near: number, far: number): Matrix4 {
  const f = 1 / Math.tan(fieldOfView / 2);
  return [
    f / aspect,
    0,
    0,
    0,
    0,
    f,
    0,
    0,
    0,
    0,
    (near + far) / (near - far),
    (2 * near * far) / (near - far),
    0,
    0,
    -1,
    0,
  ];
}

/** The distance at which a sphere just fits into the narrower side of the picture. */
export function framingDistance(radius: number, fieldOfView: number, aspect: number): number {
  const horizontal = 2 * Math.atan(Math.tan(fieldOfView / 2) * aspect);
  return radius / Math.sin(Math.min(fieldOfView, horizontal) / 2);
}
