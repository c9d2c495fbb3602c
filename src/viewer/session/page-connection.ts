import { loadPart } from '../../core/load-part.ts';
import { watchSlices } from '../cuts/cuts.ts';
import type * as Interaction from './interaction.ts';
import { PageWatcher } from '../scenes/page-watcher.ts';
import type { Visibility } from '../scenes/visibility.ts';
import type { ScenePlace } from '../scenes/scene-controller.ts';
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
export interface ConnectionListener extends ViewerListener {
  /** The <volume-slice> children have changed; X3D's volume nodes if `isLook`. */
  slicesChanged(isLook?: boolean): void;
  /** A person wants less motion, or no longer. */
  motionChanged(): void;
}

/** What an element has only while it is in a page: a viewer, the input for its camera, and observers of the page. */
export class PageConnection {
  readonly viewer: Viewer;
  readonly #watcher = new PageWatcher();
  #input: Interaction.CameraInput | null = null;
  /** The code for interaction; null until there is a picture. */
  interaction: typeof Interaction | null = null;
  /** Identifies the last call of `setControls`: an earlier one that is still loading has no effect. */
  #word = {};

  constructor(
    readonly picture: HTMLElement,
    place: ScenePlace,
    listener: ConnectionListener,
  ) {
    this.viewer = new Viewer(place, listener);
    this.#watcher.watchSize(place.host, () => this.viewer.invalidate());
    this.#watcher.watchMotion(() => listener.motionChanged());
    this.#watcher.add(watchSlices(place.host, (isLook) => listener.slicesChanged(isLook)));
  }

  /** Watch how near the element is to the visible part of the page. */
  watch(visibility: Visibility): void {
    visibility.watch(this.viewer.place.host, this.#watcher);
  }

  /** Set whether mouse, touch and keys move the camera. @throws {VolumeViewError} `format/unsupported` */
  async setControls(on: boolean): Promise<void> {
    const { viewer } = this;
    const word = (this.#word = {});
    this.#input?.dispose();
    this.#input = null;
    this.interaction ??= await loadPart(import('./interaction.ts'), 'shows pictures');
    if (on && this.#word === word)
      this.#input = new this.interaction.CameraInput(this.picture, viewer.rig, {
        changed: () => viewer.invalidate(),
        reset: () => viewer.resetCamera(),
      });
  }

  dispose(): void {
    this.#word = {};
    this.#input?.dispose();
    this.viewer.dispose();
    this.#watcher.disconnect();
  }
}
