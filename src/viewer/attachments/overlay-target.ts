import { VolumeViewError } from '../../core/errors.ts';
import { PresenterPlace } from './presenter-place.ts';
import type { Scene } from '../model/scene.ts';
import type { ViewOverlay } from '../model/view-overlay.ts';
import type { ViewSocket } from '../model/view-socket.ts';

/** A second field in a <volume-view>. */
export class OverlayTarget extends PresenterPlace<ViewOverlay> {
  readonly key = 'overlay';

  constructor(socket: ViewSocket) {
    super(socket, 'overlay');
  }

  get overlay(): ViewOverlay | null {
    return this.value;
  }

  protected applyTo(scene: Scene, overlay: ViewOverlay['shown'] | null): Promise<void> {
    return scene.setOverlay(overlay);
  }
}

/** The error for a layer without a volume below it. @param parent - the element around it */
export function noPlace(parent: Element | null): VolumeViewError {
  const got =
    parent?.localName === 'volume-view'
      ? 'is the second one in its <volume-view>; the first one holds, as one layer is shown'
      : 'got no volume around it; expected it between the tags of a <volume-view>';
  return new VolumeViewError('attribute/invalid', `<volume-layer> ${got}.`);
}
