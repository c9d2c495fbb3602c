import type { Vector3 } from '../../volume/matrix.ts';
import type { OrbitAttribute } from './parse-attributes.ts';

/** How an author places the camera; every part may be left out. */
export interface CameraAttributes extends OrbitAttribute {
  readonly target?: Vector3;
  /** Vertical, radians. */
  readonly fieldOfView?: number;
}

/** How far a camera may be turned and moved away, and how it gets there. */
export interface CameraLimits {
  /** Angles and distances that no camera goes below, or above; what is absent has limits that follow from what is seen. */
  readonly min: OrbitAttribute;
  readonly max: OrbitAttribute;
  /** Time in which the camera makes up for 63 % of a way that the page or a button sends it, ms; 0 for at once. */
  readonly decay: number;
}

export const defaultLimits: CameraLimits = { min: {}, max: {}, decay: 120 };
