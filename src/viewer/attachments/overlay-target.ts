import { VolumeViewError } from '../../core/errors.ts';
import { PresenterPlace } from './presenter-place.ts';
import type { ViewOverlay } from '../model/view-overlay.ts';
import type { VolumePresenter } from '../view/volume-presenter.ts';

/** A second field in a <volume-view>. */
export class OverlayTarget extends PresenterPlace {
  constructor(presenter: VolumePresenter) {
    super(presenter, 'overlay');
  }

  /** Show a layer; null for none. @throws {VolumeViewError} */
  wear(overlay: ViewOverlay | null): Promise<void> {
    return this.tellScene((shown) => {
      const before = shown.overlay;
      shown.overlay = overlay;
      return before?.shown !== overlay?.shown;
    }, (scene) => scene.setOverlay(this.presenter.viewer?.pictures.parts.shown.overlay?.shown ?? null));
  }
}

/** The error for a layer that has nothing to be over. @param parent - what is around it */
export function noPlace(parent: Element | null): VolumeViewError {
  const got = parent?.localName === 'volume-view' ? 'is the second one in its <volume-view>; the first one holds, as one layer is shown' : 'got no volume around it; expected it between the tags of a <volume-view>';
  return new VolumeViewError('attribute/invalid', `<volume-layer> ${got}.`);
}
