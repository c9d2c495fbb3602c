import type { StandardViewName } from '../../messages/messages.ts';
import type { VolumeInfo } from '../model/volume-info.ts';

/** A direction of the camera, radians: around the vertical axis, with 0 at the front, and from straight above. */
export interface StandardView {
  readonly name: StandardViewName;
  readonly theta: number;
  readonly phi: number;
}

const degree = Math.PI / 180;
const level = 90 * degree;

/** A theta of 90 degrees is the left of a patient, who faces the person in front. */
const sides: readonly StandardView[] = [
  { name: 'front', theta: 0, phi: level },
  { name: 'back', theta: 180 * degree, phi: level },
  { name: 'left', theta: 90 * degree, phi: level },
  { name: 'right', theta: -90 * degree, phi: level },
  { name: 'top', theta: 0, phi: 0 },
  { name: 'bottom', theta: 0, phi: 180 * degree },
];

/** From a little above the ground, with the east at +x; in the view from above, north is up. */
const compass: readonly StandardView[] = [
  { name: 'south', theta: 180 * degree, phi: 75 * degree },
  { name: 'north', theta: 0, phi: 75 * degree },
  { name: 'west', theta: 90 * degree, phi: 75 * degree },
  { name: 'east', theta: -90 * degree, phi: 75 * degree },
  { name: 'above', theta: 180 * degree, phi: 0 },
];

/** The standard views of a volume that a person can choose. */
export function listStandardViews({ moment, site }: Pick<VolumeInfo, 'moment' | 'site'>): readonly StandardView[] {
  return moment !== undefined || site !== undefined ? compass : sides;
}
