import { html, nothing } from 'lit';
import type { PropertyValues, TemplateResult } from 'lit';
import { state } from 'lit/decorators.js';
import { invalidAttribute } from '../../src/core/errors.ts';
import type { VolumeViewError } from '../../src/core/errors.ts';
import { blockStyles } from '../internal/block-styles.ts';
import { property, ReflectingElement } from '../internal/reflecting-element.ts';
import type { VolumeView } from '../volume-view/volume-view.ts';
import { emit } from '../internal/volume-view-events.ts';
import { styles } from './volume-workspace-styles.ts';

/** Planes in the order of the panes. */
const planes = ['axial', 'sagittal', 'coronal'] as const;

/** Companions in their order in the layout, and the volumes that they suit. */
const companions: Readonly<Record<string, { suits: (view: VolumeView) => boolean; render: () => TemplateResult }>> = {
  timeline: {
    suits: ({ times }) => times.length > 1,
    render: () => html`<volume-timeline part="timeline"></volume-timeline>`,
  },
  legend: { suits: () => true, render: () => html`<volume-legend part="legend"></volume-legend>` },
  readout: { suits: () => true, render: () => html`<volume-readout part="readout"></volume-readout>` },
  'label-list': {
    suits: (view) => view.querySelector('volume-labels:not([hidden])') !== null,
    render: () => html`<volume-label-list part="label-list"></volume-label-list>`,
  },
};

/** The events of the `<volume-view>` after which other companions may suit it. */
const events = ['load', 'scans-change', 'labels-change'];

/**
 * A volume, three panes of slices, and its companions: legend, readout, list of labels, timeline. The layout depends on the room:
 * two by two on a desktop, one below the other on a phone. Its contents belong to its `<volume-view>`, without `for`.
 *
 * `<volume-workspace><volume-view src="head.nii.gz" alt="Brain"></volume-view></volume-workspace>`
 *
 * Put a companion of your own into it with `slot="side"`: it replaces the one that the workspace would add.
 *
 * @tag volume-workspace
 * @slot - the `<volume-view>`
 * @slot side - companions of your own, after the others
 * @csspart stage - the box around the volume and the panes
 * @csspart pane - each pane
 * @csspart side - the box around the companions
 * @csspart timeline - the timeline, where there are several scans
 * @csspart legend - the legend
 * @csspart readout - the readout
 * @csspart label-list - the list, where there are labels
 * @csspart error - the text where an attribute has a wrong word
 * @fires {CustomEvent<ErrorDetail>} error - an attribute has a wrong word; the attribute is ignored
 * @cssproperty --volume-workspace-gap - space between its parts; 8px by default
 */
export class VolumeWorkspace extends ReflectingElement {
  static override readonly styles = [blockStyles, styles];

  /**
   * Which panes are shown: a list of `axial`, `sagittal` and `coronal`, or `none`. A radar has none.
   * @default axial sagittal coronal
   */
  @property() panes!: string | null;

  /**
   * Which companions are shown: a list of `timeline`, `legend`, `readout` and `label-list`, or `none`.
   * @default those for which the volume has something
   */
  @property() companions!: string | null;

  @state() private _view: VolumeView | null = null;
  readonly #observer = new MutationObserver(() => this.#follow());
  #panes: readonly string[] | null = null;
  #companions: readonly string[] | null = null;
  #problem: VolumeViewError | null = null;
  readonly #changed = (): void => this.requestUpdate();

  override connectedCallback(): void {
    super.connectedCallback();
    this.#observer.observe(this, { childList: true, subtree: true });
    this.#follow();
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#observer.disconnect();
    for (const type of events) this._view?.removeEventListener(type, this.#changed);
    this._view = null;
  }

  /** Find the first `<volume-view>`, and the companions that the author has added. */
  #follow(): void {
    const view = this.querySelector('volume-view');
    if (view !== this._view) {
      for (const type of events) {
        this._view?.removeEventListener(type, this.#changed);
        view?.addEventListener(type, this.#changed);
      }
      this._view = view;
      if (view?.matches(':not(:defined)')) void customElements.whenDefined('volume-view').then(this.#changed);
    }
    this.requestUpdate();
  }

  protected override willUpdate(changed: PropertyValues<this>): void {
    if (!changed.has('panes') && !changed.has('companions')) return;
    this.#problem = null;
    this.#panes = this.#read('panes', planes);
    this.#companions = this.#read('companions', Object.keys(companions));
  }

  /** The words of an attribute; null where it is absent or wrong. */
  #read(attribute: 'panes' | 'companions', known: readonly string[]): readonly string[] | null {
    const text = this[attribute];
    if (text === null) return null;
    const words = text
      .trim()
      .split(/[\s,]+/)
      .filter((word) => word !== '' && word !== 'none');
    if (words.every((word) => known.includes(word))) return words;
    this.#problem ??= invalidAttribute(
      `${attribute} of <volume-workspace>`,
      text,
      `none, or some of ${known.join(', ')}`,
    );
    return null;
  }

  protected override updated(changed: PropertyValues<this>): void {
    if (!this.#problem || (!changed.has('panes') && !changed.has('companions'))) return;
    const { code, message } = this.#problem;
    emit(this, 'error', { code, message });
  }

  protected override render(): unknown {
    const view = this._view?.matches(':defined') ? this._view : null;
    const panes =
      this._view && !view?.volume?.sweeps ? planes.filter((plane) => this.#panes?.includes(plane) ?? true) : [];
    const side = Object.entries(companions).filter(
      ([name, { suits }]) =>
        view &&
        !this.querySelector(`volume-${name}`) &&
        (this.#companions ? this.#companions.includes(name) : suits(view)),
    );
    const hasSide = side.length > 0 || this.querySelector(':scope > [slot=side]') !== null;
    return html`${this.#problem ? html`<p class="error" part="error" role="alert" lang="en">${this.#problem.message}</p>` : nothing}
      <div class=${hasSide ? 'workspace sided' : 'workspace'}>
        <div class="stage ${['', 'panes one', 'panes two', 'panes three'][panes.length]}" part="stage">
          <slot></slot>
          ${panes.map((plane) => html`<volume-slice-view part="pane" type=${plane}></volume-slice-view>`)}
        </div>
        <div class="side" part="side" ?hidden=${!hasSide}>${side.map(([, { render }]) => render())}<slot name="side" @slotchange=${this.#changed}></slot></div>
      </div>`;
  }
}

declare global {
  interface HTMLElementTagNameMap {
    'volume-workspace': VolumeWorkspace;
  }
}
