import type { VolumePresenter } from '../../src/viewer/view/volume-presenter.ts';
import type { LabelTarget } from '../../src/viewer/attachments/label-target.ts';
import type { Volume } from '../../src/volume/volume.ts';

/** What holds the samples that companions read too, and the scene that they put lines into: no part of the interface of <volume-view>. Null before they are there. */
export interface VolumeHolder {
  readonly _volume: Volume | null;
  /** With what labels are shown. */
  readonly _presenter: VolumePresenter;
}

/** A <volume-slice-view> with a file of its own. */
export interface LabelledSlices {
  readonly _labelTarget: LabelTarget;
}
