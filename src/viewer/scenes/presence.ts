import type { PageWatcher } from './page-watcher.ts';

/** How far beyond the visible part of the page an element is still near it: in screens, up, down and to the sides. */
const nearMargin = '50%';

/** How near an element is to what a person sees of the page, whether a hand is on it, and whether a script waits for it. */
export class Presence {
  #near = false;
  /** Whether it is known where the element is. */
  #isPlaced = false;
  #inSight = false;
  #hovered = false;
  #focused = false;
  #asks = 0;

  /** @param changed - called whenever one of these may be otherwise */
  constructor(readonly changed: () => void) {}

  /** In the visible part of the page. */
  get inSight(): boolean {
    return this.#inSight;
  }

  /** In sight, with the mouse over it or the focus in it. */
  get inHand(): boolean {
    return this.#inSight && (this.#hovered || this.#focused);
  }

  /** A script waits for its picture. */
  get asked(): boolean {
    return this.#asks > 0;
  }

  /** Near enough to be seen soon, or asked for. */
  get awake(): boolean {
    return this.#near || this.asked;
  }

  /** Where it is may not be known yet: whoever has drawn meanwhile need not give that up. */
  get mayBeNear(): boolean {
    return this.awake || !this.#isPlaced;
  }

  /** Follow an element for as long as the watcher does. */
  watch(element: HTMLElement, watcher: PageWatcher): void {
    this.#near = this.#isPlaced = this.#inSight = this.#hovered = this.#focused = false;
    watcher.watchSight(element, nearMargin, (near) => this.#tell(() => {
      this.#near = near;
      this.#isPlaced = true;
    }));
    watcher.watchSight(element, '0px', (inSight) => this.#tell(() => (this.#inSight = inSight)));
    watcher.listen(element, {
      pointerenter: () => this.#tell(() => (this.#hovered = true)),
      pointerleave: () => this.#tell(() => (this.#hovered = false)),
      focusin: () => this.#tell(() => (this.#focused = true)),
      focusout: () => this.#tell(() => (this.#focused = false)),
    });
  }

  /** Do something that needs the element's picture, wherever the element is. */
  async ask<T>(work: () => Promise<T>): Promise<T> {
    this.#tell(() => this.#asks++);
    try {
      return await work();
    } finally {
      this.#tell(() => this.#asks--);
    }
  }

  #tell(change: () => void): void {
    change();
    this.changed();
  }
}
