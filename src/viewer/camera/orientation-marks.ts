import { orbitCamera } from '../../optics/rays/camera.ts';
import type { Camera } from '../../optics/rays/camera.ts';
import { cross, dot, normalize, subtract } from '../../volume/matrix.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import { isPatient } from '../../volume/world-axes.ts';
import { listStandardViews } from './standard-views.ts';
import type { StandardView } from './standard-views.ts';
import type { VolumeInfo } from '../model/volume-info.ts';

/** A side of the volume, and its place in the picture, relative to the middle. */
export interface OrientationMark {
  /** The view to which the mark turns the camera. */
  readonly view: StandardView;
  /** To the right, up, and towards the person: together of length 1. */
  readonly x: number;
  readonly y: number;
  readonly towards: number;
}

/**
 * The sides that have a letter: those of a patient, or of a radar's map. There are none if the file does not say to whom its axes
 * refer.
 */
export function listSides(
  volume: Pick<VolumeInfo, 'moment' | 'site' | 'anatomical' | 'unit'>,
): readonly StandardView[] {
  const sides = listStandardViews(volume).filter(({ name }) => name !== 'above');
  return isPatient(volume) || sides.length === 4 ? sides : [];
}

/** The places where a camera shows the sides of a volume. */
export function placeMarks({ eye, target, up }: Camera, sides: readonly StandardView[]): readonly OrientationMark[] {
  const towards = normalize(subtract(eye, target));
  const right = normalize(cross(up, towards));
  const upward = cross(towards, right);
  return sides.map((view) => {
    // A map's sides are horizontal, however high the camera is.
    const phi = sides.length === 4 ? Math.PI / 2 : view.phi;
    const direction: Vector3 = orbitCamera({ theta: view.theta, phi, radius: 1 }, [0, 0, 0], 1).eye;
    return { view, x: dot(direction, right), y: dot(direction, upward), towards: dot(direction, towards) };
  });
}
