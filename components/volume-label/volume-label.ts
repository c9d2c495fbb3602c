import { reportIfLost } from '../internal/lost-element.ts';
import { number } from '../internal/property-kinds.ts';
import { property, ReflectingElement } from '../internal/reflecting-element.ts';

/**
 * The name and appearance of one label in a `<volume-labels>`. It overrides the table there; values that it leaves out come from the table.
 * With `hidden` the label is not shown at first.
 *
 * `<volume-label value="17" name="Left hippocampus" color="#ff8800"></volume-label>`
 *
 * @tag volume-label
 * @fires {CustomEvent<ErrorDetail>} error - there is no `<volume-labels>` around it
 */
export class VolumeLabel extends ReflectingElement {
  /**
   * The id of the label in the file, a whole number. 0 stands for voxels without a label: with a low opacity for 0, the rest of the volume
   * becomes like glass.
   */
  @property({ kind: number }) value!: number | null;

  /** Its name. */
  @property() name!: string | null;

  /** A CSS colour. */
  @property() color!: string | null;

  /**
   * Factor of the opacity that the volume has in this label, 0 to 1.
   * @default 1
   */
  @property({ kind: number }) opacity!: number | null;

  /**
   * Transfer function for the values in this label: the name of a preset, or stops, as on the `<volume-view>`; by default that of the whole
   * volume. In 3D the label then has the colours of this function. Labels with the same function are a group; there may be four groups.
   */
  @property({ attribute: 'transfer-function' }) transferFunction!: string | null;

  override connectedCallback(): void {
    super.connectedCallback();
    reportIfLost(this, 'volume-labels');
  }

  /** The `<volume-view>` draws it. The element itself shows nothing. */
  protected override createRenderRoot(): HTMLElement {
    return this;
  }
}

declare global {
  interface HTMLElementTagNameMap {
    'volume-label': VolumeLabel;
  }
}
