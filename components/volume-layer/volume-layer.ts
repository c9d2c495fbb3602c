import type { VolumeViewError } from '../../src/core/errors.ts';
import type { Stop } from '../../src/optics/transfer/transfer-function.ts';
import { OverlayKeeper } from '../../src/viewer/attachments/overlay-keeper.ts';
import { childrenOf } from '../../src/page/page-children.ts';
import { noPlace, OverlayTarget } from '../../src/viewer/attachments/overlay-target.ts';
import { socketOf } from '../../src/viewer/model/view-socket.ts';
import { describeVolume } from '../../src/viewer/model/volume-info.ts';
import type { VolumeInfo } from '../../src/viewer/model/volume-info.ts';
import { BesideElement } from '../internal/beside-element.ts';
import { number, pair, transferFunction } from '../internal/property-kinds.ts';
import { property, writeSafely } from '../internal/reflecting-element.ts';

/** What a layer looks like: its stops, and the data values that presets and percentages span. */
export interface LayerLook {
  readonly transferFunction: readonly Stop[];
  readonly window: readonly [number, number];
}

/**
 * A second volume over the first one: a map of statistics on a brain, a PET on a CT. It lies where its file says, on a grid of its own; what of it
 * is outside of the first volume's box is not shown. One for each `<volume-view>`.
 *
 * With `hidden` the volume is shown without it.
 *
 * `<volume-view src="head.nii.gz"><volume-layer src="motor.nii.gz"></volume-layer></volume-view>`
 *
 * @tag volume-layer
 * @fires {CustomEvent<null>} layer-change - there is another layer, or it looks otherwise; it bubbles
 * @fires {CustomEvent<ErrorDetail>} error - something failed; the last good layer stays
 */
export class VolumeLayer extends BesideElement<OverlayTarget> {
  /** The file: NIfTI, NRRD, MetaImage, or a mosaic's manifest. */
  @property() src!: string | null;

  /** Colour and opacity by data value, as of `<volume-view>`. By default what the values suggest: two colours for values of both signs. */
  @property({ attribute: 'transfer-function' })
  get transferFunction(): string | null {
    return this.readText('transfer-function');
  }

  set transferFunction(value: string | readonly Stop[] | null) {
    this.writeText('transfer-function', writeSafely(transferFunction.write, value));
  }

  /** Data values that presets and percentages span, `low high`. */
  @property({ attribute: 'value-window', kind: pair }) valueWindow!: readonly [number, number] | null;

  /**
   * `mix`: both are seen in one place, as two fogs are. `color`: the first volume's shapes in this one's colours; the larger its opacity, the more.
   * @default mix
   */
  @property() blend!: string | null;

  /**
   * Multiplies how much of it there is.
   * @default 1
   */
  @property({ attribute: 'opacity-factor', kind: number }) opacityFactor!: number | null;

  /** What it is called where values are told, `t value` for instance; by default the title of its file. */
  @property() label!: string | null;

  protected override readonly keeper = new OverlayKeeper({
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
    failed: (error) => this.tellError(error),
  });

  constructor() {
    super();
    new MutationObserver(() => this.keeper.refresh()).observe(this, { attributes: true, attributeFilter: ['hidden'] });
  }

  /** The loaded layer: dimensions, unit, value range ...; null before it is there. */
  get volume(): VolumeInfo | null {
    const { volume } = this.keeper;
    return volume && describeVolume(volume);
  }

  /** What it looks like; null before it is there. */
  get look(): LayerLook | null {
    return this.keeper.look;
  }

  protected override refuse(around: HTMLElement | null): VolumeViewError | null {
    return around?.localName === 'volume-view' && childrenOf(around, 'volume-layer')[0] === this ? null : noPlace(around);
  }

  protected override join(view: HTMLElement): OverlayTarget {
    return new OverlayTarget(socketOf(view));
  }

  /** The companions of a view that it leaves hear it no longer from here. */
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
