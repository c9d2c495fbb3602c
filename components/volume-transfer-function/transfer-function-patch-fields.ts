// The fields of the chosen box or Gaussian.
import { html, nothing } from 'lit';
import { live } from 'lit/directives/live.js';
import type { Patch } from '../../src/optics/transfer/patches.ts';
import { roundedNumbersOf } from '../../src/optics/transfer/write-patches.ts';
import { writeColor } from '../../src/optics/transfer/write-transfer-function.ts';
import type { Language } from '../../src/messages/language.ts';
import type { PlaneMessages } from '../../src/messages/plane-messages.ts';

/** Events of the fields: also while a colour is being picked; `done` when a field is left. */
export interface PatchFieldsListener {
  /** @param which - index of the number, as in `numbersOf` */
  number(which: number, number: number): void;
  look(appearance: { readonly color?: string; readonly opacity?: number }): void;
  done(): void;
  add(kind: Patch['kind']): void;
  remove(): void;
}

interface PatchFields {
  /** Undefined where nothing is chosen. */
  readonly patch: Patch | undefined;
  readonly hasRoom: boolean;
  readonly messages: PlaneMessages;
  readonly language: Language;
}

export function renderPatchFields(
  { patch, hasRoom, messages, language }: PatchFields,
  listener: PatchFieldsListener,
): unknown {
  return html`<div class="fields" part="fields">
    ${patch ? renderNumbers(patch, messages, listener) : nothing}
    ${patch ? renderAppearance(patch, messages, language, listener) : nothing}
    <div class="buttons">
      <button type="button" ?disabled=${!hasRoom} @click=${() => listener.add('box')}>${messages.addBox}</button>
      <button type="button" ?disabled=${!hasRoom} @click=${() => listener.add('gaussian')}>${messages.addGaussian}</button>
      <button type="button" title=${messages.removePatchTip} ?disabled=${!patch} @click=${() => listener.remove()}>${language.messages.remove}</button>
    </div>
  </div>`;
}

function renderNumbers(patch: Patch, messages: PlaneMessages, { number, done }: PatchFieldsListener): unknown {
  const names =
    patch.kind === 'box'
      ? [messages.valueFrom, messages.valueTo, messages.gradientFrom, messages.gradientTo]
      : [messages.middleValue, messages.middleGradient, messages.valueWidth, messages.gradientWidth];
  return roundedNumbersOf(patch).map((x, i) =>
    renderNumber(names[i], x, (entered) => {
      number(i, entered);
      done();
    }),
  );
}

/**
 * A field for a number. If the text is no number, or not allowed, the field shows the current number again. Not live(): the text that a
 * person is typing has to stay.
 */
function renderNumber(label: string, shown: number, enter: (number: number) => void): unknown {
  const text = String(shown);
  const onChange = ({ target }: Event): void => {
    const input = target as HTMLInputElement;
    const number = input.valueAsNumber;
    input.value = text;
    if (Number.isFinite(number)) enter(number);
  };
  return html`<label>${label} <input type="number" step="any" .style=${`--digits: ${text.length}`} .value=${text} @change=${onChange} /></label>`;
}

function renderAppearance(
  patch: Patch,
  messages: PlaneMessages,
  { messages: common }: Language,
  { look: appearance, done }: PatchFieldsListener,
): unknown {
  return html`${renderNumber(common.opacityPercent, Number((patch.opacity * 100).toPrecision(4)), (percent) => {
    appearance({ opacity: percent / 100 });
    done();
  })}
  <label class="color">${common.color} <input type="color" aria-label=${messages.colorOfPatch} .value=${live(writeColor(patch.color))}
    @input=${({ target }: Event) => appearance({ color: (target as HTMLInputElement).value })} @change=${done} /></label>`;
}
