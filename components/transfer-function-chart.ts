// The editor's chart: how often which values occur, the curve, and the handles of its stops.
import { html, nothing, svg } from 'lit';
import type { TransferFunction } from '../src/optics/transfer-function.ts';
import { writeColor } from '../src/optics/write-transfer-function.ts';
import type { Histogram } from '../src/volume/histogram.ts';
import { nameColor } from '../src/editor/color-names.ts';
import { formatNumber, formatOpacity, formatValue, labelShift, listTicks } from '../src/editor/ticks.ts';
import { opacityTicks, toHeight, toShare } from '../src/editor/transfer-function-axes.ts';
import { stopBounds } from '../src/editor/transfer-function-edits.ts';
import { boxHeight, boxLength, drawArea, drawCurve, paintStops, renderGradientStops } from './transfer-function-paint.ts';

/** What a chart shows. */
export interface Chart {
  readonly histogram: Histogram;
  /** Data values at its left and right edge. */
  readonly domain: readonly [number, number];
  readonly stops: TransferFunction;
  readonly unit: string;
}

/** Labels below the chart; as many as a narrow phone has room for. */
const maxTicks = 6;

/** Binomial weights of a bar and two neighbours on either side. */
const kernel = [1 / 16, 4 / 16, 6 / 16, 4 / 16, 1 / 16];

/** The chart with its scales and the opaque colours. It is decoration to those who hear the handles read. */
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

/** The numbers of the upward axis. */
export function renderOpacityScale(): unknown {
  return html`<div class="opacities" aria-hidden="true">
    ${opacityTicks.map((opacity) => html`<span .style=${`--y: ${toHeight(opacity)}`}>${formatNumber(opacity * 100)} %</span>`)}
  </div>`;
}

/** The numbers of the axis across; the last of them has the unit. */
function renderValueScale({ domain, unit }: Chart): unknown {
  const ticks = listTicks(domain, maxTicks);
  return html`<div class="values" aria-hidden="true">
    ${ticks.map((tick, i) => html`<span .style=${placeLabel(toShare(tick, domain))}
      >${formatNumber(tick)}${unit && i === ticks.length - 1 ? html`<small>${unit}</small>` : nothing}</span>`)}
  </div>`;
}

/** The opaque colours along the value axis, in the picture's gradient. */
function renderStrip(): unknown {
  return html`<svg part="strip" class="strip" viewBox="0 0 ${boxLength} 1" preserveAspectRatio="none" aria-hidden="true">
    <path fill="url(#colors)" d="M0 0H${boxLength}V1H0Z"></path>
  </svg>`;
}

const placeLabel = (share: number): string => `--x: ${share}; --shift: ${labelShift(share)}`;

/** A handle for every stop, in the order of their values. */
export function renderHandles({ domain, stops, unit }: Chart, chosen: number): unknown {
  return stops.map((stop, i) => {
    const { value, opacity, color } = stop;
    const [least, most] = stopBounds(stops, i);
    return html`<div
      class="handle"
      part="handle"
      role="slider"
      tabindex="0"
      data-index=${i}
      aria-label="Stop ${i + 1} of ${stops.length}"
      aria-valuemin=${Math.max(least, domain[0])}
      aria-valuemax=${Math.min(most, domain[1])}
      aria-valuenow=${value}
      aria-valuetext="${formatValue(value, unit)}, opacity ${formatOpacity(opacity)}, ${nameColor(color)}"
      aria-describedby="keys"
      ?data-chosen=${i === chosen}
      .style=${`--x: ${toShare(value, domain)}; --y: ${toHeight(opacity)}; --color: ${writeColor(color)}`}
    ></div>`;
  });
}

/**
 * Bars without gaps, on a logarithmic scale of counts: air and nothing are most of every volume. Each is mixed with its
 * neighbours, as whole numbers in bins that are not whole numbers wide make a comb.
 */
function drawHistogram({ low, high, counts }: Histogram, domain: readonly [number, number]): string {
  if (!(high > low)) return '';
  const binWidth = (high - low) / counts.length;
  const place = (value: number) => Math.min(boxLength, Math.max(0, toShare(value, domain) * boxLength)).toFixed(2);
  const smooth = Array.from(counts, (_, i) => kernel.reduce((sum, weight, k) => sum + weight * (counts[i + k - 2] ?? 0), 0));
  const top = Math.log1p(Math.max(...smooth));
  const bars = smooth.map((count, i) => `V${(boxHeight * (1 - (0.92 * Math.log1p(count)) / top)).toFixed(2)}H${place(low + (i + 1) * binWidth)}`);
  return `M${place(low)} ${boxHeight}${bars.join('')}V${boxHeight}Z`;
}
