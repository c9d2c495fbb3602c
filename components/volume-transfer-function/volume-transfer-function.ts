import { html } from 'lit';
import type { PropertyValues } from 'lit';
import { query, state } from 'lit/decorators.js';
import { invalidAttribute, VolumeViewError } from '../../src/core/errors.ts';
import { writeTransferFunction } from '../../src/optics/transfer/write-transfer-function.ts';
import { dragStep } from '../../src/editor/transfer-function-axes.ts';
import { bandsFromStops, chooseBandEdges } from '../../src/editor/transfer-function-bands.ts';
import { TransferFunctionEditor } from '../../src/editor/transfer-function-editor.ts';
import type { Language } from '../../src/messages/language.ts';
import type { CompanionMessages } from '../../src/messages/messages.ts';
import { CompanionLocale } from '../../src/messages/companion-locale.ts';
import { number, numbers } from '../internal/property-kinds.ts';
import { property, ReflectingElement } from '../internal/reflecting-element.ts';
import { renderChart, renderHandles, renderOpacityScale, renderPicture } from './transfer-function-chart.ts';
import type { Chart } from './transfer-function-chart.ts';
import {
  renderBands,
  renderCopyText,
  renderFactor,
  renderStopFields,
  renderToolbar,
} from './transfer-function-panels.ts';
import type { Plane } from './transfer-function-plane.ts';
import { styles } from './transfer-function-styles.ts';
import { companionGap, withViewWidth } from '../internal/view-width.ts';
import { VolumeLink } from '../internal/volume-link.ts';

/** Detail of `input` and `change`: the values that have been written to the volume. */
export interface TransferFunctionDetail {
  /** The text of the attribute `transfer-function`. */
  readonly transferFunction: string;
  /** The text of the attribute `transfer-function-2d`; null where there is none. */
  readonly transferFunction2d: string | null;
  /** Multiplies the extinction. */
  readonly opacityFactor: number;
  /** Multiplies the light. */
  readonly lightFactor: number;
}

/**
 * An editor of a volume's transfer function: its histogram, the curve with a handle for every stop, and the two factors;
 * or, with `mode="bands"`, one colour and one opacity for each range of values; or, with `mode="2d"`, boxes and Gaussians over a histogram of
 * values and gradients. The volume shows each edit at once.
 *
 * Without `for` it edits the nearest `<volume-view>`: the one around it, else the first one in the smallest element that
 * contains both.
 *
 * @tag volume-transfer-function
 * @csspart chart - histogram and curve
 * @csspart handle - a stop in the chart
 * @csspart strip - the colours below the chart
 * @csspart fields - value, opacity and colour of the chosen stop
 * @csspart bands - the bands
 * @csspart factors - opacity and light
 * @csspart toolbar - the buttons
 * @csspart hint - the text where there is no volume
 * @csspart error - the text where an attribute cannot be read
 * @cssproperty --volume-view-focus-color - colour of the ring around the element with the focus
 * @cssproperty --volume-view-error-background - background of the text where an attribute cannot be read
 * @cssproperty --volume-view-error-color - colour of the text where an attribute cannot be read
 * @cssproperty --volume-accent - colour of sliders and of the chosen stop
 * @cssproperty --volume-chart-height - height of the chart; 12rem by default
 * @cssproperty --volume-chart-background - background of the chart; dark by default, as behind a volume
 * @fires {CustomEvent<TransferFunctionDetail>} input - an edit goes on, and the volume has followed; at most once per frame
 * @fires {CustomEvent<TransferFunctionDetail>} change - an edit is finished: it can be undone now
 */
export class VolumeTransferFunction extends ReflectingElement {
  static override readonly styles = [companionGap, styles];

  /** The id of the `<volume-view>`; by default the nearest one. */
  @property({ attribute: 'for' }) htmlFor!: string | null;

  /**
   * `stops` (by default), `bands`, or `2d`: by value and gradient.
   * @default stops
   */
  @property() mode!: string | null;

  /**
   * Number of bands of equal width; 15 by default. They divide the window, or, where the unit is dBZ, the range from -5 to 70.
   * @default 15
   */
  @property({ kind: number }) bands!: number | null;

  /** Values at the edges of the bands, ascending, instead of bands of equal width. */
  @property({ attribute: 'band-edges', kind: numbers }) bandEdges!: readonly number[] | null;

  @state() private _chosen = 0;
  /** The result of copying, and the text where a person has to copy it. */
  @state() private _copy: { said: keyof CompanionMessages & ('copied' | 'copyRefused'); byHand: string | null } | null =
    null;

  /** The chart of values and gradients, or the error that prevented it. */
  @state() private _plane: Plane | VolumeViewError | null = null;

  @query('.plot') private readonly _plot!: HTMLElement | null;

  readonly #locale = new CompanionLocale(this);
  readonly #editor = new TransferFunctionEditor({
    changed: () => this.requestUpdate(),
    wrote: (type) => this.#onWritten(type),
    choose: (index, when) => void this.#choose(index, when),
  });
  #isPlaneAsked = false;
  readonly #link = withViewWidth(new VolumeLink(this, () => this.#editor.follow(this.#link.view)));

  protected override willUpdate(changed: PropertyValues<this>): void {
    if (changed.has('htmlFor') && this.hasUpdated) this.#link.find();
  }

  protected override updated(): void {
    this.#openPlane()?.paint(this.renderRoot);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#openPlane()?.stop();
  }

  protected override render(): unknown {
    const { language } = this.#locale;
    const { messages } = language;
    const { look: appearance } = this.#editor.session;
    const volume = this.#link.view?.volume;
    if (!appearance || !volume) return html`<p class="hint" part="hint">${this.#link.describeLack(messages)}</p>`;
    const chart = {
      histogram: volume.histogram,
      domain: this.#editor.domain,
      stops: appearance.stops,
      unit: volume.unit,
      language,
    };
    return html`<div class="editor" @input=${stop} @change=${stop} @focusin=${this.#onPlaneFocus} @keydown=${this.#onKeyDown} @keyup=${this.#onKeyUp}>
      ${this.#attemptMode(chart)}
      <div class="factors" part="factors">
        ${this.#renderFactor('opacityFactor', messages.opacity, language)}
        ${this.#renderFactor('lightFactor', messages.light, language)}
      </div>
      <div class="foot">${this.#renderToolbar(messages)}<span class="said" role="status">${this._copy ? messages[this._copy.said] : ''}</span></div>
      ${renderCopyText(this._copy?.byHand ?? null, messages)}
      <div id="keys" class="spoken">${messages.stopKeys}</div>
    </div>`;
  }

  /** The part that depends on the mode; or an error text where an attribute can't be read. */
  #attemptMode(chart: Chart): unknown {
    try {
      const mode = this.mode?.trim().toLowerCase() ?? 'stops';
      if (mode === 'bands') return this.#renderBands(chart);
      if (mode === 'stops') return this.#renderStops(chart);
      if (mode === '2d') return this.#renderPlane(chart);
      throw invalidAttribute('mode', this.mode!, 'stops, bands, or 2d');
    } catch (error) {
      if (!(error instanceof VolumeViewError)) throw error;
      return html`<p class="problem" part="error" role="alert">${error.message}</p>`;
    }
  }

  #renderStops(chart: Chart): unknown {
    const {
      stops,
      unit,
      language: { messages },
    } = chart;
    const editor = this.#editor;
    const index = Math.min(this._chosen, stops.length - 1);
    return html`
      ${renderChart(
        chart,
        html`<div class="plot editable" role="group" aria-label=${messages.transferFunction}
        @pointerdown=${editor.input.down} @pointermove=${editor.input.move} @pointerup=${editor.input.up} @pointercancel=${editor.input.up}
        @mousedown=${editor.input.keepFocus} @focusin=${this.#onFocus}>
        ${renderPicture(chart)}${renderOpacityScale(chart)}
        <div class="handles">${renderHandles(chart, index)}</div>
      </div>`,
      )}
      ${renderStopFields(
        { stop: stops[index], unit, step: dragStep(chart.domain), removable: stops.length > 1, messages },
        {
          change: (change) => editor.changeStop(index, change),
          done: () => editor.session.commit(),
          add: () => editor.addAttached(index),
          remove: () => editor.remove(index),
        },
      )}
    `;
  }

  #renderBands(chart: Chart): unknown {
    const { unit, language } = chart;
    const { window } = this.#link.view!.optics!;
    const bands = bandsFromStops(
      chart.stops,
      chooseBandEdges({ bands: this.readText('bands'), bandEdges: this.readText('band-edges') }, { unit, window }),
    );
    return html`
      ${renderChart(chart, html`<div class="plot">${renderPicture(chart)}${renderOpacityScale(chart)}</div>`)}
      ${renderBands(
        { bands, unit, language },
        {
          change: (index, change) => this.#editor.changeBand(bands, index, change),
          done: () => this.#editor.session.commit(),
        },
      )}
    `;
  }

  #renderPlane({ domain, unit, language }: Chart): unknown {
    if (this._plane instanceof VolumeViewError) throw this._plane;
    const { volume } = this.#link;
    if (this._plane && volume) return this._plane.render({ volume, domain, unit, language });
    if (!this.#isPlaneAsked) void this.#loadPlane();
    return html`<div class="plot plane"></div>`;
  }

  async #loadPlane(): Promise<void> {
    this.#isPlaneAsked = true;
    try {
      const { Plane } = await import('./transfer-function-plane.ts');
      this._plane = new Plane(this, this.#editor.session);
    } catch (cause) {
      this._plane = new VolumeViewError(
        'format/unsupported',
        'the part of volume-view that edits by gradients could not be loaded; check that all files of the package are on the server',
        { cause },
      );
    }
  }

  /** The chart of values and gradients, where it is shown. */
  #openPlane(): Plane | null {
    return this._plane instanceof VolumeViewError ? null : this._plane;
  }

  #renderFactor(name: 'opacityFactor' | 'lightFactor', label: string, language: Language): unknown {
    const { session } = this.#editor;
    const factor = session.look![name];
    return renderFactor(
      { name, label, factor, language },
      (changed) => this.#editor.setFactor(name, changed),
      () => session.commit(),
    );
  }

  #renderToolbar(messages: CompanionMessages): unknown {
    const { session } = this.#editor;
    const { canUndo, canRedo, canReset } = session;
    return renderToolbar(
      {
        canUndo,
        canRedo,
        canReset,
        undo: () => session.undo(),
        redo: () => session.redo(),
        reset: () => session.reset(),
        copy: () => void this.#copy(),
      },
      messages,
    );
  }

  async #choose(index: number, when: 'now' | 'updated'): Promise<void> {
    if (when === 'updated') await this.updateComplete;
    this._chosen = index;
    this._plot?.querySelectorAll<HTMLElement>('.handle')[index]?.focus({ preventScroll: true });
  }

  /** The edit has been written to the volume. */
  #onWritten(type: 'input' | 'change'): void {
    if (type === 'change') this._copy = null;
    this.requestUpdate();
    const { stops, opacityFactor, lightFactor, attributes } = this.#editor.session.look!;
    const transferFunction = attributes.transferFunction ?? writeTransferFunction(stops);
    const detail: TransferFunctionDetail = {
      transferFunction,
      transferFunction2d: attributes.transferFunction2d ?? null,
      opacityFactor,
      lightFactor,
    };
    const event = new CustomEvent(type, { detail });
    this.dispatchEvent(event);
  }

  readonly #onFocus = ({ target }: FocusEvent): void => {
    this._chosen = stopOf(target) ?? this._chosen;
  };

  readonly #onPlaneFocus = ({ target }: FocusEvent): void => void this.#openPlane()?.follow(target);

  readonly #onKeyDown = (event: KeyboardEvent): void => {
    const { target } = event;
    const typing =
      target instanceof HTMLTextAreaElement || (target instanceof HTMLInputElement && target.type === 'number');
    if (!typing && (this.#editor.press(event, stopOf(target)) || this.#openPlane()?.press(event)))
      event.preventDefault();
  };

  /** All the repeats of a held key are one edit. */
  readonly #onKeyUp = ({ target }: KeyboardEvent): void => {
    if (stopOf(target) !== null || this.#openPlane()?.follow(target)) this.#editor.session.commit();
  };

  async #copy(): Promise<void> {
    const text = this.#editor.session.writeAttributes();
    try {
      await navigator.clipboard.writeText(text);
      this._copy = { said: 'copied', byHand: null };
    } catch {
      this._copy = { said: 'copyRefused', byHand: text };
      await this.updateComplete;
      this.renderRoot.querySelector('textarea')?.focus();
    }
  }
}

/** Index of the stop to which a handle belongs; null for any other element. */
function stopOf(target: EventTarget | null): number | null {
  const { index } = (target as HTMLElement).dataset;
  return index === undefined ? null : Number(index);
}

/** Events of the inner inputs must not leave the element, as it has events of the same names. */
function stop(event: Event): void {
  event.stopPropagation();
}

declare global {
  interface HTMLElementTagNameMap {
    'volume-transfer-function': VolumeTransferFunction;
  }
}
