import { html, LitElement } from 'lit';
import type { PropertyValues } from 'lit';
import { customElement, property, query, state } from 'lit/decorators.js';
import { VolumeViewError } from '../src/errors.ts';
import { parseCssColor } from '../src/optics/css-color.ts';
import type { Stop, TransferFunction } from '../src/optics/transfer-function.ts';
import { writeTransferFunction } from '../src/optics/write-transfer-function.ts';
import { invalid } from '../src/viewer/parse-attributes.ts';
import { moveByKey, StopInput } from '../src/editor/stop-input.ts';
import { chooseDomain, dragStep, toHeight, toOpacity, toShare, toValue } from '../src/editor/transfer-function-axes.ts';
import { bandsFromStops, chooseBandEdges, stopsFromBands } from '../src/editor/transfer-function-bands.ts';
import type { Band } from '../src/editor/transfer-function-bands.ts';
import { renderChart, renderHandles, renderOpacityScale, renderPicture } from './transfer-function-chart.ts';
import type { Chart } from './transfer-function-chart.ts';
import { addStop, addStopBeside, changeStop, removeStop } from '../src/editor/transfer-function-edits.ts';
import { renderBands, renderCopyText, renderFactor, renderStopFields, renderToolbar } from './transfer-function-panels.ts';
import { EditSession } from '../src/editor/transfer-function-session.ts';
import { styles } from './transfer-function-styles.ts';
import { VolumeLink } from './volume-link.ts';

/** Detail of `input` and `change`: what has been written to the volume. */
export interface TransferFunctionDetail {
  /** The text of the attribute `transfer-function`. */
  readonly transferFunction: string;
  /** Multiplies the extinction. */
  readonly opacityFactor: number;
  /** Multiplies the light. */
  readonly lightFactor: number;
}

/**
 * An editor of a volume's transfer function: its histogram, the curve with a handle for every stop, and the two factors;
 * or, with `mode="bands"`, one colour and one opacity for each range of values. What is edited is seen in the volume at
 * once.
 *
 * Without `for` it edits the nearest `<volume-view>`: the one around it, else the first in the smallest element that
 * holds both.
 *
 * @tag volume-transfer-function
 * @csspart chart - histogram and curve
 * @csspart handle - a stop in the chart
 * @csspart strip - the colours below the chart
 * @csspart fields - value, opacity and colour of the chosen stop
 * @csspart bands - the bands
 * @csspart factors - opacity and light
 * @csspart toolbar - the buttons
 * @csspart hint - what is said where there is no volume
 * @cssproperty --volume-accent - colour of sliders and of the chosen stop
 * @cssproperty --volume-chart-height - height of the chart; 12rem by default
 * @cssproperty --volume-chart-background - what is behind the chart; dark by default, as behind a volume
 * @fires {CustomEvent<TransferFunctionDetail>} input - an edit goes on, and the volume has followed; once a frame at most
 * @fires {CustomEvent<TransferFunctionDetail>} change - an edit is done: it can be undone now
 */
@customElement('volume-transfer-function')
export class VolumeTransferFunction extends LitElement {
  static override readonly styles = styles;

  /** The id of the `<volume-view>`; by default the nearest one. */
  @property({ attribute: 'for' }) htmlFor: string | null = null;

  /** `stops` (by default), or `bands`. */
  @property() mode: string | null = null;

  /** Number of bands of equal width; 15 by default. They divide the window; where the unit is dBZ, -5 to 70. */
  @property() bands: string | null = null;

  /** Values at which bands begin and end, ascending, instead of bands of equal width. */
  @property({ attribute: 'band-edges' }) bandEdges: string | null = null;

  @state() private _chosen = 0;
  @state() private _said = '';
  @state() private _byHand: string | null = null;

  @query('.plot') private readonly _plot!: HTMLElement | null;

  readonly #link = new VolumeLink(this, () => this.#follow());
  readonly #session = new EditSession((type) => this.#onWritten(type));
  /** What the chart spans; kept while a stop is dragged, or the chart would run away under the hand. */
  #domain: [number, number] = [0, 1];
  readonly #input = new StopInput({
    handles: () => this.#stops().map(({ value, opacity }) => ({ share: toShare(value, this.#domain), height: toHeight(opacity) })),
    choose: (index) => this.#choose(index),
    drag: (index, share, height) => this.#changeStop(index, { value: toValue(share, this.#domain), opacity: toOpacity(height) }),
    drop: () => this.#commit(),
    add: (share, height) => this.#put(addStop(this.#stops(), toValue(share, this.#domain), toOpacity(height))),
  });

  protected override willUpdate(changed: PropertyValues<this>): void {
    if (changed.has('htmlFor') && this.hasUpdated) this.#link.find();
  }

  protected override render(): unknown {
    const { look } = this.#session;
    const volume = this.#link.view?.volume;
    if (!look || !volume) return html`<p class="hint" part="hint">${this.#link.hint}</p>`;
    const chart = { histogram: volume.histogram, domain: this.#domain, stops: look.stops, unit: volume.unit };
    const commit = (): void => this.#commit();
    return html`<div class="editor" @input=${stop} @change=${stop} @keydown=${this.#onKeyDown} @keyup=${this.#onKeyUp}>
      ${this.#attemptMode(chart)}
      <div class="factors" part="factors">
        ${renderFactor({ name: 'opacityFactor', label: 'Opacity', factor: look.opacityFactor }, (factor) => this.#setFactor('opacityFactor', factor), commit)}
        ${renderFactor({ name: 'lightFactor', label: 'Light', factor: look.lightFactor }, (factor) => this.#setFactor('lightFactor', factor), commit)}
      </div>
      <div class="foot">${this.#renderToolbar()}<span class="said" role="status">${this._said}</span></div>
      ${renderCopyText(this._byHand)}
      <div id="keys" class="hidden">Arrow keys move it, with Shift ten times as far. Insert adds a stop, Delete removes this one.</div>
    </div>`;
  }

  /** The part that differs with the mode; where an attribute can't be read, the words that say so. */
  #attemptMode(chart: Chart): unknown {
    try {
      const mode = this.mode?.trim().toLowerCase() ?? 'stops';
      if (mode === 'bands') return this.#renderBands(chart);
      if (mode === 'stops') return this.#renderStops(chart);
      throw invalid('mode', this.mode!, 'stops, or bands');
    } catch (error) {
      if (!(error instanceof VolumeViewError)) throw error;
      return html`<p class="problem" role="alert">${error.message}</p>`;
    }
  }

  #renderStops(chart: Chart): unknown {
    const { stops, unit } = chart;
    const index = Math.min(this._chosen, stops.length - 1);
    return html`
      ${renderChart(chart, html`<div class="plot editable" role="group" aria-label="Transfer function"
        @pointerdown=${this.#input.down} @pointermove=${this.#input.move} @pointerup=${this.#input.up} @pointercancel=${this.#input.up}
        @mousedown=${this.#input.keepFocus} @focusin=${this.#onFocus}>
        ${renderPicture(chart)}${renderOpacityScale()}
        <div class="handles">${renderHandles(chart, index)}</div>
      </div>`)}
      ${renderStopFields({ stop: stops[index], unit, step: dragStep(chart.domain), removable: stops.length > 1 }, {
        change: ({ color, ...rest }) => this.#changeStop(index, color === undefined ? rest : { color: parseCssColor(color)!.color }),
        done: () => {
          this.#commit();
          this.requestUpdate(); // A field may hold what is no number.
        },
        add: () => this.#put(addStopBeside(this.#stops(), index, this.#domain)),
        remove: () => this.#remove(index),
      })}
    `;
  }

  #renderBands(chart: Chart): unknown {
    const window = this.#link.view!.optics!.window;
    const bands = bandsFromStops(chart.stops, chooseBandEdges(this, { unit: chart.unit, window }));
    return html`
      ${renderChart(chart, html`<div class="plot">${renderPicture(chart)}${renderOpacityScale()}</div>`)}
      ${renderBands(bands, chart.unit, {
        change: (index, { color, height }) => this.#changeBand(bands, index, {
          ...(color === undefined ? {} : { color: parseCssColor(color)!.color }),
          ...(height === undefined ? {} : { opacity: toOpacity(height) }),
        }),
        done: () => this.#commit(),
      })}
    `;
  }

  #renderToolbar(): unknown {
    const session = this.#session;
    const { canUndo, canRedo, canReset } = session;
    return renderToolbar({
      canUndo,
      canRedo,
      canReset,
      undo: () => session.undo(),
      redo: () => session.redo(),
      reset: () => session.reset(),
      copy: () => void this.#copy(),
    });
  }

  #stops(): TransferFunction {
    return this.#session.look?.stops ?? [];
  }

  /** The volume has told something, or there is another one. */
  #follow(): void {
    this.#session.follow(this.#link.view);
    this.#readDomain();
    this.requestUpdate();
  }

  #readDomain(): void {
    const { view } = this.#link;
    const { look } = this.#session;
    if (view?.volume && view.optics && look) this.#domain = chooseDomain(view.volume, { ...view.optics, transferFunction: look.stops });
  }

  #choose(index: number): void {
    this._chosen = index;
    this._plot?.querySelectorAll<HTMLElement>('.handle')[index]?.focus({ preventScroll: true });
  }

  #changeStop(index: number, change: Partial<Stop>): void {
    this.#setStops(changeStop(this.#stops(), index, change));
  }

  #changeBand(bands: readonly Band[], index: number, change: Partial<Band>): void {
    this.#setStops(stopsFromBands(bands.map((band, i) => (i === index ? { ...band, ...change } : band))));
  }

  #setStops(stops: TransferFunction): void {
    this.#session.setStops(stops);
    this.requestUpdate();
  }

  #setFactor(name: 'opacityFactor' | 'lightFactor', factor: number): void {
    this.#session.setFactor(name, factor);
    this.requestUpdate();
  }

  #put({ stops, index }: { stops: TransferFunction; index: number }): void {
    this.#setStops(stops);
    this.#commit();
    void this.updateComplete.then(() => this.#choose(index));
  }

  #remove(index: number): void {
    const stops = removeStop(this.#stops(), index);
    this.#setStops(stops);
    this.#commit();
    void this.updateComplete.then(() => this.#choose(Math.min(index, stops.length - 1)));
  }

  #commit(): void {
    this.#session.commit();
  }

  /** The volume has been given what was edited. */
  #onWritten(type: 'input' | 'change'): void {
    if (type === 'change') {
      this.#readDomain();
      this._said = '';
      this._byHand = null;
    }
    this.requestUpdate();
    const { stops, opacityFactor, lightFactor, attributes } = this.#session.look!;
    const transferFunction = attributes.transferFunction ?? writeTransferFunction(stops);
    const detail: TransferFunctionDetail = { transferFunction, opacityFactor, lightFactor };
    const event = new CustomEvent(type, { detail });
    this.dispatchEvent(event);
  }

  readonly #onFocus = (event: FocusEvent): void => {
    const { index } = (event.target as HTMLElement).dataset;
    if (index !== undefined) this._chosen = Number(index);
  };

  readonly #onKeyDown = (event: KeyboardEvent): void => {
    const target = event.target as HTMLElement;
    const typing = target instanceof HTMLTextAreaElement || (target instanceof HTMLInputElement && target.type === 'number');
    const handled = (!typing && this.#undoByKey(event)) || (target.dataset.index !== undefined && this.#editByKey(event));
    if (handled) event.preventDefault();
  };

  #undoByKey({ key, ctrlKey, metaKey, shiftKey }: KeyboardEvent): boolean {
    if (!(ctrlKey || metaKey)) return false;
    const letter = key.toLowerCase();
    if (letter === 'y' || (letter === 'z' && shiftKey)) this.#session.redo();
    else if (letter === 'z') this.#session.undo();
    else return false;
    return true;
  }

  #editByKey(event: KeyboardEvent): boolean {
    if (event.ctrlKey || event.metaKey || event.altKey) return false;
    const index = Number((event.target as HTMLElement).dataset.index);
    const move = moveByKey(event, this.#stops()[index], this.#domain);
    if (move) this.#changeStop(index, move);
    else if (event.key === 'Delete' || event.key === 'Backspace') this.#remove(index);
    else if (event.key === 'Insert' || event.key === '+') this.#put(addStopBeside(this.#stops(), index, this.#domain));
    else return false;
    return true;
  }

  /** A key that was held is one edit. */
  readonly #onKeyUp = (event: KeyboardEvent): void => {
    if ((event.target as HTMLElement).dataset.index !== undefined) this.#commit();
  };

  async #copy(): Promise<void> {
    const text = this.#session.writeAttributes();
    try {
      await navigator.clipboard.writeText(text);
      this._byHand = null;
      this._said = 'Copied';
    } catch {
      this._said = 'The browser did not let it copy.';
      this._byHand = text;
      await this.updateComplete;
      this.renderRoot.querySelector('textarea')?.focus();
    }
  }
}

/** Inner inputs' own events stay inside: the element has events of the same names. */
function stop(event: Event): void {
  event.stopPropagation();
}

declare global {
  interface HTMLElementTagNameMap {
    'volume-transfer-function': VolumeTransferFunction;
  }
}
