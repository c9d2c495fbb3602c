// Small buttons over a picture, each at a place of the world that it moves. The elements that have handles load this module.
import type { Camera } from '../../optics/rays/camera.ts';
import { placeInElement } from '../../page/pointer-place.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import { moveByKey, placeInPlane, placeOnLine } from '../camera/drag-place.ts';
import type { Pixel, SeenPicture } from '../camera/drag-place.ts';
import { socketOf } from '../model/view-socket.ts';
import type { ViewPart } from '../model/view-socket.ts';
import { applyHandleStyles } from './handle-styles.ts';
import { projectPlace } from '../camera/project-place.ts';

/** A place that a person can move. */
export interface Handle {
  /** World. */
  readonly at: Vector3;
  /** The only direction in which it moves, of any length except zero; absent where it moves in the plane that faces the camera. */
  readonly along?: Vector3;
  /** Name of the handle, for people who do not see it. */
  readonly name: string;
  /** The place in words: a screen reader gets it when the handle has stopped. */
  readonly place: string;
  /** What the keys do, in words. */
  readonly keys: string;
  /** CSS; by default the value of `--volume-view-handle-color`. */
  readonly color?: string;
}

/** A view with a picture. */
export interface HandledView extends HTMLElement {
  readonly camera: Camera | null;
}

/** The owner of handles. */
export interface HandleOwner {
  /**
   * A person moves a handle to a place. The owner then sets all handles again, wherever it wants them.
   * @param end - whether the person has released the handle; true for each key press
   */
  moved(index: number, to: Vector3, end: boolean): void;
}

/** A screen reader gets the place of a handle that has not moved for this time, ms. */
const restMs = 500;

interface Grip {
  readonly index: number;
  readonly pointerId: number;
  readonly start: Vector3;
  /** Pixel of the place when it was grabbed, and the offset from there to the pointer. */
  readonly from: Pixel;
  readonly offset: Pixel;
}

/** Handles over a view's picture. They follow the camera; dragging them does not turn the picture. Each owner has its own. */
export class Handles implements ViewPart {
  readonly key = 'handles';
  readonly #layer: HTMLElement;
  readonly #status: HTMLElement;
  readonly #abort = new AbortController();
  #handles: readonly Handle[] = [];
  #buttons: HTMLButtonElement[] = [];
  #grip: Grip | null = null;
  #timer = 0;
  #focused = -1;

  /** @param picture - the part of the view that holds its picture; handles come after it in the focus order */
  constructor(
    readonly view: HandledView,
    picture: Element,
    readonly owner: HandleOwner,
  ) {
    const { ownerDocument: document } = view;
    this.#layer = document.createElement('div');
    this.#layer.className = 'handles';
    this.#status = document.createElement('div');
    this.#status.setAttribute('role', 'status');
    this.#status.className = 'status'; // The class of the view's own messages to screen readers.
    this.#layer.append(this.#status);
    // In the order of the Tab key, handles come in the order in which their owners were created.
    ([...picture.parentNode!.querySelectorAll('.handles')].at(-1) ?? picture).after(this.#layer);
    view.addEventListener('load', () => this.place(), { signal: this.#abort.signal });
    void socketOf(view).join(this);
  }

  dispose(): void {
    this.#abort.abort();
    void socketOf(this.view).leave(this);
    clearTimeout(this.#timer);
    this.#layer.remove();
  }

  /** Whether a person holds a handle. */
  get held(): boolean {
    return this.#grip !== null;
  }

  /** Show these handles in place of the previous ones. A handle that is held, or has the focus, keeps this state by its number. */
  set(handles: readonly Handle[]): void {
    applyHandleStyles(this.view.shadowRoot!); // Each document needs its own styles.
    while (this.#buttons.length > handles.length) this.#drop(this.#buttons.length - 1);
    this.#handles = handles;
    while (this.#buttons.length < handles.length) this.#buttons.push(this.#make(this.#buttons.length));
    handles.forEach(({ name, place, keys, color }, i) => {
      const button = this.#buttons[i];
      button.ariaLabel = place ? `${name}, ${place}` : name;
      button.ariaDescription = keys;
      if (color) button.style.setProperty('--_color', color);
      else button.style.removeProperty('--_color');
    });
    this.place();
  }

  /** Focus a handle. */
  focus(index: number): void {
    this.#buttons[index]?.focus({ preventScroll: true });
  }

  #drop(index: number): void {
    if (this.#grip?.index === index) this.#grip = null;
    this.#buttons.pop()!.remove();
  }

  #make(index: number): HTMLButtonElement {
    const button = this.view.ownerDocument.createElement('button');
    button.type = 'button';
    button.className = 'handle';
    button.setAttribute('part', 'handle');
    const { signal } = this.#abort;
    button.addEventListener('pointerdown', (event) => this.#grab(index, event), { signal });
    button.addEventListener('pointermove', (event) => this.#drag(event, false), { signal });
    for (const type of ['pointerup', 'pointercancel', 'lostpointercapture'] as const)
      button.addEventListener(type, (event) => this.#release(event), { signal });
    button.addEventListener('keydown', (event) => this.#press(index, event), { signal });
    button.addEventListener('focus', () => (this.#focused = index), { signal });
    button.addEventListener('blur', () => (this.#focused = -1), { signal });
    this.#layer.insertBefore(button, this.#status);
    return button;
  }

  get #picture(): SeenPicture | null {
    const { camera, clientWidth: width, clientHeight: height } = this.view;
    return camera && width > 0 && height > 0 ? { camera, width, height } : null;
  }

  /** Move all handles to where the camera shows their places. */
  place(): void {
    const picture = this.#picture;
    this.#handles.forEach(({ at }, i) => {
      const pixel = picture && projectPlace(picture.camera, at, picture);
      const { style } = this.#buttons[i];
      // A held handle may be dragged out of the picture; if it were hidden, it would lose the pointer.
      style.visibility = pixel && (isInside(pixel, picture) || this.#grip?.index === i) ? 'visible' : 'hidden';
      if (pixel) [style.left, style.top] = pixel.map((length) => `${length.toFixed(2)}px`);
    });
  }

  #grab(index: number, event: PointerEvent): void {
    const picture = this.#picture;
    if (event.button !== 0 || this.#grip || !picture) return;
    const { at } = this.#handles[index];
    const from = projectPlace(picture.camera, at, picture);
    if (!from) return;
    const pointer = placeInElement(this.view, event);
    this.#grip = {
      index,
      pointerId: event.pointerId,
      start: at,
      from,
      offset: [pointer[0] - from[0], pointer[1] - from[1]],
    };
    const button = this.#buttons[index];
    button.setPointerCapture(event.pointerId);
    button.focus({ preventScroll: true }); // Safari does not focus buttons on its own.
    event.preventDefault();
  }

  #drag(event: PointerEvent, end: boolean): void {
    const [grip, picture] = [this.#grip, this.#picture];
    if (!grip || !picture || grip.pointerId !== event.pointerId) return;
    const { index, start, from, offset } = grip;
    const pointer = placeInElement(this.view, event);
    const to: Pixel = [pointer[0] - offset[0], pointer[1] - offset[1]];
    const { along } = this.#handles[index];
    this.#move(
      index,
      along ? placeOnLine(picture, { through: start, direction: along, from }, to) : placeInPlane(picture, start, to),
      end,
    );
  }

  #release(event: PointerEvent): void {
    const grip = this.#grip;
    if (!grip || grip.pointerId !== event.pointerId) return;
    // The system takes the touch for another gesture: undo the drag.
    if (event.type === 'pointercancel') this.#move(grip.index, grip.start, true);
    else if (event.type === 'pointerup') this.#drag(event, true);
    this.#grip = null;
    this.place();
  }

  #press(index: number, event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const [picture, grip] = [this.#picture, this.#grip];
    if (event.key === 'Escape' && grip) {
      this.#grip = null;
      this.#move(grip.index, grip.start, true);
    } else {
      const { at, along } = this.#handles[index];
      const to = picture && moveByKey(picture, at, event, along);
      if (!to) return;
      // Outside the picture, nobody could bring the handle back.
      const pixel = projectPlace(picture.camera, to, picture);
      if (pixel && isInside(pixel, picture)) this.#move(index, to, true);
    }
    event.preventDefault();
    event.stopPropagation();
  }

  #move(index: number, to: Vector3, end: boolean): void {
    if (!to.every(Number.isFinite)) return;
    this.owner.moved(index, to, end);
    clearTimeout(this.#timer);
    this.#timer = window.setTimeout(
      () => (this.#status.textContent = this.#handles[this.#focused]?.place ?? ''),
      restMs,
    );
  }
}

function isInside([x, y]: Pixel, { width, height }: SeenPicture): boolean {
  return x >= 0 && y >= 0 && x <= width && y <= height;
}
