import { tellIfLost } from '../internal/lost-element.ts';
import { number } from '../internal/property-kinds.ts';
import { property, ReflectingElement } from '../internal/reflecting-element.ts';

/**
 * What one label is called and looks like, in a `<volume-labels>`. It says more than the table there; what it leaves out is the table's.
 * With `hidden` it is not shown at first.
 *
 * `<volume-label value="17" name="Left hippocampus" color="#ff8800"></volume-label>`
 *
 * @tag volume-label
 * @fires {CustomEvent<ErrorDetail>} error - there is no `<volume-labels>` around it
 */
export class VolumeLabel extends ReflectingElement {
  /** The label's id in the file, a whole number. 0 is what has no label: with a low opacity the rest of the volume becomes glass. */
  @property({ kind: number }) value!: number | null;

  /** What it is called. */
  @property() name!: string | null;

  /** A CSS colour. */
  @property() color!: string | null;

  /**
   * How much is left of the opacity that the volume has there, 0 to 1.
   * @default 1
   */
  @property({ kind: number }) opacity!: number | null;

  /**
   * What its values look like: a preset's name, or stops, as of the `<volume-view>`; by default as all of the volume. In 3D it then has the
   * colours of this function. Labels that say the same are a group; there may be four groups.
   */
  @property({ attribute: 'transfer-function' }) transferFunction!: string | null;

  override connectedCallback(): void {
    super.connectedCallback();
    tellIfLost(this, 'volume-labels');
  }

  /** It is drawn by the `<volume-view>`, and has nothing to show of its own. */
  protected override createRenderRoot(): HTMLElement {
    return this;
  }
}

declare global {
  interface HTMLElementTagNameMap {
    'volume-label': VolumeLabel;
  }
}
