import { number, pair } from './property-kinds.ts';
import { property, ReflectingElement } from './reflecting-element.ts';

/**
 * A cut through the radar volume of the `<volume-view>` around it, in the colours of its transfer function: values are
 * interpolated between gates, and exact at them. It hides what is behind it. Where there are no data, and where the
 * transfer function shows nothing of them, it is not there. A volume has at most four that are not hidden.
 *
 * `<volume-slice type="cappi" height="3000"></volume-slice>`
 *
 * @tag volume-slice
 */
export class VolumeSlice extends ReflectingElement {
  /**
   * `ppi`: the cone of one sweep; `cappi`: all that is at one height; `rhi`: what stands above an azimuth, from the radar
   * outward; `section`: what stands above the line between two points.
   */
  @property() type!: string | null;

  /** Of a `ppi`: degrees; the sweep nearest to it is shown. By default the lowest one. */
  @property({ kind: number }) elevation!: number | null;

  /** Of a `ppi`, instead of `elevation`: number of the sweep, the lowest one being 0. */
  @property({ kind: number }) sweep!: number | null;

  /** Of a `cappi`: metres above sea level where the file says how high the radar stands, else above its antenna. */
  @property({ kind: number }) height!: number | null;

  /** Of an `rhi`: degrees clockwise from north. */
  @property({ kind: number }) azimuth!: number | null;

  /** Of a `section`: where it begins, metres east and north of the radar, `x y`. */
  @property({ kind: pair }) from!: readonly [east: number, north: number] | null;

  /** Of a `section`: where it ends, metres east and north of the radar, `x y`. */
  @property({ kind: pair }) to!: readonly [east: number, north: number] | null;

  /** It is drawn by the `<volume-view>`, and has nothing to show of its own. */
  protected override createRenderRoot(): HTMLElement {
    return this;
  }
}

declare global {
  interface HTMLElementTagNameMap {
    'volume-slice': VolumeSlice;
  }
}
