import { html, nothing } from 'lit';
import type { PropertyValues } from 'lit';
import { invalidAttribute, VolumeViewError } from '../../src/core/errors.ts';
import type { CompareMessages } from '../../src/messages/compare-messages.ts';
import { english } from '../../src/messages/english-compare.ts';
import { LocaleController } from '../../src/messages/locale-controller.ts';
import { placeInElement } from '../../src/page/pointer-place.ts';
import { pair } from '../../src/viewer/compare/pair.ts';
import type { PairedView } from '../../src/viewer/compare/pair.ts';
import { parseWord } from '../../src/viewer/model/parse-attributes.ts';
import { blockStyles } from '../internal/block-styles.ts';
import { number } from '../internal/property-kinds.ts';
import { property, ReflectingElement } from '../internal/reflecting-element.ts';
import { emit } from '../internal/volume-view-events.ts';
import { styles } from './volume-compare-styles.ts';

const layouts = ['side', 'slider'] as const;

/** The longest caption, characters. */
const maxCaption = 200;

/** How far a key moves the divider, per cent. */
const step = { arrow: 2, page: 10 };

/**
 * Two views side by side, or one over the other with a divider that shows more of one or of the other: before and after, CT and MRI,
 * two radars. They have one camera, one time and one crosshair.
 *
 * `<volume-compare layout="slider"><volume-view src="before.nii.gz" alt="Before"></volume-view><volume-view src="after.nii.gz" alt="After"></volume-view></volume-compare>`
 *
 * A `caption="Before"` on a view is a short name, shown above its picture or its side.
 *
 * Whichever view is turned, the other one turns too, to the same place of the world. Until then both are where the first view places
 * its camera. Without scripts and on paper both are side by side.
 *
 * @tag volume-compare
 * @slot - the two `<volume-view>`s
 * @csspart divider - the divider of the layout `slider`, which takes the focus
 * @csspart caption - the caption of each view
 * @csspart error - the text where there are not two views, or an attribute can't be read
 * @fires {CustomEvent<ErrorDetail>} error - there are not two views, or an attribute can't be read
 * @cssproperty --volume-compare-gap - space between the views; 8px by default
 * @cssproperty --volume-compare-color - colour of the divider
 * @cssproperty --volume-compare-sign-color - colour of the arrows on it
 * @cssproperty --volume-view-focus-color - colour of the ring around the divider that has the focus
 */
export class VolumeCompare extends ReflectingElement {
  static override readonly styles = [blockStyles, styles];

  /**
   * `side`: side by side, and on a phone one below the other. `slider`: one over the other, with a divider.
   * @default side
   */
  @property() layout!: string | null;

  /**
   * Where the divider is at first, per cent of the width from the first view's side. A change moves the divider.
   * @default 50
   */
  @property({ kind: number }) position!: number | null;

  readonly #locale = new LocaleController<CompareMessages>(this, english);
  readonly #observer = new MutationObserver(() => this.#follow());
  #at = 50;
  #layout: (typeof layouts)[number] = 'side';
  #views: readonly Element[] = [];
  #captions: readonly string[] = [];
  #end: (() => void) | null = null;
  #problem: VolumeViewError | null = null;

  constructor() {
    super();
    // The second view may come after the first one.
    if (document.readyState === 'loading')
      document.addEventListener('DOMContentLoaded', () => this.#follow(), { once: true });
  }

  /** Where the divider is now, per cent of the width: a reader moves it. */
  get currentPosition(): number {
    return this.#at;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.#observe([]);
    this.#follow();
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#observer.disconnect();
    this.#part();
  }

  #part(): void {
    this.#end?.();
    this.#end = null;
    this.#views = [];
  }

  #observe(views: readonly Element[]): void {
    this.#observer.disconnect();
    this.#observer.observe(this, { childList: true });
    for (const view of views) this.#observer.observe(view, { attributeFilter: ['caption'] });
  }

  /** Keep the two views together. */
  #follow(): void {
    if (!this.isConnected) return;
    const views = [...this.children].filter(({ localName }) => localName === 'volume-view');
    this.requestUpdate();
    if (views.length === this.#views.length && views.every((view, i) => view === this.#views[i])) return;
    this.#part();
    this.#views = views;
    this.#observe(views);
    for (const view of views) this.#observer.observe(view, { attributeFilter: ['caption'] });
    if (views.length === 2) this.#end = pair(views[0] as PairedView, views[1] as PairedView);
  }

  protected override willUpdate(changed: PropertyValues<this>): void {
    const captions = this.#views.map((view) => (view.getAttribute('caption') ?? '').trim().slice(0, maxCaption));
    this.#captions = captions.some((caption) => caption !== '') ? captions : [];
    const before = this.#problem?.message;
    this.#problem = null;
    const count = this.#views.length;
    if (count !== 2 && document.readyState !== 'loading')
      this.#problem = new VolumeViewError(
        'attribute/invalid',
        `<volume-compare> got ${count === 0 ? 'no' : count} <volume-view>${count > 1 ? 's' : ''}; expected two of them between its tags, not inside other elements.`,
      );
    try {
      const layout = this.readText('layout');
      this.#layout = layout?.trim() ? parseWord('layout of <volume-compare>', layout, layouts) : 'side';
      const position = this.readText('position');
      const at = position === null ? 50 : number.read(position);
      if (at === null || at < 0 || at > 100)
        throw invalidAttribute('position of <volume-compare>', position!, 'per cent of the width, 0 to 100');
      if (changed.has('position')) this.#at = at;
    } catch (error) {
      this.#problem ??= error as VolumeViewError;
    }
    const { code, message } = this.#problem ?? {};
    if (message && message !== before) emit(this, 'error', { code, message, cause: undefined });
  }

  get #isRtl(): boolean {
    return getComputedStyle(this).direction === 'rtl';
  }

  #move(at: number): void {
    this.#at = Math.min(100, Math.max(0, at));
    this.requestUpdate();
  }

  readonly #onPointer = (event: PointerEvent): void => {
    const divider = event.currentTarget as HTMLElement;
    if (event.type === 'pointerdown') {
      if (event.button !== 0) return;
      event.preventDefault();
      divider.setPointerCapture(event.pointerId);
      divider.focus({ preventScroll: true });
    } else if (divider.hasPointerCapture(event.pointerId)) {
      const stage = divider.parentElement!;
      const share = placeInElement(stage, event)[0] / stage.clientWidth;
      this.#move(100 * (this.#isRtl ? 1 - share : share));
    }
  };

  readonly #onKey = (event: KeyboardEvent): void => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const right = this.#isRtl ? -step.arrow : step.arrow;
    const targets: Readonly<Record<string, number>> = {
      ArrowRight: this.#at + right,
      ArrowLeft: this.#at - right,
      ArrowUp: this.#at + step.arrow,
      ArrowDown: this.#at - step.arrow,
      PageUp: this.#at + step.page,
      PageDown: this.#at - step.page,
      Home: 0,
      End: 100,
    };
    if (!Object.hasOwn(targets, event.key)) return;
    event.preventDefault();
    this.#move(targets[event.key]);
  };

  protected override render(): unknown {
    const isSlider = this.#layout === 'slider' && this.#views.length === 2;
    const clip = this.#isRtl ? `0 ${this.#at}% 0 0` : `0 0 0 ${this.#at}%`;
    const kind = `stage${isSlider ? ' slider' : ''}${this.#captions.length === 2 ? ' named' : ''}`;
    return html`${this.#problem ? html`<p class="error" part="error" role="alert" lang="en">${this.#problem.message}</p>` : nothing}
      <div class=${kind} style=${isSlider ? `--_at: ${this.#at}%; --_clip: inset(${clip})` : nothing}>
        ${this.#captions.length === 2 ? this.#captions.map((caption) => html`<div class="caption" part="caption">${caption}</div>`) : nothing}
        <slot></slot>
        ${isSlider ? this.#renderDivider() : nothing}
      </div>`;
  }

  #renderDivider(): unknown {
    const { messages } = this.#locale;
    const at = Math.round(this.#at);
    return html`<div class="divider" part="divider" role="slider" tabindex="0" aria-orientation="horizontal"
      aria-label=${messages.compareDivider} aria-valuemin="0" aria-valuemax="100" aria-valuenow=${at} aria-valuetext=${`${this.#locale.number(at)} %`}
      @pointerdown=${this.#onPointer} @pointermove=${this.#onPointer} @keydown=${this.#onKey}
    ><div class="line"></div><div class="knob"><svg viewBox="0 0 24 24" aria-hidden="true"><path d="M9 7l-5 5 5 5M15 7l5 5-5 5"></path></svg></div></div>`;
  }
}

declare global {
  interface HTMLElementTagNameMap {
    'volume-compare': VolumeCompare;
  }
}
