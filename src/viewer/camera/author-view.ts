import type { CameraRig } from './camera-rig.ts';
import type { Scene } from '../model/scene.ts';

/** Keeps the camera rig and the author's own viewpoint, where there is one, in step. Scenes may come and go meanwhile. */
export class AuthorView {
  /** Whether the author has a viewpoint. */
  #drives = false;
  #last = '';
  /** The author's viewpoint as it was before a person moved it. */
  #given = '';
  /** The next scene begins at the author's viewpoint, wherever a person had moved it. */
  #anew = false;

  constructor(readonly rig: CameraRig) {}

  get drives(): boolean {
    return this.#drives;
  }

  /** Turning starts from the author's viewpoint, and again whenever they change it. @param force - also where they did not */
  follow(scene: Scene | null, force = false): void {
    if (!scene) {
      this.#anew ||= force;
      return;
    }
    this.#anew = false;
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

  /** Follow in a new scene: a person's turn around a viewpoint that is what it was holds on. */
  enter(scene: Scene): void {
    const author = scene.authorCamera();
    if (author && !this.#anew && JSON.stringify(author.camera) === this.#given) this.#last = this.#given;
    else this.follow(scene, true);
  }

  /** Look at the scene from where the rig is, unless the author's viewpoint stands where they put it. */
  aim(scene: Scene, aspect: number): void {
    this.rig.setAspect(aspect);
    if (this.#drives && !this.rig.touched && !this.rig.moving && !this.rig.spun) return;
    scene.setCamera(this.rig.camera);
    if (this.#drives) this.#last = JSON.stringify(scene.authorCamera()!.camera);
  }
}
