import type { PropertyValues } from 'lit';
import type { VolumeViewError } from '../../src/core/errors.ts';
import { writeColor } from '../../src/optics/transfer/write-transfer-function.ts';
import { childrenOf } from '../../src/page/page-children.ts';
import { readLabelChildren } from '../../src/viewer/attachments/label-children.ts';
import { LabelController } from '../../src/viewer/attachments/label-controller.ts';
import { isOwnPane, noTarget, PresenterTarget } from '../../src/viewer/attachments/label-target.ts';
import type { LabelTarget } from '../../src/viewer/model/label-target.ts';
import { socketOf } from '../../src/viewer/model/view-socket.ts';
import type { LabelEntry } from '../../src/viewer/model/view-labels.ts';
import type { ViewPart } from '../../src/viewer/model/view-socket.ts';
import { AttachmentElement } from '../internal/attachment-element.ts';
import { property } from '../internal/reflecting-element.ts';
import { emit } from '../internal/volume-view-events.ts';

/** One label of a volume, as pages and companions get it. */
export interface VolumeLabelInfo {
  /** The id in the file; 0 stands for voxels without a label. */
  readonly id: number;
  /** Its name, or its number where it has no name; '' for voxels without a label. */
  readonly name: string;
  /** '#rrggbb' */
  readonly color: string;
  /** 0..1 */
  readonly opacity: number;
  readonly hidden: boolean;
}

/**
 * The names of the parts of a volume: an atlas or a segmentation in addition to the scan, with its table of names and colours. It
 * colours the volume of the `<volume-view>` around it, in 3D and in its panes, and names the part at the pointer.
 *
 * With `hidden` the volume is shown without them.
 *
 * `<volume-view src="head.nii.gz"><volume-labels src="atlas.nii.gz" table="dseg.tsv"></volume-labels></volume-view>`
 *
 * @tag volume-labels
 * @slot - `<volume-label>` elements, which override the table for a label
 * @fires {CustomEvent<null>} labels-change - the labels or their appearance have changed; it bubbles
 * @fires {CustomEvent<ErrorDetail>} error - something failed; the last good labels stay
 */
export class VolumeLabels extends AttachmentElement<LabelTarget> {
  /**
   * A file with a label, a whole number, for each voxel: NIfTI, NRRD, MetaImage, MGZ and others. Without it, the values of the volume itself are the
   * labels.
   */
  @property() src!: string | null;

  /** A table of names and colours in a format of BIDS, FreeSurfer, ITK-SNAP, 3D Slicer or NiiVue. */
  @property() table!: string | null;

  /**
   * Transfer function for all labels whose `<volume-label>` has none: the name of a preset, or stops. By default that of the whole volume.
   */
  @property({ attribute: 'transfer-function' }) transferFunction!: string | null;

  /**
   * The ids of the labels that are shown, separated by blanks, `17 18`; 0 stands for voxels without a label. Everything else is hidden, or
   * with the word `ghost`, `17 18 ghost`, a grey trace. By default all are shown but those with `hidden`. Setting it takes back what a
   * person or a script has chosen.
   */
  @property() only!: string | null;

  readonly #watcher = new MutationObserver((records) => this.#follow(records));
  protected override readonly controller = new LabelController({
    said: () => readLabelChildren(this),
    wanted: () => ({
      src: this.src,
      table: this.table,
      hidden: this.hasAttribute('hidden'),
      transferFunction: this.transferFunction,
      only: this.only,
    }),
    target: () => this.target,
    changed: () => this.dispatchEvent(new CustomEvent('labels-change', { detail: null, bubbles: true })),
    failed: (error) => this.reportError(error),
  });

  /** What panes and companions use of the labels. */
  readonly #part: ViewPart = {
    key: 'volume-labels',
    element: this,
    inPane: (volume, opacity) => this.controller.inPane(volume, opacity),
    // The other hidden labels stay as they are, with or without a ghost.
    showLabel: (id, isShown) => {
      const others = this.hiddenLabels.filter((other) => other !== id);
      this.controller.choose(isShown ? others : [...others, id]);
    },
  };

  /**
   * The labels in the file, first the voxels without a label (id 0), unless the values of the volume are the labels; empty before they are
   * loaded.
   */
  get labels(): readonly VolumeLabelInfo[] {
    return this.controller.entries.map(infoOf);
  }

  /** The ids of the labels that are not shown. Setting it shows all others. */
  get hiddenLabels(): readonly number[] {
    return this.controller.entries.filter(({ hidden }) => hidden).map(({ id }) => id);
  }

  set hiddenLabels(ids: readonly number[]) {
    this.controller.choose(ids, false);
  }

  /**
   * Show some labels and nothing else, not even voxels without a label.
   * @param ids - of the labels
   * @param rest - `ghost` shows everything else as a grey trace around them, until `showAll()` or `hiddenLabels` is set
   */
  showOnly(ids: readonly number[], rest?: 'ghost'): void {
    const shown = new Set(ids);
    this.controller.choose(
      this.controller.entries.filter(({ id }) => !shown.has(id)).map(({ id }) => id),
      rest === 'ghost',
    );
  }

  /** Show all labels, and voxels without one. */
  showAll(): void {
    this.hiddenLabels = [];
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.#watcher.observe(this, {
      childList: true,
      subtree: true,
      attributes: true,
      attributeFilter: ['value', 'name', 'color', 'opacity', 'hidden', 'transfer-function'],
    });
  }

  protected override updated(changed: PropertyValues<this>): void {
    if (changed.has('only')) this.controller.forgetChoices();
    if (changed.has('src') || changed.has('table')) this.controller.refresh();
    else if (changed.has('transferFunction') || changed.has('only')) this.controller.restyle();
  }

  protected override get file(): string {
    return this.src ?? this.table ?? '';
  }

  protected override refuse(around: HTMLElement | null): VolumeViewError | null {
    const canBe = isOwnPane(around) || around?.localName === 'volume-view';
    return canBe && childrenOf(around!, 'volume-labels')[0] === this ? null : noTarget(around);
  }

  protected override join(around: HTMLElement, signal: AbortSignal): LabelTarget {
    around.addEventListener('optics-change', () => this.controller.rewindow(), { signal });
    const socket = socketOf(around);
    void socket.join(this.#part);
    signal.addEventListener('abort', () => void socket.leave(this.#part));
    return isOwnPane(around) ? socket.last('labelTarget')! : new PresenterTarget(socket);
  }

  /** The events of this element no longer reach the companions of the view that it has left, so the event is fired on the view. */
  protected override left(around: HTMLElement): void {
    emit(around, 'labels-change', null);
  }

  #follow(records: readonly MutationRecord[]): void {
    for (const { target, attributeName } of records) {
      if (attributeName === 'hidden' && target !== this)
        this.controller.forgetChoice(Number((target as Element).getAttribute('value')));
    }
    if (records.some(({ target, attributeName }) => target === this && attributeName === 'hidden'))
      this.controller.refresh();
    else if (records.some(({ type, target }) => type === 'childList' || target !== this)) this.controller.restyle();
  }
}

/** The infos of entries. An entry stays the same object as long as nothing of it changes, and so does its info. */
const infos = new WeakMap<LabelEntry, VolumeLabelInfo>();

function infoOf(entry: LabelEntry): VolumeLabelInfo {
  const { id, name, color, opacity, hidden } = entry;
  const info = infos.get(entry) ?? { id, name, color: writeColor(color), opacity, hidden };
  infos.set(entry, info);
  return info;
}

declare global {
  interface HTMLElementTagNameMap {
    'volume-labels': VolumeLabels;
  }
}
