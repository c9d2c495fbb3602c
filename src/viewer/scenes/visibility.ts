import type { PageWatcher } from './page-watcher.ts';

/** The margin around the visible part of the page in which an element is still near it: in screens, up, down and to the sides. */
const nearMargin = '50%';

/**
 * The visibility of an element: how near it is to the visible part of the page, whether a person interacts with it, and whether a
 * script waits for it.
 */
export class Visibility {
  #near = false;
  /** Whether the place of the element is known. */
  #isPlaced = false;
  #inSight = false;
  #hovered = false;
  #focused = false;
  #asks = 0;

  /** @param changed - called whenever one of these may have changed */
  constructor(readonly changed: () => void) {}

  /** Whether it is in the visible part of the page. */
  get inSight(): boolean {
    return this.#inSight;
  }

  /** Whether it is visible, with the mouse over it or the focus in it. */
  get inHand(): boolean {
    return this.#inSight && (this.#hovered || this.#focused);
  }

  /** Whether a script waits for its picture. */
  get asked(): boolean {
    return this.#asks > 0;
  }

  /** Whether it is near enough to be visible soon, or a script waits for it. */
  get awake(): boolean {
    return this.#near || this.asked;
  }

  /** Also true while its place is not known yet: an element that has drawn by then need not give up its context. */
  get mayBeNear(): boolean {
    return this.awake || !this.#isPlaced;
  }

  /** Watch an element as long as the watcher works. */
  watch(element: HTMLElement, watcher: PageWatcher): void {
    this.#near = this.#isPlaced = this.#inSight = this.#hovered = this.#focused = false;
    watcher.watchSight(element, nearMargin, (near) =>
      this.#notify(() => {
        this.#near = near;
        this.#isPlaced = true;
      }),
    );
    watcher.watchSight(element, '0px', (inSight) => this.#notify(() => (this.#inSight = inSight)));
    watcher.listen(element, {
      pointerenter: () => this.#notify(() => (this.#hovered = true)),
      pointerleave: () => this.#notify(() => (this.#hovered = false)),
      focusin: () => this.#notify(() => (this.#focused = true)),
      focusout: () => this.#notify(() => (this.#focused = false)),
    });
  }

  /** Do some work that needs the element's picture, wherever the element is. */
  async ask<T>(work: () => Promise<T>): Promise<T> {
    this.#notify(() => this.#asks++);
    try {
      return await work();
    } finally {
      this.#notify(() => this.#asks--);
    }
  }

  #notify(change: () => void): void {
    change();
    this.changed();
  }
}
