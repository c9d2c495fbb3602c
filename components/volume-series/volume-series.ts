import { css, html, nothing } from 'lit';
import type { PropertyValues } from 'lit';
import { english as companions } from '../../src/messages/english-companions.ts';
import { english } from '../../src/messages/english-drop.ts';
import { LocaleController } from '../../src/messages/locale-controller.ts';
import { property, ReflectingElement } from '../internal/reflecting-element.ts';
import { renderSeriesChoice } from '../internal/series-choice.ts';
import { seriesChoiceStyles } from '../internal/series-choice-styles.ts';
import { companionGap, withViewWidth } from '../internal/view-width.ts';
import { VolumeLink } from '../internal/volume-link.ts';

/**
 * The volumes of a folder, an archive or chosen files: the series of DICOM with a small picture of each, and other files. A choice shows another one. It writes the attribute `series` of the
 * view. Where the files hold one volume there is nothing to choose, and it shows nothing.
 *
 * Without `for` it belongs to the nearest `<volume-view>`: the one around it, else the first one in the smallest element that
 * contains both.
 *
 * @tag volume-series
 * @csspart list - the whole list
 * @csspart row - a series
 * @csspart picture - the small picture of a series, its middle slice
 * @csspart hint - the text where there is no volume
 * @cssproperty --volume-series-height - maximum height of the list, which scrolls then; 20rem by default
 * @cssproperty --volume-series-accent - colour of the choice
 * @cssproperty --volume-view-focus-color - colour of the ring around the element with the focus; by default that of the text
 */
export class VolumeSeries extends ReflectingElement {
  static override readonly styles = [
    companionGap,
    seriesChoiceStyles,
    css`
      :host {
        display: block;
        font: inherit;
      }

      :host([hidden]) {
        display: none;
      }

      .hint {
        margin: 0;
        font-size: 0.9em;
        unicode-bidi: plaintext;
      }
    `,
  ];

  /** The id of the `<volume-view>`; by default the nearest one. */
  @property({ attribute: 'for' }) htmlFor!: string | null;

  readonly #link = withViewWidth(new VolumeLink(this, () => this.requestUpdate()));
  readonly #locale = new LocaleController(this, { ...companions, ...english });

  protected override willUpdate(changed: PropertyValues<this>): void {
    if (changed.has('htmlFor') && this.hasUpdated) this.#link.find();
  }

  protected override render(): unknown {
    const { messages } = this.#locale;
    const lack = this.#link.describeLack(messages);
    if (lack !== null) return html`<p class="hint" part="hint"><span dir="auto">${lack}</span></p>`;
    const { view } = this.#link;
    return view ? renderSeriesChoice(view, messages, (...value) => this.#locale.number(...value)) : nothing;
  }
}

declare global {
  interface HTMLElementTagNameMap {
    'volume-series': VolumeSeries;
  }
}
