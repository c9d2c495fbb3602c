import { placeInElement } from '../page/pointer-place.ts';
import type { PagePoint } from '../page/pointer-place.ts';

/** A point of a chart: 0..1 of its width and, from below, height. */
export interface ChartPlace {
  readonly share: number;
  readonly height: number;
}

/** The point of a chart, inside its border, at which a pointer is. */
export function shareOfChart(chart: HTMLElement, point: PagePoint): ChartPlace {
  const [x, y] = placeInElement(chart, point);
  return { share: x / chart.clientWidth, height: 1 - y / chart.clientHeight };
}
