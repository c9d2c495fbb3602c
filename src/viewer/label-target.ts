import { VolumeViewError } from '../errors.ts';
import type { Volume } from '../volume/volume.ts';
import type { ViewLabels } from './view-labels.ts';
import type { VolumePresenter } from './volume-presenter.ts';

/** What labels are put on. */
export interface LabelTarget {
  /** The last good volume; null before there is one. */
  readonly volume: Volume | null;
  /** Whether a volume is being loaded, or would be: the picture is near enough to be seen soon. */
  readonly awake: boolean;
  /** The file of that volume, for messages. */
  readonly file: string;
  /** Data values that presets and percentages span; null before there is a volume. */
  readonly window: readonly [number, number] | null;
  /** Show labels; null for none. @throws {VolumeViewError} */
  wear(labels: ViewLabels | null): Promise<void>;
  /** How a volume looks that is labels itself, where its page says nothing; null for what its values suggest. */
  dress(transferFunction: string | null): void;
  /** Show a volume's values as labels where they were taken for intensities. @throws {VolumeViewError} */
  takeAsLabels(volume: Volume): Promise<void>;
  /** Work that a script that waits for the picture has to wait for. It does not reject. */
  track(work: Promise<unknown>): void;
  failed(error: unknown): void;
  cleared(): void;
}

/** Labels in a <volume-view>. */
export class PresenterTarget implements LabelTarget {
  constructor(readonly presenter: VolumePresenter) {}

  get volume(): Volume | null {
    return this.presenter.volume;
  }

  get awake(): boolean {
    return this.presenter.user.awake;
  }

  get file(): string {
    return this.presenter.settings.src ?? '';
  }

  get window(): readonly [number, number] | null {
    return this.presenter.look.current?.window ?? this.volume?.window ?? this.volume?.range ?? null;
  }

  async wear(labels: ViewLabels | null): Promise<void> {
    const { viewer } = this.presenter;
    if (!viewer) return;
    const { shown, keeper } = viewer.pictures.parts;
    const [before, now] = [shown.labels, labels].map((one) => one?.shown ?? null);
    shown.labels = labels;
    if (now === before) return;
    // A scene that is being built may have looked for them just before, and is in place when all that waits for nothing is done.
    if (!keeper.scene) await new Promise((resolve) => setTimeout(resolve));
    await keeper.scene?.setLabels(shown.labels?.shown ?? null);
    viewer.invalidate();
  }

  dress(transferFunction: string | null): void {
    const { look } = this.presenter;
    if ((look.dress?.transferFunction ?? null) === transferFunction) return;
    look.dress = transferFunction === null ? null : { transferFunction };
    look.readAnew();
  }

  async takeAsLabels(volume: Volume): Promise<void> {
    const optics = await this.presenter.show({ ...volume, isDiscrete: true }, new AbortController().signal);
    this.presenter.announce(optics);
  }

  track(work: Promise<unknown>): void {
    this.presenter.track(work);
  }

  failed(error: unknown): void {
    this.presenter.errors.report('labels', error);
  }

  cleared(): void {
    this.presenter.errors.clear('labels');
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
