/** A shorter movement than this is a click, CSS pixels. */
const slop = 3;

/** After a drag, the system requests the context menu within this time, if at all, ms. */
const soon = 200;

/**
 * The right button of a mouse: it drags, or opens the context menu. Windows requests the menu at the release: after a drag that
 * request is dropped. Other systems request it at the press: the request is held back, and sent again at the release, so that the
 * page's own menu opens; a script can't open the browser's menu, which needs Shift.
 */
export class RightButton {
  #from: { x: number; y: number } | null = null;
  #dragged = false;
  #draggedAt = -Infinity;
  #held: MouseEvent | null = null;

  constructor(
    readonly target: Element,
    signal: AbortSignal,
  ) {
    window.addEventListener('contextmenu', (event) => this.#menu(event), { capture: true, signal });
  }

  press({ clientX, clientY }: PointerEvent): void {
    this.#from = { x: clientX, y: clientY };
    this.#dragged = false;
    this.#held = null;
  }

  /** Whether a press is now a drag, not a click. Without a press of the right button it is one at once. */
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
