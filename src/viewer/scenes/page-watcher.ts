const lessMotion = '(prefers-reduced-motion: reduce)';

/** Whether a person has asked their system for less motion. */
export function prefersLessMotion(): boolean {
  return matchMedia(lessMotion).matches;
}

/** Watches what makes an element draw or load: its size, the screen's pixels, and its visibility. */
export class PageWatcher {
  readonly #observers: { disconnect(): void }[] = [];

  /** Call `changed` when the element has another size, in CSS pixels or in device pixels. */
  watchSize(element: Element, changed: () => void): void {
    const resize = new ResizeObserver(changed);
    resize.observe(element);
    this.#observers.push(resize);
    this.#watchPixelRatio(changed);
  }

  /**
   * Call `changed` when the element comes into the visible part of the page, or leaves it.
   * @param margin - how far around that part still counts, CSS; a browser without the observer reports all as visible
   */
  watchSight(element: Element, margin: string, changed: (inSight: boolean) => void): void {
    if (typeof IntersectionObserver === 'undefined') return changed(true);
    const observer = new IntersectionObserver((entries) => changed(entries.at(-1)!.isIntersecting), {
      rootMargin: margin,
    });
    observer.observe(element);
    this.#observers.push(observer);
  }

  /** Call `changed` when a person wants less motion, or no longer. */
  watchMotion(changed: () => void): void {
    const query = matchMedia(lessMotion);
    query.addEventListener('change', changed);
    this.#observers.push({ disconnect: () => query.removeEventListener('change', changed) });
  }

  /** Listen to events of the element. */
  listen(element: Element, listeners: Readonly<Record<string, () => void>>): void {
    const abort = new AbortController();
    for (const [name, listener] of Object.entries(listeners))
      element.addEventListener(name, listener, { signal: abort.signal });
    this.#observers.push({ disconnect: () => abort.abort() });
  }

  /** Disconnect another observer together with these. */
  add(observer: { disconnect(): void }): void {
    this.#observers.push(observer);
  }

  disconnect(): void {
    for (const observer of this.#observers.splice(0)) observer.disconnect();
  }

  /** A window that is moved to another screen, or zoomed, has other pixels at the same size. */
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
