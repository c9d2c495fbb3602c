// The editor's chart: the number of voxels for each value, the curve, and the handles of its stops.
import { html, nothing, svg } from 'lit';
import type { TransferFunction } from '../../src/optics/transfer/transfer-function.ts';
import { writeColor } from '../../src/optics/transfer/write-transfer-function.ts';
import type { Histogram } from '../../src/volume/histogram.ts';
import { nameColor } from '../../src/editor/color-names.ts';
import { drawHistogram } from '../../src/editor/draw-histogram.ts';
import { boxHeight, boxLength, drawArea, drawCurve, paintStops } from '../../src/editor/paint-curve.ts';
import { labelTicks } from '../../src/editor/tick-labels.ts';
import { labelShift } from '../../src/editor/ticks.ts';
import { opacityTicks, toHeight, toShare } from '../../src/editor/transfer-function-axes.ts';
import { stopBounds } from '../../src/editor/transfer-function-edits.ts';
import type { Language } from '../../src/messages/language.ts';
import { renderGradientStops } from '../internal/color-gradient.ts';

/** The contents of a chart. */
export interface Chart {
  readonly histogram: Histogram;
  /** Data values at its left and right edge. */
  readonly domain: readonly [number, number];
  readonly stops: TransferFunction;
  readonly unit: string;
  readonly language: Language;
}

/** Maximum number of labels below the chart; as many as a narrow phone has room for. */
const maxTicks = 6;

/** The chart with its scales and the opaque colours. Screen readers skip it, as they read the handles. */
export function renderChart(chart: Chart, plot: unknown): unknown {
  return html`<div>${plot}${renderStrip()}${renderValueScale(chart)}</div>`;
}

/** The picture behind the handles. */
export function renderPicture({ histogram, domain, stops }: Chart): unknown {
  const points = paintStops(stops, domain);
  return html`<svg part="chart" class="chart" viewBox="0 0 ${boxLength} ${boxHeight}" preserveAspectRatio="none" aria-hidden="true">
    <defs><linearGradient id="colors" gradientUnits="userSpaceOnUse" x1="0" y1="0" x2=${boxLength} y2="0">${renderGradientStops(points)}</linearGradient></defs>
    <path class="histogram" d=${drawHistogram(histogram, domain)}></path>
    ${opacityTicks.map((opacity) => svg`<path class="grid" d="M0 ${boxHeight * (1 - toHeight(opacity))}H${boxLength}"></path>`)}
    <path class="area" fill="url(#colors)" d=${drawArea(points)}></path>
    <path class="curve" d=${drawCurve(points)}></path>
  </svg>`;
}

/** The numbers of the vertical axis. */
export function renderOpacityScale({ language }: Chart): unknown {
  return html`<div class="opacities" aria-hidden="true">
    ${opacityTicks.map((opacity) => html`<span .style=${`--y: ${toHeight(opacity)}`}>${language.percent(opacity)}</span>`)}
  </div>`;
}

/** The numbers of the horizontal axis; the last one has the unit. */
export function renderValueScale({ domain, unit, language }: Pick<Chart, 'domain' | 'unit' | 'language'>): unknown {
  const { ticks, offset } = labelTicks(domain, maxTicks, language);
  return html`<div class="values" aria-hidden="true">
    ${ticks.map(
      ({ value, text }, i) => html`<span .style=${placeLabel(toShare(value, domain))}
      >${text}${unit && i === ticks.length - 1 ? html`<small>${unit}</small>` : nothing}</span>`,
    )}
  </div>
  ${offset ? html`<div class="offset" aria-hidden="true">${offset}</div>` : nothing}`;
}

/** The opaque colours along the axis of values, with the gradient of the picture. */
function renderStrip(): unknown {
  return html`<svg part="strip" class="strip" viewBox="0 0 ${boxLength} 1" preserveAspectRatio="none" aria-hidden="true">
    <path fill="url(#colors)" d="M0 0H${boxLength}V1H0Z"></path>
  </svg>`;
}

const placeLabel = (share: number): string => `--x: ${share}; --shift: ${labelShift(share)}`;

/** A handle for every stop, in the order of their values. */
export function renderHandles({ domain, stops, unit, language }: Chart, chosen: number): unknown {
  const { messages } = language;
  return stops.map((stop, i) => {
    const { value, opacity, color } = stop;
    const [min, max] = stopBounds(stops, i);
    return html`<div
      class="handle"
      part="handle"
      role="slider"
      tabindex="0"
      data-index=${i}
      aria-label=${messages.stopOf(language.number(i + 1), language.number(stops.length))}
      aria-valuemin=${Math.max(min, domain[0])}
      aria-valuemax=${Math.min(max, domain[1])}
      aria-valuenow=${value}
      aria-valuetext=${messages.stopState(language.value(value, unit), language.opacity(opacity), nameColor(color, messages))}
      aria-describedby="keys"
      ?data-chosen=${i === chosen}
      .style=${`--x: ${toShare(value, domain)}; --y: ${toHeight(opacity)}; --color: ${writeColor(color)}`}
    ></div>`;
  });
}
