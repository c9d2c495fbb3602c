import { html, nothing } from 'lit';
import type { PropertyValues } from 'lit';
import type { Curve } from './volume-readout-curve.ts';
import type { VolumePick } from '../../src/viewer/model/volume-pick.ts';
import { socketOf } from '../../src/viewer/model/view-socket.ts';
import { ReadoutLocale } from '../../src/messages/readout-locale.ts';
import { flag } from '../internal/property-kinds.ts';
import { LazyPart } from '../internal/lazy-part.ts';
import { property, ReflectingElement } from '../internal/reflecting-element.ts';
import { ReadoutPointer } from './volume-readout-pointer.ts';
import { listRows } from '../internal/volume-readout-rows.ts';
import type { Row } from '../internal/volume-readout-rows.ts';
import { styles } from './volume-readout-styles.ts';
import { companionGap, withViewWidth } from '../internal/view-width.ts';
import { VolumeLink } from '../internal/volume-link.ts';

/** A screen reader gets the text when it has not changed for this time, ms. */
const restMs = 500;

/** CSS pixels by which a key moves the crosshair, without and with Shift. */
const [keyStep, shiftStep] = [4, 40];

const arrows: Readonly<Record<string, readonly [x: number, y: number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};

/**
 * The values at the place of the picture that a person points at: the value with its unit, and the position. The place follows the
 * mouse; a click or a tap keeps it. With the crosshair, keys move it. Clicks, and Enter on the crosshair, fire `volume-pick` on the view.
 * Where the view has several scans, a button shows the values of the kept place over time as a curve.
 *
 * Without `for` it belongs to the nearest `<volume-view>`: the one around it, else the first one in the smallest element that
 * contains both.
 *
 * @tag volume-readout
 * @csspart readout - the whole readout
 * @csspart row - a name and its text
 * @csspart name - the name: value, place, voxel ...
 * @csspart text - the value as text
 * @csspart swatch - a dot in the colour that the value has in the picture, or of its channel
 * @csspart button - the buttons that show the crosshair and the curve
 * @csspart keys - the element that takes the keys while there is a crosshair
 * @csspart hint - the text next to the buttons, below the curve, and where there is no volume
 * @csspart curve - the box around the curve of values over time, and all that belongs to it
 * @csspart curve-value - the time and the value that are shown, or pointed at
 * @csspart curve-plot - the curve, a slider over the times
 * @csspart curve-line - its line
 * @csspart curve-table - what opens the table of all values
 * @cssproperty --volume-view-focus-color - colour of the ring around the element with the focus; by default that of the text
 * @cssproperty --volume-readout-curve-color - colour of the curve; by default that of the text
 * @cssproperty --volume-view-marker-color - of the `<volume-view>`: colour of the cross at the place, which is the view's part `marker`; the label's name next to it is the part `marker-name`
 */
export class VolumeReadout extends ReflectingElement {
  static override readonly styles = [companionGap, styles];

  /** The id of the `<volume-view>`; by default the nearest one. */
  @property({ attribute: 'for' }) htmlFor!: string | null;

  /**
   * How places are written: `patient` with the letters of the patient's sides, in mm (µm or nm in a small volume), or `xyz`, the numbers that attributes take; the default suits the file. Places in a
   * radar scan are written as the radar measures them.
   */
  @property() coordinates!: string | null;

  /**
   * Whether the values of the kept place at all times are shown as a curve, where the view has several scans. The button "Over time" changes
   * it. Scans that are needed for it are loaded when a place is kept.
   */
  @property({ kind: flag }) curve!: boolean;

  readonly #link = withViewWidth(
    new VolumeLink(this, () => this.#follow(), [
      'load',
      'optics-change',
      'labels-change',
      'layer-change',
      'scans-change',
    ]),
  );
  readonly #locale = new ReadoutLocale(this);
  #pointer: ReadoutPointer | null = null;
  #curve: Curve | null = null;
  readonly #lazyCurve = new LazyPart(this, async () => {
    const { Curve } = await import('./volume-readout-curve.ts');
    return (this.#curve = new Curve(this));
  });
  #pick: VolumePick | null = null;
  #points = false;
  /** The text that a screen reader got last, and the timer for the next one. */
  #spoken = '';
  #timer = 0;

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    clearTimeout(this.#timer);
  }

  protected override willUpdate(changed: PropertyValues<this>): void {
    if (changed.has('htmlFor') && this.hasUpdated) this.#link.find();
    const isWanted = this.curve && this.#hasTimes;
    this.#lazyCurve.follow(isWanted);
    if (!isWanted) this.#curve = null;
    this.#curve?.follow(this.#link.view, this.#pointer?.kept ?? null);
  }

  /** Called when there is another view, or none, or another volume in it. */
  #follow(): void {
    const { view } = this.#link;
    const picture = view?.shadowRoot?.querySelector('.picture');
    if (this.#pointer && this.#pointer.view !== view) {
      this.#pointer.dispose();
      this.#pointer = null;
      this.#show(null, false);
    }
    if (view && picture && view.volume)
      this.#pointer ??= new ReadoutPointer(view, picture, (pick, points) => this.#show(pick, points));
    this.requestUpdate();
  }

  #show(pick: VolumePick | null, points: boolean): void {
    this.#pick = pick;
    this.#points = points;
    clearTimeout(this.#timer);
    this.#timer = window.setTimeout(() => {
      this.#spoken = this.#points
        ? this.#pick
          ? this.#rows.map(({ name, text }) => `${name} ${text}`).join(', ')
          : this.#locale.messages.nothingThere
        : '';
      this.requestUpdate();
    }, restMs);
    this.requestUpdate();
  }

  get #hasTimes(): boolean {
    return (this.#link.view?.times?.length ?? 0) > 1;
  }

  get #rows(): Row[] {
    const { language, messages } = this.#locale;
    const volume = this.#link.view?.volume;
    const socket = this.#link.view && socketOf(this.#link.view);
    return volume
      ? listRows(this.#pick, volume, {
          language,
          messages,
          coordinates: this.coordinates,
          hasLabels: Boolean(socket?.last('labels')?.shown),
          layer: socket?.last('overlay')?.name,
        })
      : [];
  }

  protected override render(): unknown {
    const { messages } = this.#locale;
    if (!this.#pointer || !this.#link.view?.volume)
      return html`<p class="hint" part="hint"><span dir="auto">${this.#link.describeLack(messages)}</span></p>`;
    const { hasCrosshair } = this.#pointer;
    return html`<div class="readout" part="readout" role="group" aria-label=${messages.readout}>
      <dl>${this.#renderRows()}</dl>
      <div class="tools">
        <button type="button" part="button" aria-pressed=${hasCrosshair ? 'true' : 'false'} @click=${this.#toggle}>${messages.crosshair}</button>
        ${this.#hasTimes ? html`<button type="button" part="button" aria-pressed=${this.curve ? 'true' : 'false'} @click=${this.#toggleCurve}>${messages.overTime}</button>` : nothing}
        ${
          hasCrosshair
            ? html`<div class="keys" part="keys" role="application" tabindex="0" aria-label=${`${messages.crosshair}. ${messages.crosshairKeys}`} @keydown=${this.#onKey}>${messages.crosshairKeys}</div>`
            : html`<p class="hint" part="hint"><span dir="auto">${this.#points && !this.#pick ? messages.nothingThere : messages.pointHint}</span></p>`
        }
      </div>
      ${this.#lazyCurve.render()}
      <div class="spoken" role="status">${this.#spoken}</div>
    </div>`;
  }

  /** The swatch has the colour of the value, or of its channel. */
  #renderRows(): unknown {
    const rows = this.#rows;
    if (rows.some(({ color }) => color !== undefined)) return rows.map((row) => renderRow(row, row.color ?? null));
    const colored = Math.max(
      0,
      rows.findIndex(({ name }) => name === this.#locale.messages.value),
    );
    return rows.map((row, i) => renderRow(row, i === colored ? (this.#pick?.color ?? '') : null));
  }

  readonly #toggle = async (): Promise<void> => {
    const pointer = this.#pointer!;
    pointer.setCrosshair(!pointer.hasCrosshair);
    this.requestUpdate();
    await this.updateComplete;
    this.renderRoot.querySelector<HTMLElement>('.keys')?.focus();
  };

  readonly #toggleCurve = (): void => {
    this.curve = !this.curve;
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

/** @param color - of the value, '' where there is no pick; null for rows without a colour */
function renderRow({ name, text }: Row, color: string | null): unknown {
  return html`<div class="row" part="row"><dt part="name"><span dir="auto">${name}</span></dt><dd part="text">${color === null ? nothing : html`<span class="swatch" part="swatch" ?hidden=${color === ''} .style=${`background: ${color}`}></span>`}<bdi>${text}</bdi></dd></div>`;
}

declare global {
  interface HTMLElementTagNameMap {
    'volume-readout': VolumeReadout;
  }
}
