/** Less than this is a click, CSS pixels. */
const slop = 3;

/** After a drag the menu is asked for at once, if at all, ms. */
const soon = 200;

/**
 * The right button of a mouse, which drags, or else asks for the context menu. Windows asks for it with the release: then a
 * drag drops it. Other systems ask with the press: then it is held back, and asked for anew on release, so that a menu of the
 * page's own opens; the browser's own can't be opened by a script, and is there with Shift.
 */
export class RightButton {
  #from: { x: number; y: number } | null = null;
  #dragged = false;
  #draggedAt = -Infinity;
  #held: MouseEvent | null = null;

  constructor(readonly target: Element, signal: AbortSignal) {
    window.addEventListener('contextmenu', (event) => this.#menu(event), { capture: true, signal });
  }

  press({ clientX, clientY }: PointerEvent): void {
    this.#from = { x: clientX, y: clientY };
    this.#dragged = false;
    this.#held = null;
  }

  /** Whether a press is no click any more. Without a press of the right button there is nothing to wait for. */
  drags({ clientX, clientY }: PointerEvent): boolean {
    const { x, y } = this.#from ?? { x: Infinity, y: Infinity };
    this.#dragged ||= Math.hypot(clientX - x, clientY - y) > slop;
    return this.#dragged;
  }

  release({ type, timeStamp }: PointerEvent): void {
    if (!this.#from) return;
    this.#from = null;
    if (this.#dragged) this.#draggedAt = timeStamp;
    else if (this.#held && type === 'pointerup') this.target.dispatchEvent(new MouseEvent('contextmenu', this.#held));
  }

  #menu(event: MouseEvent): void {
    if (!event.isTrusted) return;
    if (this.#from) this.#held = event;
    else if (event.timeStamp - this.#draggedAt > soon) return;
    event.preventDefault();
    event.stopImmediatePropagation();
  }
}
