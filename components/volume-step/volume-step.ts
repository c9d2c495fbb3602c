import { css, html } from 'lit';
import { state } from 'lit/decorators.js';
import { CustomStates } from '../internal/custom-states.ts';
import { reportIfLost } from '../internal/lost-element.ts';
import { number } from '../internal/property-kinds.ts';
import { property, ReflectingElement } from '../internal/reflecting-element.ts';

/**
 * A step of the `<volume-tour>` around it: a text with a heading, and attributes of `<volume-view>`, which the view gets while the step is
 * open: `camera-orbit`, `transfer-function`, `region`, `cutout`, `time` ... What a step leaves out is as before the tour.
 *
 * `<volume-step camera-orbit="90deg 80deg auto" notes="thalamus"><h3>The thalamus</h3><p>It is near the middle.</p></volume-step>`
 *
 * Attributes that say which data to show, `src` first of all, are not for steps.
 *
 * @tag volume-step
 * @slot - the text of the step; its first heading is its name
 * @slot poster - what the picture shows in this step, an `<img>` for instance: it appears on paper, and without scripts
 * @fires {CustomEvent<ErrorDetail>} error - there is no `<volume-tour>` around it
 */
export class VolumeStep extends ReflectingElement {
  static override readonly styles = css`
    :host {
      display: block;
    }

    :host([hidden]),
    .step[hidden] {
      display: none;
    }

    ::slotted(:first-child) {
      margin-block-start: 0;
    }

    ::slotted(:last-child) {
      margin-block-end: 0;
    }

    ::slotted([slot='poster']) {
      display: block;
      box-sizing: border-box;
      max-inline-size: 100%;
      block-size: auto;
    }

    @media not print {
      slot[name='poster'] {
        display: none;
      }
    }

    /* On paper there is room for all of them. */
    @media print {
      .step[hidden] {
        display: block;
      }

      .step {
        break-inside: avoid;
      }

      /* What follows the open step has nothing to show of a closed one. */
      .step[hidden] ::slotted(:is(volume-slice-view, volume-readout, volume-label-list, volume-timeline)) {
        display: none;
      }

      :host {
        margin-block-end: 1em;
      }
    }
  `;

  /** A short name, where the step has no heading. */
  @property() label!: string | null;

  /** The ids of the `<volume-note>`s that are open in this step, separated by blanks; all others are closed. */
  @property() notes!: string | null;

  /**
   * Which labels of the `<volume-labels>` in the view are shown: ids, as its attribute `only` has them, `17 18` or `17 18 ghost`; `all`; or
   * `none`, for the volume without labels.
   */
  @property() labels!: string | null;

  /** How long it stays open while the tour plays, seconds, 1 to 3600. By default as the `<volume-tour>` says. */
  @property({ kind: number }) dwell!: number | null;

  /** Type and position of the first `<volume-slice>` in the view, `axial 20`; `none` hides it. */
  @property() slice!: string | null;

  @state() private _closed = false;
  readonly #states = new CustomStates<'open'>(this);

  override connectedCallback(): void {
    super.connectedCallback();
    reportIfLost(this, 'volume-tour');
  }

  /** The step is open, or closed. @param isVisible - whether the text of a closed step is visible too @internal */
  setOpen(isOpen: boolean, isVisible = false): void {
    this._closed = !isOpen && !isVisible;
    this.#states.set('open', isOpen);
  }

  protected override render(): unknown {
    return html`<div class="step" ?hidden=${this._closed}><slot></slot><slot name="poster"></slot></div>`;
  }
}

declare global {
  interface HTMLElementTagNameMap {
    'volume-step': VolumeStep;
  }
}
