// Fields of the panels.
import { html, nothing } from 'lit';
import { live } from 'lit/directives/live.js';

interface TextField {
  readonly id: string;
  readonly label: string;
  readonly value: string;
  readonly onInput: (text: string) => void;
  readonly hint?: string;
  /** Lines; one line if absent. */
  readonly rows?: number;
  readonly isNeeded?: boolean;
}

/** A label and a field for a text. */
export function textField({ id, label, value, onInput, hint, rows, isNeeded }: TextField): unknown {
  const take = ({ target }: Event): void => onInput((target as HTMLInputElement).value);
  const described = hint ? `${id}-hint` : nothing;
  return html`<div class="field">
    <label for=${id}>${label}</label>
    ${
      rows
        ? html`<textarea id=${id} rows=${rows} aria-describedby=${described} .value=${live(value)} @input=${take}></textarea>`
        : html`<input id=${id} type="text" autocomplete="off" aria-describedby=${described} ?required=${isNeeded} .value=${live(value)} @input=${take} />`
    }
    ${hint ? html`<p class="hint" id=${`${id}-hint`}>${hint}</p>` : nothing}
  </div>`;
}

interface Slider {
  readonly id: string;
  readonly label: string;
  readonly value: number;
  readonly min: number;
  readonly max: number;
  readonly step: number;
  /** The value in words. */
  readonly said: string;
  readonly onInput: (value: number) => void;
}

/** A label, a slider, and its value. */
export function slider({ id, label, value, min, max, step, said, onInput }: Slider): unknown {
  return html`<div class="field slider">
    <label for=${id}>${label}</label>
    <input id=${id} type="range" min=${min} max=${max} step=${step} aria-valuetext=${said} .value=${live(String(value))} @input=${({ target }: Event) => onInput(Number((target as HTMLInputElement).value))} />
    <output for=${id}>${said}</output>
  </div>`;
}

interface Choice<T extends string> {
  readonly id: string;
  readonly label: string;
  readonly value: T;
  readonly options: Readonly<Record<T, string>>;
  readonly onChange: (value: T) => void;
}

/** A label and a list to choose one from. */
export function choice<T extends string>({ id, label, value, options, onChange }: Choice<T>): unknown {
  const entries = Object.entries(options) as [T, string][];
  return html`<div class="field">
    <label for=${id}>${label}</label>
    <select id=${id} .value=${live(value)} @change=${({ target }: Event) => onChange((target as HTMLSelectElement).value as T)}>
      ${entries.map(([name, text]) => html`<option value=${name} ?selected=${name === value}>${text}</option>`)}
    </select>
  </div>`;
}

/** A number for people: as many digits as it needs. */
export const shortNumber = (value: number): string => String(Number(value.toPrecision(4)));
