import type { Vector3 } from '../../volume/matrix.ts';
import type { OrbitAttribute } from './parse-attributes.ts';

/** The place of the camera as an author gives it; every part may be absent. */
export interface CameraAttributes extends OrbitAttribute {
  readonly target?: Vector3;
  /** Vertical, radians. */
  readonly fieldOfView?: number;
}

/** Limits for turning a camera and for its distance, and the speed of its movements. */
export interface CameraLimits {
  /** The smallest and the largest angles and distances of the camera; where one is absent, the limit follows from the volume. */
  readonly min: OrbitAttribute;
  readonly max: OrbitAttribute;
  /** Time in which the camera covers 63 % of a move that the page or a button starts, ms; 0 for at once. */
  readonly decay: number;
}

export const defaultLimits: CameraLimits = { min: {}, max: {}, decay: 120 };
