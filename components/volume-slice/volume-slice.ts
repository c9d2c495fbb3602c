import type { Vector3 } from '../../src/volume/matrix.ts';
import { reportIfLost } from '../internal/lost-element.ts';
import { number, pair, pairOrText, vector } from '../internal/property-kinds.ts';
import { property, ReflectingElement } from '../internal/reflecting-element.ts';

/**
 * A slice in the picture of the `<volume-view>` around it. It hides the volume behind it. A volume has at most four visible slices.
 *
 * Of a radar scan it is a cut in the colours of the transfer function: values are interpolated between gates, and exact at the gates.
 * It leaves open the places without data, and those where the transfer function is transparent. Of any other volume it is
 * a plane, in grey as in radiology.
 *
 * `<volume-slice type="cappi" height="3000"></volume-slice>`, `<volume-slice type="axial" at="20"></volume-slice>`
 *
 * @tag volume-slice
 * @fires {CustomEvent<ErrorDetail>} error - there is no `<volume-view>` around it
 */
export class VolumeSlice extends ReflectingElement {
  /**
   * `ppi`: the cone of one sweep; `cappi`: everything at one height; `rhi`: everything above an azimuth, from the radar outward; `section`:
   * everything above the line between two points. For volumes that are not from a radar: `axial`, `coronal`, `sagittal`, or `oblique`.
   */
  @property() type!: string | null;

  /** Of a `ppi`: degrees; the nearest sweep is shown. By default the lowest one. */
  @property({ kind: number }) elevation!: number | null;

  /** Of a `ppi`, instead of `elevation`: number of the sweep, from 0 for the lowest one. */
  @property({ kind: number }) sweep!: number | null;

  /** Of a `cappi`: metres above sea level where the file gives the altitude of the radar, else above its antenna. */
  @property({ kind: number }) height!: number | null;

  /** Of an `rhi`: degrees clockwise from north. */
  @property({ kind: number }) azimuth!: number | null;

  /** Of a `section`: its first end, metres east and north of the radar, `x y`. */
  @property({ kind: pair }) from!: readonly [east: number, north: number] | null;

  /** Of a `section`: its other end, metres east and north of the radar, `x y`. */
  @property({ kind: pair }) to!: readonly [east: number, north: number] | null;

  /** Of a plane: its position in world units (mm) along the axis that it cuts. By default the middle of the volume. */
  @property({ kind: number }) at!: number | null;

  /** Of an `oblique` plane: its normal, `x y z`. */
  @property({ kind: vector }) normal!: Vector3 | null;

  /**
   * Of a plane: its thickness, in world units (mm). `projection` chooses which of the values in it is shown.
   * @default 0
   */
  @property({ kind: number }) thickness!: number | null;

  /**
   * Of a thick plane: `average`, `max` or `min`.
   * @default average
   */
  @property() projection!: string | null;

  /**
   * Of a plane: data values of black and white, `low high`, or the name or the number of a window of a DICOM file, `lung` or `2`. By default those of the `<volume-view>`, the window for soft tissue of a CT, or
   * a window that suits the values.
   */
  @property({ attribute: 'value-window', kind: pairOrText }) valueWindow!:
    | readonly [low: number, high: number]
    | string
    | null;

  /**
   * Of a plane: `linear-exact`, or `linear`, DICOM's two ways to read a window.
   * @default linear-exact
   */
  @property({ attribute: 'window-function' }) windowFunction!: string | null;

  /**
   * Of a plane: `gray`, or `volume` for the colours of the transfer function. The default is `volume` for labels and for maps of both
   * signs, else `gray`.
   */
  @property() colors!: string | null;

  override connectedCallback(): void {
    super.connectedCallback();
    reportIfLost(this, 'volume-view');
  }

  /** The `<volume-view>` draws it. The element itself shows nothing. */
  protected override createRenderRoot(): HTMLElement {
    return this;
  }
}

declare global {
  interface HTMLElementTagNameMap {
    'volume-slice': VolumeSlice;
  }
}
