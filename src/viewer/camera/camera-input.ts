import { pressKey } from './camera-keys.ts';
import { canZoom, pan, placeIn, rotate, zoomAt, zoomFrom } from './camera-moves.ts';
import type { CameraRig, Pose } from './camera-rig.ts';
import { RightButton } from './right-button.ts';

/** A drag across the element's height turns the camera by this angle, radians. */
const turnPerHeight = Math.PI * 1.2;

/** Wheel pixels that double the distance. */
const wheelPixelsPerDoubling = 600;

/** The same for two fingers on a trackpad, which browsers report as a wheel with Ctrl: 100 pixels are a factor of e. */
const pinchPixelsPerDoubling = 100 * Math.LN2;

/** The maximum for a pinch in one event. One notch of a real wheel while Ctrl is held is 100 pixels or more. */
const maxPinchPixels = 25;

/** Wheel lines and pages in pixels. */
const wheelUnits: readonly number[] = [1, 16, 400];

/**
 * A finger turns the picture after this many CSS pixels, across and along the direction in which it may scroll the page: the
 * browser needs some pixels to detect scrolling, and nothing should move meanwhile.
 */
const fingerSlop = { across: 6, along: 32 };

/** A gesture of two fingers on a trackpad, as Safari reports it. */
type GestureEvent = MouseEvent & { readonly scale: number };

type Place = readonly [x: number, y: number];

/**
 * Turns mouse, touch and keyboard input on an element into movements of a camera. The page can still scroll: the wheel zooms only
 * after a press on the element or with Ctrl or Meta, and scrolls the page again where it can't zoom further; a finger that starts
 * up or down scrolls (CSS touch-action).
 */
export class CameraInput {
  /** The place of each finger or button in the picture. */
  readonly #pointers = new Map<number, Place>();
  readonly #abort = new AbortController();
  readonly #rightButton: RightButton;
  #pans = false;
  /** Where a single finger was put down that has not turned the picture yet. */
  #resting: { readonly x: number; readonly y: number } | null = null;
  /** The camera's goal before the first pointer was put down. */
  #before: { readonly goal: Pose; readonly touched: boolean } | null = null;
  #engaged = false;

  /**
   * @param changed - called after each movement
   * @param reset - called when the person wants the first view back
   */
  constructor(
    readonly target: HTMLElement,
    readonly rig: CameraRig,
    readonly actions: { changed: () => void; reset: () => void },
  ) {
    const { signal } = this.#abort;
    this.#rightButton = new RightButton(target, signal);
    const listen = <Name extends keyof HTMLElementEventMap>(
      name: Name,
      act: (event: HTMLElementEventMap[Name]) => void,
    ): void => target.addEventListener(name, act, { signal, passive: false });
    listen('pointerdown', (event) => this.#press(event));
    listen('pointermove', (event) => this.#move(event));
    for (const name of ['pointerup', 'pointercancel', 'lostpointercapture'] as const)
      listen(name, (event) => this.#release(event));
    listen('mousedown', (event) => this.#keepFromScrolling(event));
    // With two fingers the page does not scroll, in whichever direction they move.
    listen('touchmove', (event) => event.touches.length > 1 && event.cancelable && event.preventDefault());
    listen('wheel', (event) => this.#wheel(event));
    listen('keydown', (event) => this.#key(event));
    listen('dblclick', () => actions.reset());
    listen('blur', () => (this.#engaged = false));
    listen('pointerleave', () => this.#leave());
    this.#listenToGestures(signal);
  }

  dispose(): void {
    this.#abort.abort();
  }

  #press(event: PointerEvent): void {
    const { button, shiftKey, pointerId, pointerType, clientX: x, clientY: y } = event;
    // The browser handles the right button with Shift, and all buttons after the third.
    if (button > 2 || (button === 2 && shiftKey)) return;
    this.#engaged = true;
    if (this.#pointers.size === 0) {
      this.#before = { goal: this.rig.goal, touched: this.rig.touched };
      this.#pans = button > 0 || shiftKey;
    }
    this.#resting = pointerType === 'touch' && this.#pointers.size === 0 ? { x, y } : null;
    if (button === 2) this.#rightButton.press(event);
    this.#pointers.set(pointerId, placeIn(this.target, event));
    this.target.setPointerCapture(pointerId);
  }

  #move(event: PointerEvent): void {
    const last = this.#pointers.get(event.pointerId);
    if (!last || (event.buttons & 2 && !this.#rightButton.drags(event))) return;
    const now = placeIn(this.target, event);
    const by: Place = [now[0] - last[0], now[1] - last[1]];
    if (by[0] === 0 && by[1] === 0) return;
    this.#pointers.set(event.pointerId, now);
    if (this.#rests(event)) return;
    const other = [...this.#pointers].find(([id]) => id !== event.pointerId)?.[1];
    if (other) this.#pinch(last, now, other);
    else if (this.#pans) pan(this.rig, by);
    else rotate(this.rig, (-by[0] * turnPerHeight) / 2, (by[1] * turnPerHeight) / 2);
    this.actions.changed();
  }

  #rests({ clientX, clientY }: PointerEvent): boolean {
    if (!this.#resting) return false;
    const [across, along] = [Math.abs(clientX - this.#resting.x), Math.abs(clientY - this.#resting.y)];
    if (Math.max(across, along) < (along > across ? fingerSlop.along : fingerSlop.across)) return true;
    this.#resting = null;
    return false;
  }

  /** One of two fingers has moved: the place between them follows. */
  #pinch(last: Place, now: Place, other: Place): void {
    const [before, after] = [last, now].map(([x, y]) => Math.hypot(x - other[0], y - other[1]));
    pan(this.rig, [(now[0] - last[0]) / 2, (now[1] - last[1]) / 2]);
    if (before > 0 && after > 0) zoomAt(this.rig, before / after, [(now[0] + other[0]) / 2, (now[1] + other[1]) / 2]);
  }

  #release(event: PointerEvent): void {
    if (!this.#pointers.delete(event.pointerId)) return;
    this.#rightButton.release(event);
    // The page scrolls instead, or the system uses the touch: undo the movement of the camera.
    if (event.type === 'pointercancel' && this.#before) {
      this.rig.aim(this.#before.goal, this.#before.touched);
      this.actions.changed();
    }
  }

  #leave(): void {
    // After the mouse has left the picture, the wheel must scroll the page again.
    if (this.#pointers.size === 0) this.#engaged = false;
  }

  /** Browsers scroll with the middle button: prevent that. */
  #keepFromScrolling(event: MouseEvent): void {
    if (event.button !== 1) return;
    event.preventDefault();
    this.target.focus({ preventScroll: true });
  }

  #wheel(event: WheelEvent): void {
    const zooms = event.ctrlKey || event.metaKey;
    if (!zooms && (!this.#engaged || !event.cancelable)) return;
    const pixels = event.deltaY * wheelUnits[event.deltaMode];
    const doublings = event.ctrlKey
      ? Math.min(maxPinchPixels, Math.max(-maxPinchPixels, pixels)) / pinchPixelsPerDoubling
      : pixels / wheelPixelsPerDoubling;
    // At the limit the page scrolls again. With Ctrl, as for a pinch on a trackpad, browsers would zoom the page: that is
    // prevented.
    if (!zooms && pixels !== 0 && !canZoom(this.rig, 2 ** doublings)) return;
    event.preventDefault();
    zoomFrom(this.rig, 2 ** doublings, placeIn(this.target, event));
    this.actions.changed();
  }

  /** Safari on a Mac reports a pinch on the trackpad by events of its own; on a phone, fingers are also reported as pointers. */
  #listenToGestures(signal: AbortSignal): void {
    let last = 1;
    for (const name of ['gesturestart', 'gesturechange']) {
      this.target.addEventListener(
        name,
        (event) => {
          event.preventDefault();
          const { scale } = event as GestureEvent;
          if (name === 'gesturechange' && this.#pointers.size === 0) {
            zoomAt(this.rig, last / scale, placeIn(this.target, event as GestureEvent));
            this.actions.changed();
          }
          last = scale;
        },
        { signal },
      );
    }
  }

  #key(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (!pressKey(event, this.rig, () => this.actions.reset())) return;
    event.preventDefault();
    this.actions.changed();
  }
}
