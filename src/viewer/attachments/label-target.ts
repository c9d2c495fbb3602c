import { asVolumeViewError, VolumeViewError } from '../../core/errors.ts';
import type { Stop, TransferFunction } from '../../optics/transfer/transfer-function.ts';
import { asLabels } from '../../volume/label-volume.ts';
import type { Volume } from '../../volume/volume.ts';
import type { BesideTarget } from './beside-keeper.ts';
import { PresenterPlace } from './presenter-place.ts';
import type { ViewLabels } from '../model/view-labels.ts';
import type { VolumePresenter } from '../view/volume-presenter.ts';

/** What labels are put on. */
export interface LabelTarget extends BesideTarget {
  /** The file of that volume, for messages. */
  readonly file: string;
  /** Data values that presets and percentages span; null before there is a volume. */
  readonly window: readonly [number, number] | null;
  /** Whether what is hidden can be seen as a trace. */
  readonly showsGhosts: boolean;
  /** Show labels; null for none. @throws {VolumeViewError} */
  wear(labels: ViewLabels | null): Promise<void>;
  /** How a volume looks that is labels itself, where its page says nothing; null for what its values suggest. */
  dress(transferFunction: TransferFunction | null): void;
  /** Show a volume's values as labels where they were taken for intensities. @throws {VolumeViewError} */
  takeAsLabels(volume: Volume): Promise<void>;
}

/** Whether two transfer functions have the same stops. */
function isSame(one: TransferFunction | null, other: TransferFunction | null): boolean {
  const isLike = (a: Stop, b: Stop): boolean => a.value === b.value && a.opacity === b.opacity && a.color.every((x, c) => x === b.color[c]);
  return one === other || (one?.length === other?.length && one!.every((stop, i) => isLike(stop, other![i])));
}

/** Labels in a <volume-view>. */
export class PresenterTarget extends PresenterPlace implements LabelTarget {
  constructor(presenter: VolumePresenter) {
    super(presenter, 'labels');
  }

  get window(): readonly [number, number] | null {
    return this.presenter.look.current?.window ?? this.volume?.window ?? this.volume?.range ?? null;
  }

  /** Of values of rays there are no traces: what is hidden would count as much as all else. */
  get showsGhosts(): boolean {
    return this.presenter.look.current?.projection === null;
  }

  wear(labels: ViewLabels | null): Promise<void> {
    return this.tellScene((shown) => {
      const [before, now] = [shown.labels, labels].map((one) => one?.shown ?? null);
      shown.labels = labels;
      return now !== before;
    }, (scene) => scene.setLabels(this.presenter.viewer?.pictures.parts.shown.labels?.shown ?? null));
  }

  dress(transferFunction: TransferFunction | null): void {
    const { look } = this.presenter;
    if (isSame(look.dress?.transferFunction ?? null, transferFunction)) return;
    look.dress = transferFunction === null ? null : { transferFunction };
    look.readAnew();
  }

  async takeAsLabels(volume: Volume): Promise<void> {
    const optics = await this.presenter.show(asLabels(volume), new AbortController().signal);
    this.presenter.announce(optics);
  }

  override failed(error: unknown): void {
    const told = asVolumeViewError(error, 'labels');
    // Attributes have words that fit.
    if (/^(source|format)/.test(told.code)) told.topic = 'labels';
    super.failed(told);
  }
}

/** Whether an element is a pane with a file of its own. */
export function isOwnPane(parent: Element | null): boolean {
  return parent?.localName === 'volume-slice-view' && parent.hasAttribute('src');
}

/** The error for labels that have nothing to be on. @param parent - what is around them */
export function noTarget(parent: Element | null): VolumeViewError {
  const got = parent?.localName === 'volume-view' || isOwnPane(parent) ? `is the second one in its <${parent!.localName}>; the first one holds. Put what it says into one` : 'got no volume around it; expected it between the tags of a <volume-view>, or of a <volume-slice-view> with src';
  return new VolumeViewError('attribute/invalid', `<volume-labels> ${got}.`);
}
