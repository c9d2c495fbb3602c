import { CameraInput } from './camera-input.ts';
import { watchSlices } from './cuts.ts';
import { PageWatcher } from './page-watcher.ts';
import type { Presence } from './presence.ts';
import type { ScenePlace } from './scene-keeper.ts';
import { Viewer } from './viewer.ts';
import type { ViewerListener } from './viewer.ts';

/** Where an element shows what, while it is in a page. */
export interface PagePlace {
  /** Takes the mouse, fingers and keys. */
  readonly picture: HTMLElement;
  /** Takes the canvas. */
  readonly container: Element;
}

/** What happens during a visit. */
export interface VisitListener extends ViewerListener {
  /** The <volume-slice> children are others. */
  slicesChanged(): void;
}

/** What an element has only while it is in a page: a viewer, a person's hand on its camera, and an eye on the page. */
export class PageVisit {
  readonly viewer: Viewer;
  readonly #watcher = new PageWatcher();
  #input: CameraInput | null = null;

  constructor(readonly picture: HTMLElement, place: ScenePlace, listener: VisitListener) {
    this.viewer = new Viewer(place, listener);
    this.#watcher.watchSize(place.host, () => this.viewer.invalidate());
    this.#watcher.add(watchSlices(place.host, () => listener.slicesChanged()));
  }

  /** Follow how near the element is to what a person sees. */
  watch(presence: Presence): void {
    presence.watch(this.viewer.place.host, this.#watcher);
  }

  /** Whether mouse, fingers and keys move the camera. */
  setControls(on: boolean): void {
    this.#input?.dispose();
    const { viewer } = this;
    this.#input = on
      ? new CameraInput(this.picture, viewer.rig, { changed: () => viewer.invalidate(), reset: () => viewer.resetCamera() })
      : null;
  }

  dispose(): void {
    this.#input?.dispose();
    this.viewer.dispose();
    this.#watcher.disconnect();
  }
}
