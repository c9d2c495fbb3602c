import type { CameraRig } from './camera-rig.ts';

/** A drag across the element's height turns the camera by this much, radians. */
const turnPerHeight = Math.PI * 1.2;

/** One press of an arrow key, radians. */
const turnPerKey = Math.PI / 24;

const zoomPerKey = 1.1;

/** Wheel pixels that double the distance. */
const wheelPixelsPerDoubling = 600;

/** Wheel lines and pages in pixels. */
const wheelUnits: readonly number[] = [1, 16, 400];

/**
 * Mouse, touch and keyboard on an element, as movements of a camera. The page keeps scrolling: the wheel zooms only
 * after a press on the element or with Ctrl or Meta, and a finger that starts up or down scrolls (CSS touch-action).
 */
export class CameraInput {
  readonly #pointers = new Map<number, { x: number; y: number }>();
  readonly #abort = new AbortController();
  #engaged = false;

  /**
   * @param changed - called after each movement
   * @param reset - called when the person asks for the first view
   */
  constructor(
    readonly target: HTMLElement,
    readonly rig: CameraRig,
    readonly actions: { changed: () => void; reset: () => void },
  ) {
    const options = { signal: this.#abort.signal };
    target.addEventListener('pointerdown', (event) => this.#press(event), options);
    target.addEventListener('pointermove', (event) => this.#move(event), options);
    for (const name of ['pointerup', 'pointercancel'] as const) {
      target.addEventListener(name, (event) => this.#release(event), options);
    }
    target.addEventListener('wheel', (event) => this.#wheel(event), { ...options, passive: false });
    target.addEventListener('keydown', (event) => this.#key(event), options);
    target.addEventListener('dblclick', () => actions.reset(), options);
    target.addEventListener('blur', () => (this.#engaged = false), options);
    target.addEventListener('pointerleave', () => this.#leave(), options);
  }

  dispose(): void {
    this.#abort.abort();
  }

  #press(event: PointerEvent): void {
    if (event.button !== 0) return;
    this.#engaged = true;
    this.#pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    this.target.setPointerCapture(event.pointerId);
  }

  #move(event: PointerEvent): void {
    const last = this.#pointers.get(event.pointerId);
    if (!last) return;
    const now = { x: event.clientX, y: event.clientY };
    if (this.#pointers.size === 2) this.#pinch(event.pointerId, last, now);
    else this.#turn(now.x - last.x, now.y - last.y);
    this.#pointers.set(event.pointerId, now);
  }

  #turn(dx: number, dy: number): void {
    if (dx === 0 && dy === 0) return;
    const perPixel = turnPerHeight / Math.max(1, this.target.clientHeight);
    this.rig.rotate(-dx * perPixel, -dy * perPixel);
    this.actions.changed();
  }

  #pinch(moved: number, last: { x: number; y: number }, now: { x: number; y: number }): void {
    for (const [id, other] of this.#pointers) {
      if (id === moved) continue;
      const before = Math.hypot(last.x - other.x, last.y - other.y);
      const after = Math.hypot(now.x - other.x, now.y - other.y);
      if (before > 0 && after > 0) this.rig.zoom(before / after);
    }
    this.actions.changed();
  }

  #release(event: PointerEvent): void {
    this.#pointers.delete(event.pointerId);
  }

  #leave(): void {
    // The wheel must scroll the page again once the mouse has been elsewhere.
    if (this.#pointers.size === 0) this.#engaged = false;
  }

  #wheel(event: WheelEvent): void {
    if (!this.#engaged && !event.ctrlKey && !event.metaKey) return;
    event.preventDefault();
    this.rig.zoom(2 ** ((event.deltaY * wheelUnits[event.deltaMode]) / wheelPixelsPerDoubling));
    this.actions.changed();
  }

  #key(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const act = keys[event.key];
    if (!act) return;
    event.preventDefault();
    if (act === 'reset') return this.actions.reset();
    act(this.rig);
    this.actions.changed();
  }
}

/** The arrows turn the volume their way, as dragging does. */
const keys: Readonly<Record<string, ((rig: CameraRig) => void) | 'reset'>> = {
  ArrowLeft: (rig) => rig.rotate(turnPerKey, 0),
  ArrowRight: (rig) => rig.rotate(-turnPerKey, 0),
  ArrowUp: (rig) => rig.rotate(0, turnPerKey),
  ArrowDown: (rig) => rig.rotate(0, -turnPerKey),
  '+': (rig) => rig.zoom(1 / zoomPerKey),
  '=': (rig) => rig.zoom(1 / zoomPerKey),
  PageUp: (rig) => rig.zoom(1 / zoomPerKey),
  '-': (rig) => rig.zoom(zoomPerKey),
  _: (rig) => rig.zoom(zoomPerKey),
  PageDown: (rig) => rig.zoom(zoomPerKey),
  '0': 'reset',
  Home: 'reset',
};
