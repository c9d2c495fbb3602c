import type { Camera } from '../../optics/rays/camera.ts';
import { add, length, subtract } from '../../volume/matrix.ts';
import type { Vector3 } from '../../volume/matrix.ts';

/** A view whose camera follows that of another one. */
export interface FollowingView {
  /** Where its camera is going, in its own world; null while it has no picture. */
  readonly camera: Camera | null;
  /** Where the origin of its world is, in the world of both; world length. */
  readonly origin: Vector3;
  /** Send its camera there, in its own world. Its limits may stop it before. */
  follow(camera: Camera): void;
}

/**
 * One camera for two views. The view whose camera was moved leads, whichever it is; the other one follows. A view that was sent somewhere does not lead for it, and one
 * whose limits stop it does not pull the other back.
 */
export class SharedCamera {
  /** The camera of each view that is known: moved by anything else, it leads. */
  readonly #known: (Camera | null)[] = [null, null];
  /** In the world of both. */
  #camera: Camera | null = null;
  /** Whether somebody has moved it since its first place. */
  #isMoved = false;

  constructor(readonly views: readonly [FollowingView, FollowingView]) {}

  /** A view has a new picture, or another camera. @param index - of the view */
  update(index: 0 | 1): void {
    const view = this.views[index];
    const known = this.#known[index];
    const { camera } = view;
    if (!camera || (known && isSame(camera, known))) return;
    // Until somebody moves a camera, both are where the first view places it, whichever comes first.
    const isLeading = known !== null || !this.#camera || (index === 0 && !this.#isMoved);
    if (!isLeading) return this.#send(index);
    this.#isMoved ||= known !== null;
    this.#known[index] = camera;
    this.#camera = shift(camera, view.origin, 1);
    this.#send(index === 0 ? 1 : 0);
  }

  #send(index: 0 | 1): void {
    const view = this.views[index];
    if (!view.camera) return;
    view.follow(shift(this.#camera!, view.origin, -1));
    this.#known[index] = view.camera;
  }
}

function shift(camera: Camera, origin: Vector3, sign: 1 | -1): Camera {
  const by = (place: Vector3): Vector3 => (sign > 0 ? add(place, origin) : subtract(place, origin));
  return { ...camera, eye: by(camera.eye), target: by(camera.target) };
}

/** Whether no picture shows a difference. */
function isSame(a: Camera, b: Camera): boolean {
  const slack = 1e-7 * length(subtract(b.eye, b.target));
  return (
    length(subtract(a.eye, b.eye)) <= slack &&
    length(subtract(a.target, b.target)) <= slack &&
    length(subtract(a.up, b.up)) <= 1e-6 &&
    Math.abs(a.fieldOfView - b.fieldOfView) <= 1e-9
  );
}
