import { asVolumeViewError, VolumeViewError } from '../../core/errors.ts';
import type { Stop, TransferFunction } from '../../optics/transfer/transfer-function.ts';
import { asLabels } from '../../volume/label-volume.ts';
import type { Volume } from '../../volume/volume.ts';
import { PresenterPlace } from './presenter-place.ts';
import type { LabelTarget } from '../model/label-target.ts';
import type { Scene } from '../model/scene.ts';
import type { ViewLabels } from '../model/view-labels.ts';
import type { ViewSocket } from '../model/view-socket.ts';

export type { LabelTarget } from '../model/label-target.ts';

/** Whether two transfer functions have the same stops. */
function isSame(one: TransferFunction | null, other: TransferFunction | null): boolean {
  const isLike = (a: Stop, b: Stop): boolean =>
    a.value === b.value && a.opacity === b.opacity && a.color.every((x, c) => x === b.color[c]);
  return one === other || (one?.length === other?.length && one!.every((stop, i) => isLike(stop, other![i])));
}

/** Labels in a <volume-view>. */
export class PresenterTarget extends PresenterPlace<ViewLabels> implements LabelTarget {
  readonly key = 'labels';

  constructor(socket: ViewSocket) {
    super(socket, 'labels');
  }

  get labels(): ViewLabels | null {
    return this.value;
  }

  get window(): readonly [number, number] | null {
    return this.view.look.current?.window ?? this.volume?.window ?? this.volume?.range ?? null;
  }

  /** In a projection there are no ghosts: a hidden label would count as much as all others. */
  get showsGhosts(): boolean {
    return this.view.look.current?.projection === null;
  }

  protected applyTo(scene: Scene, labels: ViewLabels['shown']): Promise<void> {
    return scene.setLabels(labels);
  }

  replaceTransferFunction(transferFunction: TransferFunction | null): void {
    const { look: appearance } = this.view;
    if (isSame(appearance.replacement?.transferFunction ?? null, transferFunction)) return;
    appearance.replacement = transferFunction === null ? null : { transferFunction };
    appearance.readAgain();
  }

  takeAsLabels(volume: Volume): Promise<void> {
    return this.view.replace(asLabels(volume));
  }

  override failed(error: unknown): void {
    const reported = asVolumeViewError(error, 'labels');
    // Errors of attributes already have suitable messages.
    if (/^(source|format)/.test(reported.code)) reported.topic = 'labels';
    super.failed(reported);
  }
}

/** Whether an element is a pane with its own file. */
export function isOwnPane(parent: Element | null): boolean {
  return parent?.localName === 'volume-slice-view' && parent.hasAttribute('src');
}

/** The error for labels without a volume. @param parent - the element around them */
export function noTarget(parent: Element | null): VolumeViewError {
  const got =
    parent?.localName === 'volume-view' || isOwnPane(parent)
      ? `is the second one in its <${parent!.localName}>; the first one holds. Put what it says into one`
      : 'got no volume around it; expected it between the tags of a <volume-view>, or of a <volume-slice-view> with src';
  return new VolumeViewError('attribute/invalid', `<volume-labels> ${got}.`);
}
