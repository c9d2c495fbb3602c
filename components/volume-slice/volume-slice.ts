import type { Vector3 } from '../../src/volume/matrix.ts';
import { tellIfLost } from '../internal/lost-element.ts';
import { number, pair, vector } from '../internal/property-kinds.ts';
import { property, ReflectingElement } from '../internal/reflecting-element.ts';

/**
 * A slice in the picture of the `<volume-view>` around it. It hides what is behind it. A volume has at most four that are not hidden.
 *
 * Of a radar scan it is a cut in the colours of its transfer function: values are interpolated between gates, and exact at them.
 * Where there are no data, and where the transfer function shows nothing of them, it is not there. Of any other volume it is
 * a plane, in grey as in radiology.
 *
 * `<volume-slice type="cappi" height="3000"></volume-slice>`, `<volume-slice type="axial" at="20"></volume-slice>`
 *
 * @tag volume-slice
 * @fires {CustomEvent<ErrorDetail>} error - there is no `<volume-view>` around it
 */
export class VolumeSlice extends ReflectingElement {
  /**
   * `ppi`: the cone of one sweep; `cappi`: all that is at one height; `rhi`: what stands above an azimuth, from the radar
   * outward; `section`: what stands above the line between two points. Of volumes that are not a radar's: `axial`, `coronal`,
   * `sagittal`, or `oblique`.
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

  /** Of a plane: its place in world units (mm) along the axis that it cuts. By default the middle of the volume. */
  @property({ kind: number }) at!: number | null;

  /** Of an `oblique` plane: the direction that it is at right angles to, `x y z`. */
  @property({ kind: vector }) normal!: Vector3 | null;

  /**
   * Of a plane: how thick it is, in world units (mm). It shows what of the values in it `projection` says.
   * @default 0
   */
  @property({ kind: number }) thickness!: number | null;

  /**
   * Of a thick plane: `average`, `max` or `min`.
   * @default average
   */
  @property() projection!: string | null;

  /** Of a plane: data values of black and white, `low high`. By default that of the `<volume-view>`, soft tissue of a CT, or what suits the values. */
  @property({ attribute: 'value-window', kind: pair }) valueWindow!: readonly [number, number] | null;

  /**
   * Of a plane: `linear-exact`, or `linear`, DICOM's two ways to read a window.
   * @default linear-exact
   */
  @property({ attribute: 'window-function' }) windowFunction!: string | null;

  /** Of a plane: `gray`, or `volume` for the colours of the transfer function. By default those only of labels and of maps of both signs. */
  @property() colors!: string | null;

  override connectedCallback(): void {
    super.connectedCallback();
    tellIfLost(this, 'volume-view');
  }

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
