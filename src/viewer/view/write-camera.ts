import { orbitOf } from '../../optics/rays/camera.ts';
import type { Camera, Orbit } from '../../optics/rays/camera.ts';
import type { TimeChangeDetail } from '../loading/scan-player.ts';

/** A view as far as a person changes it. */
export interface LiveView {
  readonly viewer: {
    /** Whether the camera is not where the attributes place it. */
    readonly leftAttributes: boolean;
    readonly camera: CameraState | null;
  } | null;
  readonly scan: TimeChangeDetail | null;
}

/** All values of a camera. */
export interface CameraState extends Camera {
  /** As in `camera-change`: around the author's viewpoint, where there is one. */
  readonly orbit: Orbit;
}

/** The attributes that place a camera. They keep it upright, so a tilt by the author's viewpoint is lost. */
export interface CameraTexts {
  readonly 'camera-orbit': string;
  readonly 'camera-target': string;
  readonly 'field-of-view': string;
}

/** A camera as attributes: to a thousandth of a degree, and a millionth of its distance. */
export function writeCamera(camera: Camera): CameraTexts {
  const { target, fieldOfView } = camera;
  const { theta, phi, radius } = orbitOf(camera);
  const digits = Math.min(100, Math.max(0, 6 - Math.floor(Math.log10(radius))));
  const write = (number: number, decimals = digits): number => Number(number.toFixed(decimals));
  const writeAngle = (angle: number): string => `${write((angle * 180) / Math.PI, 3)}deg`;
  return {
    'camera-orbit': `${writeAngle(theta)} ${writeAngle(phi)} ${write(radius)}`,
    'camera-target': target.map((one) => write(one)).join(' '),
    'field-of-view': writeAngle(fieldOfView),
  };
}

/** What a person has changed without a change of an attribute: the place of the camera, and the scan. */
export function writeLive({ viewer, scan }: LiveView): Record<string, string> {
  const camera = viewer?.leftAttributes ? viewer.camera : null;
  return {
    ...(camera && writeCamera(camera)),
    ...(scan && scan.count > 1 && { time: `${scan.index}` }),
  };
}
