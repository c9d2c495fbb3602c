import { html, nothing } from 'lit';
import type { PropertyValues } from 'lit';
import { asVolumeViewError, invalidAttribute } from '../../src/core/errors.ts';
import type { VolumeViewError } from '../../src/core/errors.ts';
import { parseCssColor } from '../../src/optics/transfer/css-color.ts';
import { MeasureModel } from '../../src/viewer/tools/measure-model.ts';
import { MeasureStage } from '../../src/viewer/tools/measure-stage.ts';
import { pointCounts } from '../../src/viewer/tools/measuring.ts';
import type { MeasureResult } from '../../src/viewer/tools/measuring.ts';
import type { LineColor } from '../../src/viewer/tools/view-lines.ts';
import type { Vector3 } from '../../src/volume/matrix.ts';
import { MeasureLocaleController } from '../../src/messages/measure-locale.ts';
import { places } from '../internal/places-kind.ts';
import { property, ReflectingElement, writeSafely } from '../internal/reflecting-element.ts';
import { companionGap, withViewWidth } from '../internal/view-width.ts';
import { VolumeLink } from '../internal/volume-link.ts';
import { namePoints } from './volume-measure-names.ts';
import { listMeasure, writeMeasure } from './volume-measure-rows.ts';
import type { MeasureLocale } from './volume-measure-rows.ts';
import { styles } from './volume-measure-styles.ts';
import { isRadar } from '../internal/volume-readout-rows.ts';
import type { Row } from '../internal/volume-readout-rows.ts';

/** A screen reader gets the result when it has not changed for this time, ms. */
const restMs = 500;

const usualColor = '#3ec1ff';

/**
 * A distance, an angle, or the values inside a box or a sphere, measured in the picture of a `<volume-view>`: with lines in the scene,
 * and handles to drag by mouse and finger or to move by keys. Each number comes with the uncertainty that follows from the voxels.
 *
 * Without `for` it measures in the nearest `<volume-view>`: the one around it, else the first one in the smallest element that
 * contains both.
 *
 * With `hidden` nothing of it is visible, not even in the picture.
 *
 * `<volume-measure for="head" type="distance" points="-40 10 20, 35 10 20"></volume-measure>`
 *
 * @tag volume-measure
 * @csspart measure - the whole element
 * @csspart name - the name of the measure
 * @csspart row - a name and its text
 * @csspart button - each button
 * @csspart hint - the text next to the buttons
 * @csspart error - the text of an error
 * @cssproperty --volume-view-focus-color - colour of the ring around the element with the focus; by default that of the text
 * @cssproperty --volume-view-error-background - background of the text of an error
 * @cssproperty --volume-view-error-color - colour of the text of an error
 * @fires {CustomEvent<MeasureResult | null>} measure-change - the measure has changed, or the values inside have been added up; null when there is nothing to measure any longer
 * @fires {CustomEvent<ErrorDetail>} error - something failed; the last good measure stays
 */
export class VolumeMeasure extends ReflectingElement {
  static override readonly styles = [companionGap, styles];

  /** The id of the `<volume-view>`; by default the nearest one. */
  @property({ attribute: 'for' }) htmlFor!: string | null;

  /**
   * `distance` between two points, `angle` at the second of three points, `box` with two opposite corners along the axes of the world, or
   * `sphere` with its centre and a point on it.
   * @default distance
   */
  @property() type!: string | null;

  /** Its name; by default its type. */
  @property() label!: string | null;

  /** CSS colour of its lines and handles. */
  @property() color!: string | null;

  readonly #link = withViewWidth(new VolumeLink(this, () => this.#follow(), ['load', 'optics-change', 'time-change']));
  readonly #controller = new MeasureLocaleController(this);
  readonly #model = new MeasureModel({
    volume: () => this.#link.volume,
    changed: () => {
      this.requestUpdate();
      this.#speakLater();
    },
    measured: (result) => this.#emit('measure-change', result),
  });
  #stage: MeasureStage | null = null;
  #color: { css: string; rgb: LineColor } = { css: usualColor, rgb: parseCssColor(usualColor)!.color };
  #error: VolumeViewError | null = null;
  /** The text that a screen reader got last, and the timer for the next one. */
  #reported = '';
  #timer = 0;

  /**
   * The points of the measure, `x y z, x y z`, in world units (mm for medical files; for a radar metres east, north and above the antenna,
   * before the exaggeration of heights). Without it, a person places the points. Reading it returns the present points.
   */
  @property({ kind: places })
  get points(): readonly Vector3[] | null {
    return this.#model.isWhole ? this.#model.points : places.read(this.readText('points'));
  }

  set points(points: readonly Vector3[] | null) {
    this.writeText('points', writeSafely(places.write, points));
  }

  constructor() {
    super();
    new MutationObserver(() => this.#hide()).observe(this, { attributes: true, attributeFilter: ['hidden'] });
  }

  /** The result; null before there is one. While the values inside are being added up, its `statistics` are null. */
  get result(): MeasureResult | null {
    return this.#model.result;
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#model.stop();
    clearTimeout(this.#timer);
  }

  protected override willUpdate(changed: PropertyValues<this>): void {
    if (changed.has('htmlFor') && this.hasUpdated) this.#link.find();
    if (changed.has('type') || changed.has('points') || changed.has('color')) this.#read(changed.has('points'));
  }

  protected override updated(): void {
    this.#show();
  }

  #read(pointsAreNew: boolean): void {
    try {
      const css = this.color?.trim() || usualColor;
      const rgb = parseCssColor(css)?.color;
      if (!rgb) throw invalidAttribute('color of <volume-measure>', css, 'a colour as CSS writes it, like "#3ec1ff"');
      this.#model.read(this.type, this.readText('points'), pointsAreNew);
      this.#color = { css, rgb };
      this.#error = null;
    } catch (thrown) {
      this.#error = asVolumeViewError(thrown, 'volume-measure');
      const { code, message, cause } = this.#error;
      this.#emit('error', { code, message, cause });
    }
  }

  /** Called when there is another view, or none, or another volume in it. */
  #follow(): void {
    const { view } = this.#link;
    const picture = view?.shadowRoot?.querySelector('.picture');
    if (this.#stage && this.#stage.view !== view) {
      this.#stage.dispose();
      this.#stage = null;
    }
    if (view && picture && this.#link.volume) {
      this.#stage ??= new MeasureStage(view, picture, {
        moved: (index, to) => this.#model.move(index, to),
        picked: (at) => (at ? this.#model.add(at) : this.#say(this.#controller.messages.nothingThere)),
        key: (event) => this.#onKey(event),
      });
    }
    this.#model.refresh();
  }

  readonly #onKey = (event: KeyboardEvent): void => {
    if (event.key !== 'Escape' || !this.#model.placing) return;
    event.preventDefault();
    event.stopPropagation();
    this.#model.cancel();
  };

  /** Nobody can place a measure that is hidden. */
  #hide(): void {
    if (this.hidden) this.#model.cancel();
    this.requestUpdate();
  }

  readonly #toggle = (): void => (this.#model.placing ? this.#model.cancel() : this.#model.begin());

  readonly #placeInMiddle = async (): Promise<void> => {
    const { volume } = this.#link;
    const points = volume && this.#stage?.placesInTheMiddle(volume, this.#model.type);
    if (!points) return;
    this.#model.complete(points);
    await this.updateComplete;
    this.#stage?.focus(0); // So that keys move it at once.
  };

  #show(): void {
    const { type, points, placing, result } = this.#model;
    const [volume, info] = [this.#link.volume, this.#link.view?.volume];
    if (!this.#stage) return;
    this.#stage.placing = placing;
    if (!volume || !info || this.hidden) return this.#stage.show(null);
    const locale = this.#locale;
    this.#stage.show({
      volume,
      type,
      points,
      color: this.#color,
      text: result ? writeMeasure(result, locale) : '',
      names: namePoints({ points, count: pointCounts[type], name: this.#name }, info, locale),
    });
  }

  /** Send the result to the screen reader when it no longer changes. */
  #speakLater(): void {
    clearTimeout(this.#timer);
    this.#timer = window.setTimeout(
      () =>
        this.#say(
          this.#model.placing ? this.#prompt : this.#rows.map(({ name, text }) => `${name} ${text}`).join(', '),
        ),
      restMs,
    );
  }

  #say(text: string): void {
    this.#reported = text;
    this.requestUpdate();
  }

  get #locale(): MeasureLocale {
    const { language, messages } = this.#controller;
    return { language, messages };
  }

  get #name(): string {
    return this.label?.trim() || this.#controller.messages.measure[this.#model.type];
  }

  get #rows(): Row[] {
    const info = this.#link.view?.volume;
    const { result } = this.#model;
    return result && info ? listMeasure(result, isRadar(info), this.#locale) : [];
  }

  get #prompt(): string {
    const { language, messages } = this.#controller;
    return messages.measurePlace(
      language.number(this.#model.points.length + 1),
      language.number(pointCounts[this.#model.type]),
    );
  }

  protected override render(): unknown {
    const { messages } = this.#controller;
    const info = this.#link.view?.volume;
    const problem = this.#error
      ? html`<p class="problem" part="error" role="alert">${this.#error.message}</p>`
      : nothing;
    if (!this.#stage || !info)
      return html`<p class="hint" part="hint"><span dir="auto">${this.#link.describeLack(messages)}</span></p>${problem}`;
    const { placing: isPlacing, result } = this.#model;
    return html`<div class="measure" part="measure" role="group" aria-label=${this.#name} @keydown=${this.#onKey}>
      <p class="name" part="name"><span class="swatch" .style=${`background: ${this.#color.css}`}></span><bdi>${this.#name}</bdi></p>
      <dl>${this.#rows.map(({ name, text }) => html`<div class="row" part="row"><dt><span dir="auto">${name}</span></dt><dd><bdi>${text}</bdi></dd></div>`)}</dl>
      ${result && info.reduced ? html`<p class="hint" part="hint"><span dir="auto">${messages.measureReduced}</span></p>` : nothing}
      ${isPlacing || !result ? html`<p class="hint" part="hint"><span dir="auto">${isPlacing ? this.#prompt : messages.measureHint}</span></p>` : nothing}
      <div class="tools">
        <button type="button" part="button" aria-pressed=${isPlacing ? 'true' : 'false'} @click=${this.#toggle}>${isPlacing ? messages.measureCancel : messages.measureButton}</button>
        ${isPlacing || !result ? html`<button type="button" part="button" @click=${this.#placeInMiddle}>${messages.measureMiddle}</button>` : nothing}
      </div>
      ${problem}
      <div class="spoken" role="status">${this.#reported}</div>
    </div>`;
  }

  #emit(type: string, detail: unknown): void {
    const event = new CustomEvent(type, { detail });
    this.dispatchEvent(event);
  }
}

declare global {
  interface HTMLElementTagNameMap {
    'volume-measure': VolumeMeasure;
  }
}
