import { placeInElement } from '../page/pointer-place.ts';
import type { PagePoint } from '../page/pointer-place.ts';

/** A place of a chart, each 0..1 of its width and, from below, height. */
export interface ChartPlace {
  readonly share: number;
  readonly height: number;
}

/** Where in a chart, within its border, a pointer is. */
export function shareOfChart(chart: HTMLElement, point: PagePoint): ChartPlace {
  const [x, y] = placeInElement(chart, point);
  return { share: x / chart.clientWidth, height: 1 - y / chart.clientHeight };
}
