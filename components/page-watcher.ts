/** Watches what of a page makes an element draw or load: its size, the screen's pixels, and whether it is near. */
export class PageWatcher {
  readonly #observers: { disconnect(): void }[] = [];

  /** Call back when the element has another size, in CSS pixels or in the screen's. */
  watchSize(element: Element, changed: () => void): void {
    const resize = new ResizeObserver(changed);
    resize.observe(element);
    this.#observers.push(resize);
    this.#watchPixelRatio(changed);
  }

  /** Call back once when the element comes near the visible part of the page. */
  watchNearness(element: Element, near: () => void): void {
    const visible = new IntersectionObserver((entries) => {
      if (!entries.some((entry) => entry.isIntersecting)) return;
      visible.disconnect();
      near();
    }, { rootMargin: '50%' });
    visible.observe(element);
    this.#observers.push(visible);
  }

  /** Let another observer end with these. */
  add(observer: { disconnect(): void }): void {
    this.#observers.push(observer);
  }

  disconnect(): void {
    for (const observer of this.#observers.splice(0)) observer.disconnect();
  }

  /** A window dragged to another screen, or zoomed, has other pixels at the same size. */
  #watchPixelRatio(changed: () => void): void {
    const query = matchMedia(`(resolution: ${devicePixelRatio}dppx)`);
    const listener = (): void => {
      changed();
      this.#watchPixelRatio(changed);
    };
    query.addEventListener('change', listener, { once: true });
    this.#observers.push({ disconnect: () => query.removeEventListener('change', listener) });
  }
}
