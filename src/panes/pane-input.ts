import { placeInElement } from '../page/pointer-place.ts';
import type { Vector3 } from '../volume/matrix.ts';
import type { SlicePane } from './slice-pane.ts';

/** What a drag with the first button does; the right button does the other. */
export const dragKinds = ['cursor', 'window'] as const;
export type DragKind = (typeof dragKinds)[number];

/** Wheel pixels for one slice, for twice the size, and for twice the size by pinching on a trackpad. */
const wheelPixels = { slice: 60, doubling: 300, pinchDoubling: 70 };

/** Pixels per wheel unit: pixel, line and page. */
const wheelUnits: readonly number[] = [1, 16, 400];

/** The factor of one press of plus. */
const zoomPerKey = 1.25;

const arrows: Readonly<Record<string, readonly [right: number, up: number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

type Point = readonly [x: number, y: number];
type Drag = DragKind | 'pan';

/** Receives what the user does. The pane itself does not know who listens. */
export interface PaneInteraction {
  readonly drag: () => DragKind;
  /** The frame has changed. Crosshair and window report their own changes. */
  readonly moved: () => void;
}

/**
 * Mouse, fingers and keys on a pane. The first button moves the crosshair, the right one the window, the middle one, or
 * Shift, the picture. After a press, the wheel goes through the slices, and scrolls the page at the last one; with Ctrl
 * it zooms. Two fingers zoom and move. A finger that goes up or down scrolls the page (CSS touch-action).
 */
export class PaneInput {
  readonly #abort = new AbortController();
  readonly #pointers = new Map<number, Point>();
  #drag: Drag | null = null;
  #window: readonly [number, number] = [0, 1];
  #from: Point = [0, 0];
  #engaged = false;
  #wheeled = 0;
  /** Where the crosshair was before the last press, and before the first press of a possible double click. */
  #places: { readonly press: Vector3; readonly click: Vector3 } | null = null;

  constructor(
    readonly target: HTMLElement,
    readonly pane: SlicePane,
    readonly interaction: PaneInteraction,
  ) {
    const { signal } = this.#abort;
    const listen = <Name extends keyof HTMLElementEventMap>(
      name: Name,
      act: (event: HTMLElementEventMap[Name]) => void,
    ): void => target.addEventListener(name, act, { signal, passive: false });
    listen('pointerdown', (event) => this.#press(event));
    listen('pointermove', (event) => this.#move(event));
    for (const name of ['pointerup', 'pointercancel', 'lostpointercapture'] as const)
      listen(name, (event) => this.#release(event));
    listen('contextmenu', (event) => event.shiftKey || event.preventDefault());
    listen('mousedown', (event) => {
      if (event.detail < 2 && this.#places) this.#places = { ...this.#places, click: this.#places.press };
      this.#keepFromScrolling(event);
    });
    listen('touchmove', (event) => event.touches.length > 1 && event.cancelable && event.preventDefault());
    listen('wheel', (event) => this.#wheel(event));
    listen('keydown', (event) => this.#key(event));
    listen('dblclick', () => {
      this.#reset();
      this.#unpoint();
    });
    listen('blur', () => (this.#engaged = false));
    listen('pointerleave', () => (this.#engaged = this.#engaged && this.#pointers.size > 0));
  }

  dispose(): void {
    this.#abort.abort();
  }

  #press(event: PointerEvent): void {
    const { button, shiftKey, pointerId, pointerType } = event;
    if (button > 2 || (button === 2 && shiftKey)) return;
    this.#engaged = true;
    const point = this.#pointOf(event);
    this.#places = { press: this.pane.place, click: this.#places?.click ?? this.pane.place };
    if (this.#pointers.size === 0) {
      const first = this.interaction.drag();
      this.#drag = button === 1 || shiftKey ? 'pan' : button === 0 ? first : first === 'cursor' ? 'window' : 'cursor';
      this.#from = point;
      this.#window = this.pane.window;
      // A finger may be about to scroll the page: it sets the crosshair only when it moves sideways, or is lifted.
      if (this.#drag === 'cursor' && pointerType !== 'touch') this.pane.pointTo(point);
    }
    this.#pointers.set(pointerId, point);
    this.target.setPointerCapture(pointerId);
  }

  #move(event: PointerEvent): void {
    const last = this.#pointers.get(event.pointerId);
    if (!last) return;
    const now = this.#pointOf(event);
    const by: Point = [now[0] - last[0], now[1] - last[1]];
    if (by[0] === 0 && by[1] === 0) return;
    this.#pointers.set(event.pointerId, now);
    const other = [...this.#pointers].find(([id]) => id !== event.pointerId)?.[1];
    if (other) return this.#pinch(last, now, other);
    if (this.#drag === 'window') this.pane.windowBy(this.#window, [now[0] - this.#from[0], now[1] - this.#from[1]]);
    else if (this.#drag === 'cursor') this.pane.pointTo(now);
    else if (this.#drag === 'pan') {
      this.pane.pan(by);
      this.interaction.moved();
    }
  }

  /** One of two fingers has moved: the picture follows. */
  #pinch(last: Point, now: Point, other: Point): void {
    this.#drag = null; // A drag that one of the fingers began has ended.
    const [before, after] = [last, now].map(([x, y]) => Math.hypot(x - other[0], y - other[1]));
    this.pane.pan([(now[0] - last[0]) / 2, (now[1] - last[1]) / 2]);
    if (before > 0 && after > 0) this.pane.zoom(after / before, [(now[0] + other[0]) / 2, (now[1] + other[1]) / 2]);
    this.interaction.moved();
  }

  #release(event: PointerEvent): void {
    if (!this.#pointers.delete(event.pointerId)) return;
    if (this.#drag === 'cursor' && event.type === 'pointerup' && event.pointerType === 'touch')
      this.pane.pointTo(this.#pointOf(event));
    if (this.#pointers.size === 0) this.#drag = null;
  }

  #keepFromScrolling(event: MouseEvent): void {
    if (event.button !== 1) return;
    event.preventDefault();
    this.target.focus({ preventScroll: true });
  }

  #wheel(event: WheelEvent): void {
    const zooms = event.ctrlKey || event.metaKey;
    const pixels = event.deltaY * wheelUnits[event.deltaMode];
    // After the last slice the wheel scrolls the page again.
    if (!zooms && (!this.#engaged || !event.cancelable || !this.pane.hasSlices(-Math.sign(pixels))))
      return void (this.#wheeled = 0);
    event.preventDefault();
    if (zooms) {
      const doubling = event.ctrlKey && Math.abs(pixels) < 25 ? wheelPixels.pinchDoubling : wheelPixels.doubling;
      this.pane.zoom(2 ** (-pixels / doubling), this.#pointOf(event));
      return this.interaction.moved();
    }
    // A wheel gives a hundred pixels at once, a trackpad a few at a time.
    this.#wheeled += pixels;
    const slices = Math.trunc(this.#wheeled / wheelPixels.slice);
    this.#wheeled -= slices * wheelPixels.slice;
    if (slices !== 0) this.pane.stepBy(0, 0, -slices);
  }

  #key(event: KeyboardEvent): void {
    const { key, shiftKey } = event;
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const { pane } = this;
    const many = shiftKey ? 10 : 1;
    const middle: Point = [pane.size.width / 2, pane.size.height / 2];
    const zoom = (factor: number): void => {
      pane.zoom(factor, middle);
      this.interaction.moved();
    };
    if (Object.hasOwn(arrows, key)) pane.stepBy(arrows[key][0] * many, arrows[key][1] * many, 0);
    else if (key === 'PageUp') pane.stepBy(0, 0, many);
    else if (key === 'PageDown') pane.stepBy(0, 0, -many);
    else if (key === 'Home') pane.goTo(pane.ends[0]);
    else if (key === 'End') pane.goTo(pane.ends[1]);
    else if (key === '+' || key === '=') zoom(zoomPerKey);
    else if (key === '-' || key === '_') zoom(1 / zoomPerKey);
    else if (key === '0') this.#reset();
    else return;
    event.preventDefault();
  }

  #reset(): void {
    this.pane.reset();
    this.interaction.moved();
  }

  /** Undoes the first click of a double click, which moved the crosshair: the user only wants to see the whole volume. */
  #unpoint(): void {
    const before = this.#places?.click;
    if (before && String(before) !== String(this.pane.place)) this.pane.crosshair.moveTo(before);
  }

  #pointOf(event: MouseEvent): Point {
    return placeInElement(this.target, event);
  }
}
