import type { Camera } from '../../optics/rays/camera.ts';
import type { CameraRig } from './camera-rig.ts';
import type { Scene } from '../model/scene.ts';

/** Keeps the camera rig in agreement with the author's own viewpoint, where there is one. Scenes may come and go meanwhile. */
export class AuthorView {
  /** Whether the author has a viewpoint. */
  #drives = false;
  #last = '';
  /** The author's viewpoint as it was before a person moved it. */
  #given = '';
  /** Whether the next scene starts at the author's viewpoint, even if a person had moved it. */
  #again = false;

  constructor(readonly rig: CameraRig) {}

  get drives(): boolean {
    return this.#drives;
  }

  /**
   * Turning starts from the author's viewpoint, and again whenever the author changes it.
   * @param force - restart also where it has not changed
   */
  follow(scene: Scene | null, force = false): void {
    if (!scene) {
      this.#again ||= force;
      return;
    }
    this.#again = false;
    const author = scene.authorCamera();
    const left = this.#drives && !author;
    this.#drives = author !== null;
    if (left) this.rig.resetAtOnce();
    if (!author) return;
    const now = JSON.stringify(author.camera);
    if (force || now !== this.#last) {
      this.rig.setViewpoint(author.around);
      this.#given = now;
    }
    this.#last = now;
  }

  /** Follow in a new scene: if the viewpoint has not changed, a person's turn around it is kept. */
  enter(scene: Scene): void {
    const author = scene.authorCamera();
    if (author && !this.#again && JSON.stringify(author.camera) === this.#given) this.#last = this.#given;
    else this.follow(scene, true);
  }

  /** The camera of a picture: that of the rig; null while the author's viewpoint is still where the author put it. */
  cameraFor(aspect: number): Camera | null {
    this.rig.setAspect(aspect);
    return this.#drives && !this.rig.touched && !this.rig.moving && !this.rig.spun ? null : this.rig.camera;
  }

  /** A scene uses a plan with this camera. */
  applied(scene: Scene, camera: Camera | null): void {
    if (camera && this.#drives) this.#last = JSON.stringify(scene.authorCamera()!.camera);
  }
}
