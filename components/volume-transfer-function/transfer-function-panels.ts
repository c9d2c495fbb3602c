// The parts around the editor's chart: fields of a stop, bands, factors, buttons.
import { html, nothing } from 'lit';
import { live } from 'lit/directives/live.js';
import type { Stop } from '../../src/optics/transfer/transfer-function.ts';
import { writeColor } from '../../src/optics/transfer/write-transfer-function.ts';
import { roundTo } from '../../src/editor/ticks.ts';
import { toHeight } from '../../src/editor/transfer-function-axes.ts';
import type { Band } from '../../src/editor/transfer-function-bands.ts';
import type { Language } from '../../src/messages/language.ts';
import type { CompanionMessages } from '../../src/messages/messages.ts';

/** Step of a range input from 0 to 1: finer than a person can drag. */
const fineStep = 0.001;

const valueOf = (event: Event): string => (event.target as HTMLInputElement).value;

/** Events of the fields of a stop: `change` also while a colour is being picked, `done` when a field is left. */
export interface StopFieldsListener {
  change(change: { value?: number; opacity?: number; color?: string }): void;
  done(): void;
  add(): void;
  remove(): void;
}

/**
 * Fields for the exact value, opacity and colour of the chosen stop.
 * @param step - values are rounded to this step while a stop is dragged; the field shows one more digit
 */
export function renderStopFields(
  {
    stop,
    unit,
    step,
    removable,
    messages,
  }: { stop: Stop; unit: string; step: number; removable: boolean; messages: CompanionMessages },
  listener: StopFieldsListener,
): unknown {
  // Not live(): the volume may respond to an earlier edit while a person types, and the typed text has to stay.
  const field = (name: 'value' | 'opacity', shown: string, scale: number): unknown => {
    const enter = ({ target }: Event): void => {
      const input = target as HTMLInputElement;
      const number = input.valueAsNumber;
      input.value = shown; // If the text is no number, or the stop can't go there, the field shows the current value again.
      if (Number.isFinite(number)) listener.change({ [name]: number * scale });
      listener.done();
    };
    const [min, max] = name === 'opacity' ? [0, 100] : [nothing, nothing];
    return html`<input type="number" step="any" min=${min} max=${max} .style=${`--digits: ${shown.length}`} .value=${shown} @change=${enter} />`;
  };
  return html`<div class="fields" part="fields">
    <label>${messages.valueIn(unit)} ${field('value', String(roundTo(stop.value, step / 10)), 1)}</label>
    <label>${messages.opacityPercent} ${field('opacity', String(Number((stop.opacity * 100).toPrecision(4))), 0.01)}</label>
    <label class="color">${messages.color} ${renderColor(
      writeColor(stop.color),
      messages.colorOfStop,
      (color) => listener.change({ color }),
      () => listener.done(),
    )}</label>
    <div class="buttons">
      <button type="button" title=${messages.addTip} @click=${() => listener.add()}>${messages.add}</button>
      <button type="button" title=${messages.removeTip} ?disabled=${!removable} @click=${() => listener.remove()}>${messages.remove}</button>
    </div>
  </div>`;
}

function renderColor(color: string, label: string, change: (color: string) => void, done: () => void): unknown {
  return html`<input type="color" aria-label=${label} .value=${live(color)} @input=${(event: Event) => change(valueOf(event))} @change=${done} />`;
}

/** Events of the bands. */
export interface BandsListener {
  /** @param change - height: 0..1 of a slider, as in the chart */
  change(index: number, change: { color?: string; height?: number }): void;
  done(): void;
}

/** A colour and a slider for every band, from the lowest one. */
export function renderBands(
  { bands, unit, language }: { bands: readonly Band[]; unit: string; language: Language },
  listener: BandsListener,
): unknown {
  const { messages } = language;
  return html`<ul class="bands" part="bands">
    ${bands.map(({ low, high, color, opacity }, i) => {
      const range = language.range(low, high, unit);
      return html`<li>
        ${renderColor(
          writeColor(color),
          messages.colorOfBand(range),
          (color) => listener.change(i, { color }),
          () => listener.done(),
        )}
        <span class="range" aria-hidden="true"><bdi dir="ltr">${language.number(low)} – ${language.number(high)}</bdi></span>
        <input type="range" min="0" max="1" step=${fineStep} aria-label=${messages.opacityOfBand(range)} aria-valuetext=${language.opacity(opacity)}
          .value=${live(String(toHeight(opacity)))}
          @input=${(event: Event) => listener.change(i, { height: Number(valueOf(event)) })} @change=${() => listener.done()} />
        <span class="told" aria-hidden="true"><bdi dir="ltr">${language.opacity(opacity)}</bdi></span>
      </li>`;
    })}
  </ul>`;
}

/** The range of a factor's slider to either side of 1, in powers of two. */
const reachOf = { opacityFactor: 4, lightFactor: 2 } as const;

/** A slider for one factor; 1 is in its middle. */
export function renderFactor(
  { name, label, factor, language }: { name: keyof typeof reachOf; label: string; factor: number; language: Language },
  change: (factor: number) => void,
  done: () => void,
): unknown {
  const reach = reachOf[name];
  const words = `× ${language.number(factor, 3)}`;
  return html`<label class="factor">${label}
    <input type="range" min=${-reach} max=${reach} step="0.05" aria-valuetext=${words}
      .value=${live(String(factor > 0 ? Math.log2(factor) : -reach))}
      @input=${(event: Event) => change(Number((2 ** Number(valueOf(event))).toPrecision(3)))} @change=${done} />
    <span class="told" aria-hidden="true"><bdi dir="ltr">${words}</bdi></span>
  </label>`;
}

/** The state of the buttons, and their events. */
export interface ToolbarState {
  readonly canUndo: boolean;
  readonly canRedo: boolean;
  readonly canReset: boolean;
  undo(): void;
  redo(): void;
  reset(): void;
  copy(): void;
}

export function renderToolbar(state: ToolbarState, messages: CompanionMessages): unknown {
  return html`<div class="buttons" part="toolbar">
    <button type="button" title=${messages.undoTip} ?disabled=${!state.canUndo} @click=${() => state.undo()}>${messages.undo}</button>
    <button type="button" title=${messages.redoTip} ?disabled=${!state.canRedo} @click=${() => state.redo()}>${messages.redo}</button>
    <button type="button" title=${messages.resetTip} ?disabled=${!state.canReset} @click=${() => state.reset()}>${messages.reset}</button>
    <button type="button" title=${messages.copyTip} @click=${() => state.copy()}>${messages.copy}</button>
  </div>`;
}

/** The text for copying by hand, where the page may not write to the clipboard. */
export function renderCopyText(text: string | null, messages: CompanionMessages): unknown {
  return text === null
    ? nothing
    : html`<label class="by-hand">${messages.copyByHand}
    <textarea readonly rows="3" .value=${text} @focus=${(event: Event) => (event.target as HTMLTextAreaElement).select()}></textarea>
  </label>`;
}
