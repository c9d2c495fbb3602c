import { html, nothing } from 'lit';
import type { PropertyValues } from 'lit';
import type { TransferFunction } from '../../src/optics/transfer/transfer-function.ts';
import { describeScale, legendDomain } from '../../src/editor/describe-scale.ts';
import { boxHeight, boxLength, drawArea, paintStops } from '../../src/editor/paint-curve.ts';
import { labelTicks } from '../../src/editor/tick-labels.ts';
import { thinStops } from '../../src/editor/transfer-function-edits.ts';
import { labelShift } from '../../src/editor/ticks.ts';
import { toShare } from '../../src/editor/transfer-function-axes.ts';
import type { Language } from '../../src/messages/language.ts';
import { socketOf } from '../../src/viewer/model/view-socket.ts';
import type { ChannelInfo } from '../../src/viewer/model/volume-info.ts';
import { CompanionLocale } from '../../src/messages/companion-locale.ts';
import { renderGradientStops } from '../internal/color-gradient.ts';
import { flag } from '../internal/property-kinds.ts';
import { property, ReflectingElement } from '../internal/reflecting-element.ts';
import { styles } from './volume-legend-styles.ts';
import { companionGap, withViewWidth } from '../internal/view-width.ts';
import { VolumeLink } from '../internal/volume-link.ts';

/** Maximum number of stops that are drawn: as many as an author may write. Labels may have more stops; then only some are drawn. */
const maxDrawn = 1024;

/** Maximum number of numbers along the scale. */
const maxTicks = 9;

/**
 * The colours of a volume and their values. The band shows the colours on an opaque background; the height of the curve on it
 * shows the opacity of each value.
 *
 * Without `for` it belongs to the nearest `<volume-view>`: the one around it, else the first one in the smallest element that
 * contains both.
 *
 * @tag volume-legend
 * @csspart title - the name of the values, and their unit
 * @csspart bar - the colours
 * @csspart ticks - the numbers
 * @csspart channel - the colour, the name and the window of a channel, where the volume has several
 * @csspart offset - the number to add to all numbers, where only their last digits differ
 * @csspart hint - the text where there is no volume
 * @cssproperty --volume-legend-background - background of the colours; dark by default, as behind a volume
 * @cssproperty --volume-legend-length - length of a vertical scale; 14rem by default
 */
export class VolumeLegend extends ReflectingElement {
  static override readonly styles = [companionGap, styles];

  /** The id of the `<volume-view>`; by default the nearest one. */
  @property({ attribute: 'for' }) htmlFor!: string | null;

  /** Name of the values, `Reflectivity` for instance; by default the title of the volume. An empty text shows no title. */
  @property() label!: string | null;

  /** Shows the scale of the `<volume-layer>` over the volume, or of the `color-moment` of a radar, instead of the volume's own. */
  @property({ kind: flag }) layer!: boolean;

  /**
   * `horizontal` (by default), or `vertical`.
   * @default horizontal
   */
  @property() orientation!: string | null;

  readonly #link = withViewWidth(
    new VolumeLink(this, () => this.requestUpdate(), ['load', 'optics-change', 'layer-change']),
  );
  readonly #locale = new CompanionLocale(this);

  protected override willUpdate(changed: PropertyValues<this>): void {
    if (changed.has('htmlFor') && this.hasUpdated) this.#link.find();
  }

  protected override render(): unknown {
    const { language } = this.#locale;
    const volume = this.#link.view?.volume;
    const optics = this.#link.view?.optics;
    if (!volume || !optics) return html`<p class="hint" part="hint">${this.#link.describeLack(language.messages)}</p>`;
    const over = this.layer && this.#link.view ? socketOf(this.#link.view).last('overlay') : null;
    if (this.layer && !over) return nothing; // The layer is still loading, or hidden.
    if (volume.channels && !over) return renderChannels(volume.channels, this.label, language);
    const { unit, range } = over?.shown.volume ?? volume;
    const title = over?.name ?? volume.title ?? '';
    const stops = over?.shown.transferFunction ?? optics.transferFunction;
    const domain = legendDomain(stops, range);
    const label = this.label ?? title;
    const upright = this.orientation?.trim().toLowerCase() === 'vertical';
    return html`<div class="legend ${upright ? 'upright' : 'flat'}" role="img" aria-label=${describeScale({ stops, domain, label, unit }, language)}>
      ${label || unit ? html`<div class="title" part="title">${label}${unit ? html`<span class="unit">${unit}</span>` : nothing}</div>` : nothing}
      <div class="scale">${renderBar(stops, domain, upright)}${renderTicks(domain, language)}</div>
    </div>`;
  }
}

/** The colours of channels, from dark to the value that has all of the colour. */
function renderChannels(channels: readonly ChannelInfo[], label: string | null, language: Language): unknown {
  return html`<div class="legend channels">
    ${label ? html`<div class="title" part="title">${label}</div>` : nothing}
    <ul>${channels.map(({ number, name, color, window: [low, high] }) => {
      const css = `rgb(${color.map((part) => Math.round(255 * part)).join(' ')})`;
      return html`<li part="channel"><span class="light" .style=${`--light: ${css}`}></span><bdi>${name || language.number(number)}</bdi>
        <span class="window">${language.number(low, 4)} – ${language.number(high, 4)}</span></li>`;
    })}</ul>
  </div>`;
}

function renderBar(stops: TransferFunction, domain: readonly [number, number], upright: boolean): unknown {
  const points = paintStops(stops.length > maxDrawn ? thinStops(stops, maxDrawn / 4) : stops, domain);
  const [width, height] = upright ? [boxHeight, boxLength] : [boxLength, boxHeight];
  const [x2, y1] = upright ? [0, boxLength] : [boxLength, 0];
  return html`<div class="bar" part="bar">
    <svg class="opacity" viewBox="0 0 ${width} ${height}" preserveAspectRatio="none">
      <defs><linearGradient id="colors" gradientUnits="userSpaceOnUse" x1="0" y1=${y1} x2=${x2} y2="0">${renderGradientStops(points)}</linearGradient></defs>
      <path fill="url(#colors)" d=${drawArea(points, upright)}></path>
    </svg>
    <svg class="colors" viewBox="0 0 ${width} ${height}" preserveAspectRatio="none">
      <path fill="url(#colors)" d="M0 0H${width}V${height}H0Z"></path>
    </svg>
  </div>`;
}

function renderTicks(domain: readonly [number, number], language: Language): unknown {
  const { ticks, offset } = labelTicks(domain, maxTicks, language);
  return html`<div class="ticks" part="ticks">
    ${ticks.map(({ value, text }) => {
      const share = toShare(value, domain);
      return html`<span .style=${`--at: ${share}; --shift: ${labelShift(share)}`}>${text}</span>`;
    })}
  </div>
  ${offset ? html`<div class="offset" part="offset"><bdi dir="ltr">${offset}</bdi></div>` : nothing}`;
}

declare global {
  interface HTMLElementTagNameMap {
    'volume-legend': VolumeLegend;
  }
}
