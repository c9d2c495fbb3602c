import type { VolumeViewError } from '../../src/core/errors.ts';
import type { Stop } from '../../src/optics/transfer/transfer-function.ts';
import { OverlayController } from '../../src/viewer/attachments/overlay-controller.ts';
import { childrenOf } from '../../src/page/page-children.ts';
import { noPlace, OverlayTarget } from '../../src/viewer/attachments/overlay-target.ts';
import { socketOf } from '../../src/viewer/model/view-socket.ts';
import { describeVolume } from '../../src/viewer/model/volume-info.ts';
import type { VolumeInfo } from '../../src/viewer/model/volume-info.ts';
import { AttachmentElement } from '../internal/attachment-element.ts';
import { number, pairOrText, transferFunction } from '../internal/property-kinds.ts';
import { property, writeSafely } from '../internal/reflecting-element.ts';

/** The appearance of a layer: its stops, and the data values that presets and percentages refer to. */
export interface LayerLook {
  readonly transferFunction: readonly Stop[];
  readonly window: readonly [number, number];
}

/**
 * A second volume over the first one: a map of statistics on a brain, a PET on a CT. Its file gives its position; it has a grid of its own.
 * Parts outside the box of the first volume are not shown. A `<volume-view>` can have one layer.
 *
 * With `hidden` the volume is shown without it.
 *
 * `<volume-view src="head.nii.gz"><volume-layer src="motor.nii.gz"></volume-layer></volume-view>`
 *
 * @tag volume-layer
 * @fires {CustomEvent<null>} layer-change - the layer or its appearance has changed; it bubbles
 * @fires {CustomEvent<ErrorDetail>} error - something failed; the last good layer stays
 */
export class VolumeLayer extends AttachmentElement<OverlayTarget> {
  /** The file: NIfTI, NRRD, MetaImage and others, or a mosaic's manifest. */
  @property() src!: string | null;

  /** Colour and opacity by data value, as on `<volume-view>`. The default depends on the values: two colours if they have both signs. */
  @property({ attribute: 'transfer-function' })
  get transferFunction(): string | null {
    return this.readText('transfer-function');
  }

  set transferFunction(value: string | readonly Stop[] | null) {
    this.writeText('transfer-function', writeSafely(transferFunction.write, value));
  }

  /** The range of data values, `low high`, that presets and percentages refer to. */
  @property({ attribute: 'value-window', kind: pairOrText }) valueWindow!:
    | readonly [low: number, high: number]
    | string
    | null;

  /**
   * `mix`: both volumes are visible at a place, like two fogs. `color`: the shapes of the first volume in the colours of this one; the
   * larger its opacity, the stronger its colour.
   * @default mix
   */
  @property() blend!: string | null;

  /**
   * Multiplies its opacity.
   * @default 1
   */
  @property({ attribute: 'opacity-factor', kind: number }) opacityFactor!: number | null;

  /** Its name next to values, `t value` for instance; by default the title of its file. */
  @property() label!: string | null;

  protected override readonly controller = new OverlayController({
    wanted: () => ({
      src: this.src,
      label: this.label,
      hidden: this.hasAttribute('hidden'),
      transferFunction: this.readText('transfer-function'),
      valueWindow: this.readText('value-window'),
      blend: this.readText('blend'),
      opacityFactor: this.readText('opacity-factor'),
    }),
    target: () => this.target,
    changed: () => this.#announce(this),
    failed: (error) => this.reportError(error),
  });

  constructor() {
    super();
    new MutationObserver(() => this.controller.refresh()).observe(this, {
      attributes: true,
      attributeFilter: ['hidden'],
    });
  }

  /** The loaded layer: dimensions, unit, value range ...; null before it is loaded. */
  get volume(): VolumeInfo | null {
    const { volume } = this.controller;
    return volume && describeVolume(volume);
  }

  /** Its appearance; null before it is loaded. */
  get look(): LayerLook | null {
    return this.controller.look;
  }

  protected override refuse(around: HTMLElement | null): VolumeViewError | null {
    return around?.localName === 'volume-view' && childrenOf(around, 'volume-layer')[0] === this
      ? null
      : noPlace(around);
  }

  protected override join(view: HTMLElement): OverlayTarget {
    return new OverlayTarget(socketOf(view));
  }

  /** The events of this element no longer reach the companions of the view that it has left, so the event is fired on the view. */
  protected override left(view: HTMLElement): void {
    this.#announce(view);
  }

  #announce(at: HTMLElement): void {
    at.dispatchEvent(new CustomEvent('layer-change', { detail: null, bubbles: true }));
  }
}

declare global {
  interface HTMLElementTagNameMap {
    'volume-layer': VolumeLayer;
  }
}
