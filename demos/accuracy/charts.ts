import uPlot from 'uplot';

/** A line of a chart: points with rising x. */
export interface ChartLine {
  readonly name: string;
  /** The custom property of CSS that has its colour. */
  readonly color: string;
  /** Dashes distinguish the lines where colours do not. */
  readonly dash?: readonly number[];
  readonly points: readonly (readonly [number, number])[];
}

export interface Chart {
  readonly xLabel: string;
  readonly yLabel: string;
  readonly lines: readonly ChartLine[];
  /** Read out instead of the drawing. */
  readonly description: string;
}

const height = 320;

/**
 * A chart with two logarithmic axes, as wide as its container.
 * @returns takes the chart down
 */
export function showChart(container: HTMLElement, chart: Chart): () => void {
  const joined = uPlot.join(
    chart.lines.map(({ points }): uPlot.AlignedData => [points.map(([x]) => x), points.map(([, y]) => y)]),
  );
  const make = (): uPlot => {
    const style = getComputedStyle(container);
    const narrow = container.clientWidth < 480;
    const ink = style.getPropertyValue('--soft');
    const line = style.getPropertyValue('--line');
    const axis = (label: string, size: number): uPlot.Axis => ({
      label,
      stroke: ink,
      font: '12px system-ui',
      labelFont: '13px system-ui',
      size,
      grid: { stroke: line, width: 1 },
      ticks: { stroke: line, width: 1 },
      splits: (_, __, low, high) => listSplits(low, high), // uPlot's own start at any number.
      filter: (_, splits) => splits,
      values: (_, splits) =>
        splits.map((value) => (isLabelled(value, narrow) ? String(Number(value.toPrecision(6))) : '')),
    });
    return new uPlot(
      {
        width: Math.max(240, container.clientWidth),
        height,
        scales: { x: { distr: 3, time: false, range: widen }, y: { distr: 3, range: widen } },
        axes: [axis(chart.xLabel, 40), axis(chart.yLabel, 56)],
        cursor: { drag: { x: false, y: false } },
        legend: { live: true },
        series: [
          { label: chart.xLabel, value: (_, x) => format(x) },
          ...chart.lines.map(({ name, color, dash = [] }): uPlot.Series => ({
            label: name,
            stroke: style.getPropertyValue(color),
            width: 2.5,
            dash: [...dash],
            spanGaps: true,
            points: { show: true, size: 7, fill: style.getPropertyValue(color) },
            value: (_, y) => format(y),
          })),
        ],
      },
      joined,
      container,
    );
  };
  container.replaceChildren();
  container.setAttribute('role', 'img');
  container.setAttribute('aria-label', chart.description);
  let plot = make();
  const remake = (): void => {
    plot.destroy();
    plot = make();
  };
  const observer = new ResizeObserver(() => plot.setSize({ width: Math.max(240, container.clientWidth), height }));
  observer.observe(container);
  const dark = matchMedia('(prefers-color-scheme: dark)');
  dark.addEventListener('change', remake);
  return () => {
    observer.disconnect();
    dark.removeEventListener('change', remake);
    plot.destroy();
  };
}

/** A little beyond the data, and no further. */
function widen(_: uPlot, low: number | null, high: number | null): uPlot.Range.MinMax {
  return [(low ?? 1) / 1.3, (high ?? 10) * 1.3];
}

/** One to nine times every power of ten between two numbers. */
function listSplits(low: number, high: number): number[] {
  const first = Math.floor(Math.log10(low));
  const decades = Array.from({ length: Math.ceil(Math.log10(high)) - first + 1 }, (_, i) => 10 ** (first + i));
  return decades
    .flatMap((decade) => [1, 2, 3, 4, 5, 6, 7, 8, 9].map((digit) => digit * decade))
    .filter((x) => x >= low && x <= high);
}

/** 1, 2 and 5 of each decade if there is space; all of them would overlap. */
function isLabelled(value: number, narrow: boolean): boolean {
  const leading = Number(value.toExponential(6).split('e')[0]);
  return (narrow ? [1, 3] : [1, 2, 5]).some((digit) => Math.abs(leading - digit) < 1e-3);
}

function format(value: number | null): string {
  return value === null ? '–' : String(Number(value.toPrecision(3)));
}
