import { loadPart } from '../../core/load-part.ts';
import { watchSlices } from '../cuts/cuts.ts';
import type * as Hands from './hands.ts';
import { PageWatcher } from '../scenes/page-watcher.ts';
import type { Presence } from '../scenes/presence.ts';
import type { ScenePlace } from '../scenes/scene-keeper.ts';
import { Viewer } from '../view/viewer.ts';
import type { ViewerListener } from '../view/viewer.ts';

/** The parts of an element that a page connection uses. */
export interface PagePlace {
  /** Receives mouse, touch and keyboard events. */
  readonly picture: HTMLElement;
  /** Contains the canvas. */
  readonly container: Element;
}

/** What a page connection reports. */
export interface VisitListener extends ViewerListener {
  /** The <volume-slice> children have changed; X3D's volume nodes if `isLook`. */
  slicesChanged(isLook?: boolean): void;
  /** A person wants less motion, or no longer. */
  motionChanged(): void;
}

/** What an element has only while it is in a page: a viewer, the input for its camera, and observers of the page. */
export class PageVisit {
  readonly viewer: Viewer;
  readonly #watcher = new PageWatcher();
  #input: Hands.CameraInput | null = null;
  /** The code for interaction; null until there is a picture. */
  hands: typeof Hands | null = null;
  /** Identifies the last call of `setControls`: an earlier one that is still loading has no effect. */
  #word = {};

  constructor(readonly picture: HTMLElement, place: ScenePlace, listener: VisitListener) {
    this.viewer = new Viewer(place, listener);
    this.#watcher.watchSize(place.host, () => this.viewer.invalidate());
    this.#watcher.watchMotion(() => listener.motionChanged());
    this.#watcher.add(watchSlices(place.host, (isLook) => listener.slicesChanged(isLook)));
  }

  /** Watch how near the element is to the visible part of the page. */
  watch(presence: Presence): void {
    presence.watch(this.viewer.place.host, this.#watcher);
  }

  /** Set whether mouse, touch and keys move the camera. @throws {VolumeViewError} `format/unsupported` */
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
