import { shareOfChart } from './share-of-chart.ts';
import type { ChartPlace } from './share-of-chart.ts';
import { lowestHeight, toHeight, toOpacity, toShare, toValue } from './transfer-function-axes.ts';

/** Receives what pointers and keys on the chart do. */
export interface StopInputListener {
  /** Positions of the handles: 0..1 of the chart's width and, from below, height. */
  handles(): readonly ChartPlace[];
  choose(index: number): void;
  /** Drags a handle to a point of the chart, 0..1 each. */
  drag(index: number, share: number, height: number): void;
  /** A drag has ended. */
  drop(): void;
  add(share: number, height: number): void;
}

/** Maximum distance at which a pointer still takes a handle, CSS pixels: a fingertip is wider than a mouse's point. */
const reach = { mouse: 16, touch: 26 };

/** Two taps within this time and this distance are a double tap. */
const doubleTap = { milliseconds: 400, pixels: 24 };

/**
 * Mouse, finger and pen on the chart: a press takes the nearest handle and drags it, a double tap elsewhere adds a
 * stop. Its `down`, `move` and `up` are listeners of the chart's own element, and `keepFocus` of its mousedown.
 */
export class StopInput {
  #dragged = -1;
  /** From the pointer to the dragged handle, so that a handle does not jump when it is taken by its edge. */
  #offset = { share: 0, height: 0 };
  #moved = false;
  #lastTap = { time: -Infinity, x: 0, y: 0 };

  constructor(readonly listener: StopInputListener) {}

  readonly down = (event: PointerEvent): void => {
    if (event.button !== 0 || !event.isPrimary) return;
    const chart = event.currentTarget as HTMLElement;
    const place = shareOfChart(chart, event);
    const index = this.#findHandle(chart, event, place);
    if (index < 0) return this.#tap(event, place);
    const handle = this.listener.handles()[index];
    this.#dragged = index;
    this.#moved = false;
    this.#offset = { share: handle.share - place.share, height: handle.height - place.height };
    chart.setPointerCapture(event.pointerId);
    this.listener.choose(index);
  };

  readonly move = (event: PointerEvent): void => {
    if (this.#dragged < 0 || !event.isPrimary) return;
    const { share, height } = shareOfChart(event.currentTarget as HTMLElement, event);
    this.#moved = true;
    this.listener.drag(this.#dragged, share + this.#offset.share, height + this.#offset.height);
  };

  readonly up = (event: PointerEvent): void => {
    if (this.#dragged < 0 || !event.isPrimary) return;
    this.#dragged = -1;
    if (this.#moved) this.listener.drop();
  };

  /** Prevents a browser's default action after a press: it would move the focus, and select text. */
  readonly keepFocus = (event: MouseEvent): void => event.preventDefault();

  #tap({ timeStamp, clientX, clientY }: PointerEvent, { share, height }: ChartPlace): void {
    const { time, x, y } = this.#lastTap;
    const isSecond =
      timeStamp - time < doubleTap.milliseconds && Math.hypot(clientX - x, clientY - y) < doubleTap.pixels;
    this.#lastTap = isSecond ? { time: -Infinity, x: 0, y: 0 } : { time: timeStamp, x: clientX, y: clientY };
    if (isSecond) this.listener.add(share, height);
  }

  /** The handle that is nearest to a pointer, if one is near; of several at one point the last, which lies on top. */
  #findHandle(chart: HTMLElement, event: PointerEvent, { share, height }: ChartPlace): number {
    const { clientWidth, clientHeight } = chart;
    let nearest = event.pointerType === 'mouse' ? reach.mouse : reach.touch;
    let index = -1;
    this.listener.handles().forEach((handle, i) => {
      const distance = Math.hypot((handle.share - share) * clientWidth, (handle.height - height) * clientHeight);
      if (distance <= nearest) [nearest, index] = [distance, i];
    });
    return index;
  }
}

/** The share of the chart by which an arrow key moves a stop. */
const keyStep = 0.01;

/**
 * Where an arrow key moves a stop: across by a hundredth of the chart, up and down by a hundredth of its height, with
 * Shift by ten; Home and End as far as the neighbours allow.
 * @returns null for any other key
 */
export function moveByKey(
  { key, shiftKey }: KeyboardEvent,
  { value, opacity }: { value: number; opacity: number },
  domain: readonly [number, number],
): { value?: number; opacity?: number } | null {
  const step = keyStep * (shiftKey ? 10 : 1);
  const across = (by: number) => ({ value: toValue(toShare(value, domain) + by, domain) });
  const upward = (by: number) => ({ opacity: toOpacity(toHeight(opacity) + by) });
  switch (key) {
    case 'ArrowLeft':
      return across(-step);
    case 'ArrowRight':
      return across(step);
    case 'ArrowUp':
      return upward(opacity === 0 ? Math.max(step, lowestHeight) : step);
    case 'ArrowDown':
      return upward(-step);
    case 'Home':
      return { value: domain[0] };
    case 'End':
      return { value: domain[1] };
    default:
      return null;
  }
}
