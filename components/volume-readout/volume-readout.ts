import { html, nothing } from 'lit';
import type { PropertyValues } from 'lit';
import type { VolumePick } from '../../src/viewer/model/volume-pick.ts';
import { socketOf } from '../../src/viewer/model/view-socket.ts';
import { ReadoutWords } from '../../src/messages/readout-words.ts';
import { property, ReflectingElement } from '../internal/reflecting-element.ts';
import { ReadoutPointer } from './volume-readout-pointer.ts';
import { listRows } from '../internal/volume-readout-rows.ts';
import type { Row } from '../internal/volume-readout-rows.ts';
import { styles } from './volume-readout-styles.ts';
import { companionGap, withViewWidth } from '../internal/view-width.ts';
import { VolumeLink } from '../internal/volume-link.ts';

/** A screen reader is told what stands there for so long, ms. */
const restMs = 500;

/** CSS pixels that a key moves the crosshair, and with Shift. */
const [keyStep, shiftStep] = [4, 40];

const arrows: Readonly<Record<string, readonly [x: number, y: number]>> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

/**
 * What is at the place of the picture that somebody points at: the value with its unit, and where it is. The place follows the
 * mouse; a click or a tap keeps it. With the crosshair, keys move it. Clicks and the crosshair's Enter fire `volume-pick` at the view.
 *
 * Without `for` it speaks of the nearest `<volume-view>`: the one around it, else the first in the smallest element that
 * holds both.
 *
 * @tag volume-readout
 * @csspart readout - all of it
 * @csspart row - a name and what belongs to it
 * @csspart name - what it is: value, place, voxel ...
 * @csspart text - how much
 * @csspart swatch - a dot in the colour that the value has in the picture
 * @csspart button - the button that shows the crosshair
 * @csspart keys - what takes the keys while there is a crosshair
 * @csspart hint - what is said beside the button, and where there is no volume
 * @cssproperty --volume-view-focus-color - colour of the ring around what has the focus; by default that of the text
 * @cssproperty --volume-view-marker-color - of the `<volume-view>`: colour of the cross at the place, which is the view's part `marker`; the name of a label beside it is `marker-name`
 */
export class VolumeReadout extends ReflectingElement {
  static override readonly styles = [companionGap, styles];

  /** The id of the `<volume-view>`; by default the nearest one. */
  @property({ attribute: 'for' }) htmlFor!: string | null;

  /**
   * How places are written: `patient` with the letters of the patient's sides, in mm, or `xyz`; by default what suits the
   * file. A radar's are written as the radar sees them.
   */
  @property() coordinates!: string | null;

  readonly #link = withViewWidth(new VolumeLink(this, () => this.#follow(), ['load', 'optics-change', 'labels-change', 'layer-change']));
  readonly #words = new ReadoutWords(this);
  #pointer: ReadoutPointer | null = null;
  #pick: VolumePick | null = null;
  #points = false;
  /** What a screen reader is told, and when. */
  #told = '';
  #timer = 0;

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    clearTimeout(this.#timer);
  }

  protected override willUpdate(changed: PropertyValues<this>): void {
    if (changed.has('htmlFor') && this.hasUpdated) this.#link.find();
  }

  /** Another view, or none, or another volume in it. */
  #follow(): void {
    const { view } = this.#link;
    const picture = view?.shadowRoot?.querySelector('.picture');
    if (this.#pointer && this.#pointer.view !== view) {
      this.#pointer.dispose();
      this.#pointer = null;
      this.#show(null, false);
    }
    if (view && picture && view.volume) this.#pointer ??= new ReadoutPointer(view, picture, (pick, points) => this.#show(pick, points));
    this.requestUpdate();
  }

  #show(pick: VolumePick | null, points: boolean): void {
    this.#pick = pick;
    this.#points = points;
    clearTimeout(this.#timer);
    this.#timer = window.setTimeout(() => {
      this.#told = this.#points ? (this.#pick ? this.#rows.map(({ name, text }) => `${name} ${text}`).join(', ') : this.#words.terms.nothingThere) : '';
      this.requestUpdate();
    }, restMs);
    this.requestUpdate();
  }

  get #rows(): Row[] {
    const { language, terms } = this.#words;
    const volume = this.#link.view?.volume;
    const socket = this.#link.view && socketOf(this.#link.view);
    return volume ? listRows(this.#pick, volume, { language, terms, coordinates: this.coordinates, hasLabels: Boolean(socket?.last('labels')?.shown), layer: socket?.last('overlay')?.name }) : [];
  }

  protected override render(): unknown {
    const { terms } = this.#words;
    if (!this.#pointer || !this.#link.view?.volume) return html`<p class="hint" part="hint"><span dir="auto">${this.#link.describeLack(terms)}</span></p>`;
    const { hasCrosshair } = this.#pointer;
    return html`<div class="readout" part="readout" role="group" aria-label=${terms.readout}>
      <dl>${this.#renderRows()}</dl>
      <div class="tools">
        <button type="button" part="button" aria-pressed=${hasCrosshair ? 'true' : 'false'} @click=${this.#toggle}>${terms.crosshair}</button>
        ${hasCrosshair
          ? html`<div class="keys" part="keys" role="application" tabindex="0" aria-label=${`${terms.crosshair}. ${terms.crosshairKeys}`} @keydown=${this.#onKey}>${terms.crosshairKeys}</div>`
          : html`<p class="hint" part="hint"><span dir="auto">${this.#points && !this.#pick ? terms.nothingThere : terms.pointHint}</span></p>`}
      </div>
      <div class="spoken" role="status">${this.#told}</div>
    </div>`;
  }

  /** The colour is the value's. */
  #renderRows(): unknown {
    const rows = this.#rows;
    const colored = Math.max(0, rows.findIndex(({ name }) => name === this.#words.terms.value));
    return rows.map((row, i) => renderRow(row, i === colored ? (this.#pick?.color ?? '') : null));
  }

  readonly #toggle = async (): Promise<void> => {
    const pointer = this.#pointer!;
    pointer.setCrosshair(!pointer.hasCrosshair);
    this.requestUpdate();
    await this.updateComplete;
    this.renderRoot.querySelector<HTMLElement>('.keys')?.focus();
  };

  readonly #onKey = (event: KeyboardEvent): void => {
    const { key, shiftKey, ctrlKey, metaKey, altKey } = event;
    if (ctrlKey || metaKey || altKey) return;
    if (Object.hasOwn(arrows, key)) {
      const step = shiftKey ? shiftStep : keyStep;
      this.#pointer?.moveCrosshair([arrows[key][0] * step, arrows[key][1] * step]);
    } else if (key === 'Enter') this.#pointer?.clickCrosshair();
    else if (key === 'Escape') this.#end();
    else return;
    event.preventDefault();
    event.stopPropagation();
  };

  #end(): void {
    this.#pointer?.setCrosshair(false);
    this.requestUpdate();
    this.renderRoot.querySelector('button')?.focus();
  }
}

/** @param color - of the value, '' where nothing is pointed at; null for rows that have none */
function renderRow({ name, text }: Row, color: string | null): unknown {
  return html`<div class="row" part="row"><dt part="name"><span dir="auto">${name}</span></dt><dd part="text">${color === null ? nothing : html`<span class="swatch" part="swatch" ?hidden=${color === ''} .style=${`background: ${color}`}></span>`}<bdi>${text}</bdi></dd></div>`;
}

declare global {
  interface HTMLElementTagNameMap {
    'volume-readout': VolumeReadout;
  }
}
