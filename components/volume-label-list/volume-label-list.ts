import { html, nothing } from 'lit';
import type { PropertyValues } from 'lit';
import { state } from 'lit/decorators.js';
import { live } from 'lit/directives/live.js';
import { repeat } from 'lit/directives/repeat.js';
import { english as companions } from '../../src/messages/english-companions.ts';
import { english } from '../../src/messages/english-labels.ts';
import type { LabelMessages } from '../../src/messages/label-messages.ts';
import { Language } from '../../src/messages/language.ts';
import { LocaleController } from '../../src/messages/locale-controller.ts';
import { socketOf } from '../../src/viewer/model/view-socket.ts';
import { property, ReflectingElement } from '../internal/reflecting-element.ts';
import { styles } from './volume-label-list-styles.ts';
import type { VolumeLabelInfo, VolumeLabels } from '../volume-labels/volume-labels.ts';
import { companionGap, withViewWidth } from '../internal/view-width.ts';
import { VolumeLink } from '../internal/volume-link.ts';

/** Maximum number of folded names that are kept: an atlas has at most 65,536 labels. */
const maxFolded = 2 ** 17;

/** Maximum number of rows: with more labels, people use the search. */
const maxRows = 2000;

/**
 * The labels of a volume, with their colours and names: a box to show or hide each label, a button that shows it alone, and a field that
 * finds a label by name. The `<volume-labels>` element keeps the choice; attributes do not change.
 *
 * Without `for` it belongs to the nearest `<volume-view>`: the one around it, else the first one in the smallest element that
 * contains both.
 *
 * @tag volume-label-list
 * @csspart list - the whole list
 * @csspart search - the field that finds labels
 * @csspart button - each button
 * @csspart row - a label
 * @csspart swatch - the colour of a label
 * @csspart name - the name of a label
 * @csspart count - how many labels are shown
 * @csspart hint - the text where there are no labels
 * @cssproperty --volume-label-list-height - maximum height of the rows, which scroll then; 20rem by default
 * @cssproperty --volume-label-list-accent - colour of the boxes
 * @cssproperty --volume-view-focus-color - colour of the ring around the element with the focus; by default that of the text
 */
export class VolumeLabelList extends ReflectingElement {
  static override readonly styles = [companionGap, styles];

  /** The id of the `<volume-view>`; by default the nearest one. */
  @property({ attribute: 'for' }) htmlFor!: string | null;

  @state() private _search = '';

  readonly #link = withViewWidth(
    new VolumeLink(this, () => this.requestUpdate(), ['load', 'optics-change', 'labels-change']),
  );
  readonly #locale = new LocaleController(this, { ...companions, ...english });

  protected override willUpdate(changed: PropertyValues<this>): void {
    if (changed.has('htmlFor') && this.hasUpdated) this.#link.find();
  }

  get #labels(): VolumeLabels | null {
    return this.#link.view?.querySelector('volume-labels') ?? null;
  }

  protected override render(): unknown {
    const { messages } = this.#locale;
    const { view } = this.#link;
    const all = this.#labels?.labels ?? [];
    if (!view?.optics)
      return html`<p class="hint" part="hint"><span dir="auto">${this.#link.describeLack(messages)}</span></p>`;
    if (all.length === 0)
      return html`<p class="hint" part="hint"><span dir="auto">${this.#describeNone(messages)}</span></p>`;
    const found = all.filter(finder(this._search, messages.otherParts));
    return html`<div class="list" part="list" role="group" aria-label=${messages.labelList}>
      <div class="tools">
        <input type="search" part="search" aria-label=${messages.findLabel} placeholder=${messages.findLabel} .value=${live(this._search)} @input=${this.#onSearch} />
        <button type="button" part="button" ?disabled=${all.every(({ hidden }) => !hidden)} @click=${() => this.#labels?.showAll()}>${messages.allLabels}</button>
      </div>
      ${
        found.length > 0
          ? html`<ul>${repeat(
              found.slice(0, maxRows),
              ({ id }) => id,
              (label) => this.#renderRow(label),
            )}</ul>`
          : nothing
      }
      ${found.length > maxRows ? html`<p class="hint" part="hint"><span dir="auto">${messages.moreLabels(this.#number(found.length - maxRows))}</span></p>` : nothing}
      <p class="count" part="count" role="status"><span dir="auto">${found.length > 0 ? this.#count(all) : messages.noSuchLabel}</span></p>
    </div>`;
  }

  /** Why there is nothing to list. */
  #describeNone({ noLabels, labelsHidden, labelsComing }: LabelMessages): string {
    if (!this.#labels) return noLabels;
    return this.#labels.hidden ? labelsHidden : labelsComing;
  }

  #renderRow({ id, name, color, hidden }: VolumeLabelInfo): unknown {
    const { onlyThis, onlyLabel, otherParts } = this.#locale.messages;
    const called = name || otherParts;
    return html`<li part="row">
      <label>
        <input type="checkbox" .checked=${live(!hidden)} @change=${(event: Event) => this.#show(id, (event.target as HTMLInputElement).checked)} />
        ${id === 0 ? nothing : html`<span class="swatch" part="swatch" .style=${`background: ${color}`}></span>`}
        <bdi part="name">${called}</bdi>
      </label>
      <button type="button" class="only" part="button" aria-label=${onlyLabel(called)} @click=${() => this.#labels?.showOnly([id], 'ghost')}>${onlyThis}</button>
    </li>`;
  }

  #show(id: number, isShown: boolean): void {
    const { view } = this.#link;
    if (view)
      socketOf(view)
        .parts.find(({ element }) => element === this.#labels)
        ?.showLabel?.(id, isShown);
  }

  #count(all: readonly VolumeLabelInfo[]): string {
    const things = all.filter(({ id }) => id !== 0);
    return this.#locale.messages.labelsShown(
      this.#number(things.filter(({ hidden }) => !hidden).length),
      this.#number(things.length),
    );
  }

  #number(count: number): string {
    return new Language(this.#locale.lang(), this.#locale.messages).number(count, 6);
  }

  readonly #onSearch = ({ target }: Event): void => {
    this._search = (target as HTMLInputElement).value;
  };
}

/** Whether a label matches a search: all words are in its name, ignoring case and accents; or the search is its number. */
function finder(search: string, otherParts: string): (label: VolumeLabelInfo) => boolean {
  const words = fold(search)
    .split(/[\s_-]+/)
    .filter(Boolean);
  if (words.length === 0) return () => true;
  return ({ id, name }) => {
    const text = foldName(name || otherParts);
    return words.every((word) => text.includes(word) || String(id) === word);
  };
}

/** Names that have been folded: each key in the search field compares the same ones again. */
const folded = new Map<string, string>();

function foldName(name: string): string {
  const text = folded.get(name) ?? fold(name);
  if (folded.size > maxFolded) folded.clear();
  folded.set(name, text);
  return text;
}

function fold(text: string): string {
  return text.normalize('NFD').replace(/\p{M}/gu, '').toLowerCase();
}

declare global {
  interface HTMLElementTagNameMap {
    'volume-label-list': VolumeLabelList;
  }
}
