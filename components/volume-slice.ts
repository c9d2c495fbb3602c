import { LitElement } from 'lit';
import { property } from 'lit/decorators.js';

/**
 * A cut through the radar volume of the `<volume-view>` around it, in the colours of its transfer function: values are
 * interpolated between gates, and exact at them. It hides what is behind it. Where there are no data, and where the
 * transfer function shows nothing of them, it is not there. A volume has at most four that are not hidden.
 *
 * `<volume-slice type="cappi" height="3000"></volume-slice>`
 *
 * @tag volume-slice
 */
export class VolumeSlice extends LitElement {
  /**
   * `ppi`: the cone of one sweep; `cappi`: all that is at one height; `rhi`: what stands above an azimuth, from the radar
   * outward; `section`: what stands above the line between two points.
   */
  @property({ reflect: true }) type: string | null = null;

  /** Of a `ppi`: degrees; the sweep nearest to it is shown. By default the lowest one. */
  @property({ reflect: true }) elevation: string | null = null;

  /** Of a `ppi`, instead of `elevation`: number of the sweep, the lowest one being 0. */
  @property({ reflect: true }) sweep: string | null = null;

  /** Of a `cappi`: metres above sea level where the file says how high the radar stands, else above its antenna. */
  @property({ reflect: true }) height: string | null = null;

  /** Of an `rhi`: degrees clockwise from north. */
  @property({ reflect: true }) azimuth: string | null = null;

  /** Of a `section`: where it begins, metres east and north of the radar, `x y`. */
  @property({ reflect: true }) from: string | null = null;

  /** Of a `section`: where it ends, metres east and north of the radar, `x y`. */
  @property({ reflect: true }) to: string | null = null;

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
