import { loadPart } from '../../core/load-part.ts';
import { watchSlices } from '../cuts/cuts.ts';
import type * as Hands from './hands.ts';
import { PageWatcher } from '../scenes/page-watcher.ts';
import type { Presence } from '../scenes/presence.ts';
import type { ScenePlace } from '../scenes/scene-keeper.ts';
import { Viewer } from '../view/viewer.ts';
import type { ViewerListener } from '../view/viewer.ts';

/** Where an element shows what, while it is in a page. */
export interface PagePlace {
  /** Takes the mouse, fingers and keys. */
  readonly picture: HTMLElement;
  /** Takes the canvas. */
  readonly container: Element;
}

/** What happens during a visit. */
export interface VisitListener extends ViewerListener {
  /** The <volume-slice> children are others; X3D's volume nodes if `isLook`. */
  slicesChanged(isLook?: boolean): void;
  /** A person wants less motion, or no longer. */
  motionChanged(): void;
}

/** What an element has only while it is in a page: a viewer, a person's hand on its camera, and an eye on the page. */
export class PageVisit {
  readonly viewer: Viewer;
  readonly #watcher = new PageWatcher();
  #input: Hands.CameraInput | null = null;
  /** null until there is a picture. */
  hands: typeof Hands | null = null;
  /** The last word on whether there are hands. */
  #word = {};

  constructor(readonly picture: HTMLElement, place: ScenePlace, listener: VisitListener) {
    this.viewer = new Viewer(place, listener);
    this.#watcher.watchSize(place.host, () => this.viewer.invalidate());
    this.#watcher.watchMotion(() => listener.motionChanged());
    this.#watcher.add(watchSlices(place.host, (isLook) => listener.slicesChanged(isLook)));
  }

  /** Follow how near the element is to what a person sees. */
  watch(presence: Presence): void {
    presence.watch(this.viewer.place.host, this.#watcher);
  }

  /** Whether mouse, fingers and keys move the camera. @throws {VolumeViewError} `format/unsupported` */
  async setControls(on: boolean): Promise<void> {
    const { viewer } = this;
    const word = (this.#word = {});
    this.#input?.dispose();
    this.#input = null;
    this.hands ??= await loadPart(import('./hands.ts'), 'turns the picture by hand');
    if (on && this.#word === word) this.#input = new this.hands.CameraInput(this.picture, viewer.rig, { changed: () => viewer.invalidate(), reset: () => viewer.resetCamera() });
  }

  dispose(): void {
    this.#word = {};
    this.#input?.dispose();
    this.viewer.dispose();
    this.#watcher.disconnect();
  }
}
