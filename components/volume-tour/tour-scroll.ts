/** Opens the step whose text is in the middle of the page, as a person scrolls. */
export class TourScroll {
  #steps: readonly HTMLElement[] = [];
  #view: HTMLElement | null = null;
  /** Where a text is read, share of the height of the window. */
  #line = 0.5;
  #frame = 0;
  #watch = new AbortController();

  /** @param reached - called with the number of a step, from 1, and whether the place where one reads is in the tour, or above or below it */
  constructor(
    readonly tour: HTMLElement,
    readonly reached: (step: number, isInside: boolean) => void,
  ) {}

  /** @param steps - none where the tour does not follow the page */
  follow(steps: readonly HTMLElement[], view: HTMLElement | null): void {
    if (view === this.#view && steps.length === this.#steps.length && steps.every((step, i) => step === this.#steps[i]))
      return;
    this.#watch.abort();
    cancelAnimationFrame(this.#frame);
    this.#frame = 0;
    this.#steps = steps;
    this.#view = view;
    if (steps.length > 0) this.#listen();
  }

  /** Scroll the text of a step to where it is read: a script has chosen it. */
  show(step: number): void {
    const { top, height } = this.#steps[step - 1].getBoundingClientRect();
    scrollBy({ top: top + height / 2 - this.#line * innerHeight });
  }

  #listen(): void {
    this.#watch = new AbortController();
    const { signal } = this.#watch;
    const measure = (): void => {
      this.#line = readingLine(this.tour, this.#view);
      this.#choose();
    };
    const size = new ResizeObserver(measure);
    for (const element of [this.tour, ...(this.#view ? [this.#view] : [])]) size.observe(element);
    signal.addEventListener('abort', () => size.disconnect());
    addEventListener('resize', measure, { signal });
    const choose = (): void => {
      this.#frame ||= requestAnimationFrame(() => {
        this.#frame = 0;
        this.#choose();
      });
    };
    // Any box around the tour may scroll.
    document.addEventListener('scroll', choose, { signal, capture: true, passive: true });
  }

  /** The step at the line, or the one that is nearest to it. */
  #choose(): void {
    const line = this.#line * innerHeight;
    const distanceOf = (element: HTMLElement): number => {
      const { top, bottom } = element.getBoundingClientRect();
      return Math.max(top - line, line - bottom, 0);
    };
    const distances = this.#steps.map(distanceOf);
    this.reached(distances.indexOf(Math.min(...distances)) + 1, distanceOf(this.tour) === 0);
  }
}

/**
 * Where a text is read: in the middle of the window, or of the part below a view that stays at its top, over the column of the texts.
 * @returns share of the height of the window, from its top
 */
function readingLine(tour: HTMLElement, view: HTMLElement | null): number {
  let covered = 0;
  for (let box: HTMLElement | null = view; box && !box.contains(tour); box = box.parentElement) {
    const { position, top } = getComputedStyle(box);
    if (position !== 'sticky' && position !== 'fixed') continue;
    const [place, column] = [box.getBoundingClientRect(), tour.getBoundingClientRect()];
    if (place.left < column.right && column.left < place.right) covered = place.height + (parseFloat(top) || 0);
  }
  return (Math.min(covered / innerHeight, 0.8) + 1) / 2;
}
