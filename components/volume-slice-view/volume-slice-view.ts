import { html, nothing } from 'lit';
import type { PropertyValues } from 'lit';
import { query, state } from 'lit/decorators.js';
import { live } from 'lit/directives/live.js';
import type { LoadProgress } from '../../src/formats/base/load-request.ts';
import type { SlicedVolume } from '../../src/panes/slice-field.ts';
import { toPlane } from '../../src/panes/slice-plane.ts';
import type { Vector3 } from '../../src/volume/matrix.ts';
import type { Volume } from '../../src/volume/volume.ts';
import { isPatient } from '../../src/volume/world-axes.ts';
import { CompanionLocale } from '../../src/messages/companion-locale.ts';
import { english } from '../../src/messages/english-slices.ts';
import { LocaleController } from '../../src/messages/locale-controller.ts';
import { number, vector, pairOrText } from '../internal/property-kinds.ts';
import { property, ReflectingElement, writeSafely } from '../internal/reflecting-element.ts';
import { PaneTarget } from '../../src/viewer/attachments/pane-label-target.ts';
import { hasNotices } from '../../src/viewer/model/file-notices.ts';
import { SlicePresenter } from '../../src/viewer/attachments/slice-presenter.ts';
import type { Shown } from '../../src/viewer/attachments/slice-presenter.ts';
import { describeVolume } from '../../src/viewer/model/volume-info.ts';
import type { VolumeInfo } from '../../src/viewer/model/volume-info.ts';
import { SliceSource } from '../../src/viewer/attachments/slice-source.ts';
import { LazyPart } from '../internal/lazy-part.ts';
import { socketOf } from '../../src/viewer/model/view-socket.ts';
import { VolumeLink } from '../internal/volume-link.ts';
import { emit } from '../internal/volume-view-events.ts';
import {
  describePlace,
  describeValue,
  describeWindow,
  labelsOf,
  renderCrosshair,
  renderSides,
  renderTexts,
  renderWindows,
  shareOf,
} from './volume-slice-view-parts.ts';
import type { SliceCursorDetail, SliceLocale } from './volume-slice-view-parts.ts';
import { styles } from './volume-slice-view-styles.ts';

export type { SliceCursorDetail } from './volume-slice-view-parts.ts';

/**
 * A slice of a volume in a pane of its own, as in radiology, with letters of the patient's sides, a scale bar and a
 * crosshair. It is computed from the samples on the CPU, in 64-bit floats, without the GPU.
 *
 * With `src` it works alone. Without it, it shows the volume of the `<volume-view>` that `for` names, or of the nearest one. All panes
 * of one volume, or of one `group`, share one crosshair.
 *
 * `<volume-slice-view for="head" type="coronal"></volume-slice-view>`
 *
 * @tag volume-slice-view
 * @csspart picture - the picture, which takes the focus
 * @csspart place - the position of the slice
 * @csspart window - width and level of the window
 * @csspart scale - the scale bar and its length
 * @csspart value - the value at the crosshair
 * @csspart side - each letter of a patient's side
 * @csspart crosshair - each of its two lines
 * @csspart note-pin - the pin of a `<volume-note>` of its view
 * @csspart note - the name of a note
 * @csspart note-text - the text of a note that opens
 * @csspart windows - the choice among the windows of a DICOM file with several
 * @csspart slider - moves through the slices
 * @csspart hint - the text where there is no volume
 * @csspart notice-sign - the sign that a part of the file of `src` is not in the picture, or is shown differently
 * @csspart notice-text - its text
 * @csspart error - the text of an error
 * @cssproperty --volume-slice-crosshair-color - colour of the crosshair
 * @cssproperty --volume-slice-accent - colour of the slider
 * @cssproperty --volume-view-notice-color - colour of the sign for parts of a file that are not in the picture, and of its text
 * @cssproperty --volume-view-notice-background - background of the sign and of its text
 * @cssproperty --volume-view-focus-color - colour of the frame around the element with the focus
 * @cssproperty --volume-view-error-background - background of the text of an error
 * @cssproperty --volume-view-error-color - colour of the text of an error
 * @fires {CustomEvent<SliceCursorDetail>} cursor-change - the position of the crosshair: at first, and when it has moved, in this pane or in another pane that shares it
 * @fires {CustomEvent<{ window: readonly [number, number] }>} window-change - a person has chosen another window
 * @fires {CustomEvent<null>} load - the file of `src` has been loaded
 * @fires {CustomEvent<ErrorDetail>} error - something failed; the last good picture stays
 */
export class VolumeSliceView extends ReflectingElement {
  static override readonly styles = styles;

  /** The id of the `<volume-view>`; by default the nearest one. */
  @property({ attribute: 'for' }) htmlFor!: string | null;

  /** A file to show without any `<volume-view>`. */
  @property() src!: string | null;

  /**
   * `axial`, `coronal`, `sagittal`, or `oblique`.
   * @default axial
   */
  @property() type!: string | null;

  /** Of an oblique slice: the direction of view, `x y z`, from the patient's left to right, back to front and feet to head. */
  @property({ kind: vector }) normal!: Vector3 | null;

  /** Position of the slice in world units (mm) along the axis that it cuts. By default that of the crosshair. */
  @property({ kind: number }) at!: number | null;

  /**
   * Thickness of the slice, in world units (mm).
   * @default 0
   */
  @property({ kind: number }) thickness!: number | null;

  /**
   * Which value of a thick slice is shown: `average`, `max` or `min`.
   * @default average
   */
  @property() projection!: string | null;

  /**
   * Data values of black and white, `low high`; or the name or the number of a window of a DICOM file, `lung` or `2`. By default those of
   * the `<volume-view>`, the window for soft tissue of a CT, or a window that suits the values.
   */
  @property({ attribute: 'value-window', kind: pairOrText }) valueWindow!:
    | readonly [low: number, high: number]
    | string
    | null;

  /**
   * `linear-exact`, or `linear`: DICOM's two ways to read a window, which differ by half a value.
   * @default linear-exact
   */
  @property({ attribute: 'window-function' }) windowFunction!: string | null;

  /**
   * `linear`, or `nearest`: each voxel as a block. Labels are always shown as blocks.
   * @default linear
   */
  @property() interpolation!: string | null;

  /**
   * `gray`, or `volume`: the colours of the transfer function. The default is `volume` for labels and for maps of both signs, else `gray`.
   */
  @property() colors!: string | null;

  /**
   * What a drag with the left button changes: the `cursor`, or the `window`. The right button changes the other.
   * @default cursor
   */
  @property() drag!: string | null;

  /**
   * Opacity of the colours of `<volume-labels>` over the grey, 0 to 1.
   * @default 0.5
   */
  @property({ attribute: 'label-opacity', kind: number }) labelOpacity!: number | null;

  /** Panes of one group share one crosshair, whatever they show. By default all panes of one volume are a group. */
  @property() group!: string | null;

  /** A description of the picture; by default the kind of slice and its position. */
  @property() alt!: string | null;

  @query('canvas') private readonly _canvas!: HTMLCanvasElement;
  @query('.picture') private readonly _picture!: HTMLElement;
  @state() private _progress: LoadProgress | null = null;
  /** The text for screen readers. */
  @state() private _said = '';

  readonly #locale = new CompanionLocale(this);
  readonly #messages = new LocaleController(this, english);
  readonly #link = new VolumeLink(this, () => this.#presenter.refresh(() => false), [
    'load',
    'optics-change',
    'time-change',
    'labels-change',
    'layer-change',
  ]);
  readonly #resizing = new ResizeObserver(() => this.#resize());
  /** The volume of `src`, and its description. */
  #own: Volume | null = null;
  #info: VolumeInfo | null = null;
  /** Notices of the file of `src`: for the volume of a view, the view shows them. */
  readonly #notices = new LazyPart(
    this,
    async () =>
      new (await import('../internal/view-notices.ts')).ViewNotices(this, () => ({
        info: this.#info,
        fileNotices: this.#labelTarget.fileNotices,
      })),
  );
  #saying = 0;

  readonly #presenter: SlicePresenter = new SlicePresenter({
    isThere: () => this.isConnected,
    shown: () => this.#shown,
    text: (name) => this.readText(name),
    changed: () => this.requestUpdate(),
    moved: (what) => this.#onMoved(what),
    failed: ({ code, message, cause }) => emit(this, 'error', { code, message, cause }),
  });

  readonly #source = new SliceSource({
    progress: (progress) => (this._progress = progress),
    loaded: (volume) => this.#take(volume),
    failed: (error) => this.#presenter.fail(error),
  });

  /** The target to which labels between the tags of this element are applied. */
  readonly #labelTarget = new PaneTarget({
    volume: () => this.#own,
    file: () => this.src ?? '',
    changed: () => this.#presenter.refresh(() => false),
    take: (volume) => this.#take(volume),
  });

  /** Position of the crosshair, world units; null before there is a volume. Setting it writes the attribute `cursor`. */
  @property({ kind: vector })
  get cursor(): Vector3 | null {
    const { sliced, place } = this.#presenter.pane;
    return sliced ? place : vector.read(this.readText('cursor'));
  }

  set cursor(cursor: Vector3 | null) {
    this.writeText('cursor', writeSafely(vector.write, cursor));
  }

  /** Resolves when the picture for the present attributes is drawn at its final quality; at once where nothing is to be shown. */
  async whenRendered(): Promise<void> {
    await this.updateComplete;
    await this.#source.loaded;
    await this.#labelTarget.done;
    await this.#presenter.drawn();
    await this.updateComplete;
  }

  constructor() {
    super();
    void socketOf(this).join({
      key: 'volume-slice-view',
      element: this,
      labelTarget: this.#labelTarget,
      redraw: () => this.#presenter.redraw(),
    });
  }

  override connectedCallback(): void {
    super.connectedCallback();
    if (this.hasUpdated) this.#enter();
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#presenter.leave();
    this.#resizing.disconnect();
    this.#source.stop();
    clearTimeout(this.#saying);
  }

  protected override willUpdate(changed: PropertyValues<this>): void {
    if (changed.has('htmlFor') && this.hasUpdated) this.#link.find();
  }

  protected override firstUpdated(): void {
    if (this.isConnected) this.#enter();
  }

  protected override updated(changed: PropertyValues<this>): void {
    this.#notices.follow(hasNotices(this.#info, this.#labelTarget.fileNotices));
    if (changed.has('src') && this.isConnected) this.#follow();
    // Names with an underscore are internal state, not attributes.
    if ([...changed.keys()].some((name) => !String(name).startsWith('_')))
      this.#presenter.refresh((name) => changed.has(name));
  }

  protected override render(): unknown {
    const { pane } = this.#presenter;
    const error = this.#presenter.error ?? this.#labelTarget.error;
    const { sliced, look: appearance } = pane;
    const { language } = this.#locale;
    const locale: SliceLocale = { language, messages: this.#messages.messages };
    const { slice, sliceAt, sliceKeys, loading } = locale.messages;
    const label =
      this.alt ?? (sliced && appearance ? sliceAt(slice[appearance.type], describePlace(pane, locale)) : slice.axial);
    return html`
      <div class="picture" part="picture" role="img" tabindex="0" aria-label=${label} aria-describedby="window keys">
        <canvas aria-hidden="true"></canvas>
        ${sliced && appearance ? html`${renderCrosshair(pane)}${isPatient(sliced.volume) ? renderSides(pane) : nothing}${renderTexts(pane, locale)}` : nothing}
      </div>
      ${sliced && appearance ? this.#renderSlider(sliced, slice[appearance.type], describePlace(pane, locale)) : nothing}
      ${sliced && appearance ? renderWindows(pane, locale) : nothing}
      ${sliced ? this.#notices.render() : nothing}
      ${this._progress ? html`<div class="loading">${loading}<progress aria-label=${loading} max="1" value=${shareOf(this._progress) ?? nothing}></progress></div>` : nothing}
      ${sliced || this._progress || error || this.src ? nothing : html`<p class="hint" part="hint">${this.#link.describeLack(language.messages)}</p>`}
      ${error ? html`<p class="problem" part="error" role="alert" tabindex="0">${error.message}</p>` : nothing}
      <div class="spoken" id="window">${sliced && appearance && !appearance.colors ? describeWindow(pane, locale) : nothing}</div>
      <div class="spoken" id="keys">${sliceKeys}</div>
      <div class="spoken" role="status">${this._said}</div>
    `;
  }

  #renderSlider(sliced: SlicedVolume, label: string, place: string): unknown {
    const {
      plane,
      ends: [low, high],
      place: at,
    } = this.#presenter.pane;
    return html`<input type="range" part="slider" aria-label=${label} aria-valuetext=${place} min=${low} max=${high} step=${sliced.stepAlong(plane.normal)}
      .value=${live(String(toPlane(plane, at).d))} @input=${this.#onSlide} />`;
  }

  get #shown(): Shown {
    const { view } = this.#link;
    const { group } = this;
    if (this.src)
      return {
        volume: this.#own,
        owner: this,
        group,
        shared: null,
        look: this.#labelTarget.look,
        labels: (opacity) => labelsOf(this, this.#own, opacity),
      };
    const held = this.#link.volume;
    return {
      volume: held,
      owner: view ?? this,
      group,
      shared: view && held ? { optics: view.optics, window: view.valueWindow } : null,
      labels: (opacity) => labelsOf(view, held, opacity),
    };
  }

  #enter(): void {
    // The size has to be known before anything is drawn: the observer reports it a frame later.
    this.#resize();
    this.#presenter.enter(this._picture, this._canvas);
    this.#resizing.observe(this);
    this.#follow();
  }

  #take(volume: Volume | null): void {
    this.#setOwn(volume);
    this.#presenter.refresh(() => false);
    emit(this, 'load', null);
  }

  /** Load the file of `src`. */
  #follow(): void {
    const { src } = this;
    if (src) return this.#source.load(src);
    this.#source.stop();
    this.#setOwn(null);
    this._progress = null;
  }

  #setOwn(volume: Volume | null): void {
    this.#own = volume;
    this.#info = volume && describeVolume(volume);
    this.requestUpdate();
  }

  #resize(): void {
    const { clientWidth: width, clientHeight: height } = this;
    this.#presenter.pane.setSize({ width, height }, window.devicePixelRatio);
    this.#presenter.redraw();
  }

  #onMoved(what: 'cursor' | 'window'): void {
    const { sliced, place, window, labels } = this.#presenter.pane;
    if (what === 'window') emit(this, 'window-change', { window });
    else
      emit(this, 'cursor-change', {
        cursor: place,
        value: sliced?.valueAt(place) ?? null,
        label: labels?.nameAt(place) ?? null,
      } satisfies SliceCursorDetail);
    if (this.shadowRoot?.activeElement === this._picture) this.#sayLater(what);
  }

  /** Send place and value, or the window, to screen readers when the interaction has stopped. */
  #sayLater(what: 'cursor' | 'window'): void {
    clearTimeout(this.#saying);
    this.#saying = setTimeout(() => {
      const { pane } = this.#presenter;
      const locale: SliceLocale = { language: this.#locale.language, messages: this.#messages.messages };
      this._said =
        what === 'window'
          ? describeWindow(pane, locale)
          : `${describePlace(pane, locale)}: ${describeValue(pane, locale)}`;
    }, 500) as unknown as number;
  }

  readonly #onSlide = ({ target }: Event): void =>
    this.#presenter.pane.goTo((target as HTMLInputElement).valueAsNumber);
}

declare global {
  interface HTMLElementTagNameMap {
    'volume-slice-view': VolumeSliceView;
  }
}
