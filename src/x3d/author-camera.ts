import type { Camera } from '../optics/rays/camera.ts';
import { frameViewpoint } from '../optics/rays/viewpoint-frame.ts';
import type { ViewpointFrame } from '../optics/rays/viewpoint-frame.ts';
import { transformPoint } from '../volume/matrix.ts';
import type { Vector3 } from '../volume/matrix.ts';
import type { AuthorNodes } from './author-nodes.ts';
import { toRowMajor } from './scene-camera.ts';
import type { X3dElement } from './x3dom-types.ts';

/** The author's viewpoint. */
export interface AuthorCamera {
  readonly camera: Camera;
  /** In world coordinates; null if the author gave none. */
  readonly centerOfRotation: Vector3 | null;
  /** The viewpoint's frame, relative to what is shown. */
  readonly around: (subject: { center: Vector3; radius: number }) => ViewpointFrame;
}

/** The author's viewpoint as a camera; null if there is none, or if its view is not finite. */
export function readAuthorCamera(author: AuthorNodes, element: X3dElement): AuthorCamera | null {
  const { viewpoint } = author;
  if (!viewpoint) return null;
  const m = toRowMajor(element.runtime!.viewMatrix());
  const eye: Vector3 = [0, 1, 2].map((c) => -(m[c] * m[3] + m[4 + c] * m[7] + m[8 + c] * m[11])) as unknown as Vector3;
  const backward: Vector3 = [m[8], m[9], m[10]];
  const { x, y, z } = viewpoint.getCenterOfRotation();
  const given = author.isGivenByViewpoint('centerofrotation');
  if (!m.every(Number.isFinite)) return null;
  const camera: Camera = {
    eye,
    target: [eye[0] - backward[0], eye[1] - backward[1], eye[2] - backward[2]],
    up: [m[4], m[5], m[6]],
    fieldOfView: viewpoint.getFieldOfView(),
  };
  const centerOfRotation: Vector3 | null = given
    ? transformPoint(toRowMajor(viewpoint.getCurrentTransform()), [x, y, z])
    : null;
  return { camera, centerOfRotation, around: (subject) => frameViewpoint(camera, centerOfRotation, subject) };
}
