import { socketOf } from '../../src/viewer/model/view-socket.ts';
import type { ViewPart } from '../../src/viewer/model/view-socket.ts';
import type { StepValue } from '../../src/viewer/tours/step-value.ts';
import { TourGuide } from '../../src/viewer/tours/tour-guide.ts';

/** A tour, as another one of the same view knows it. */
interface Tour extends HTMLElement {
  leave(): void;
}

/** A step that a view shows. */
interface ShownStep {
  readonly number: number;
  readonly value: StepValue<Element>;
  /** All steps of the tour. */
  readonly all: readonly StepValue<Element>[];
  /** Duration of the move, ms. */
  readonly time: number;
}

/** What a person does before the picture turns. */
const uses = ['pointerdown', 'pointermove', 'wheel', 'keydown'] as const;

/** The view of a tour while a step is open in it: what the view gets, and whether a person has turned it since. */
export class TourView {
  #guide: TourGuide | null = null;
  /** What the view got last; empty for nothing. */
  #given = '';
  /** Duration of a move, ms. */
  #time = 0;
  /** Whether a step has a place for the camera. */
  #isPlaced = false;
  #isTurned = false;
  /** Whether a person has used the view since the step opened. The event of a picture that glides after a turn may come late. */
  #isUsed = false;
  /** Through this the view gets the speed of its camera. */
  readonly #part: ViewPart;

  /** @param changed - called when `isTurned` has changed */
  constructor(
    readonly tour: Tour,
    readonly changed: () => void,
  ) {
    this.#part = {
      key: 'tour',
      element: tour,
      // A camera is at its place after five times this time, by the eye: 99.3 % of the way.
      attribute: (name) =>
        name === 'interpolationDecay' && tour.hasAttribute('duration') ? `${this.#time / 5}` : null,
    };
  }

  /** null while no step is open. */
  get view(): HTMLElement | null {
    return this.#guide?.view ?? null;
  }

  /** Whether a person has turned the picture since the step opened. */
  get isTurned(): boolean {
    return this.#isTurned;
  }

  /** Show a step, unless it is there. */
  show(view: HTMLElement, { number, value, all, time }: ShownStep): void {
    this.#time = time;
    const given = JSON.stringify([number, value.settings.map(({ name, text }) => [name, text])]);
    if (given === this.#given) return;
    this.#guide ??= this.#enter(view);
    this.#given = given;
    this.#isPlaced = all.some(({ settings }) =>
      settings.some(({ name }) => name.startsWith('camera-') || name === 'field-of-view'),
    );
    if (this.#isTurned) this.changed();
    this.#isTurned = false;
    this.#guide.open(value, all, time);
    this.#isUsed = false;
  }

  /** The next `show` brings the step back, also where nothing else has changed. */
  forget(): void {
    this.#given = '';
  }

  /** The view is as before the tour. */
  leave(): void {
    const view = this.#guide?.view;
    this.#given = '';
    this.#isTurned = false;
    if (!view) return;
    for (const type of uses) view.removeEventListener(type, this.#onUse, { capture: true });
    view.removeEventListener('camera-change', this.#onTurn);
    void socketOf(view).leave(this.#part);
    this.#guide!.leave();
    this.#guide = null;
  }

  #enter(view: HTMLElement): TourGuide {
    for (const { key, element } of socketOf(view).parts)
      if (key === this.tour.localName && element !== this.tour) (element as Tour).leave();
    const guide = new TourGuide(view);
    void socketOf(view).join(this.#part);
    for (const type of uses) view.addEventListener(type, this.#onUse, { capture: true, passive: true });
    view.addEventListener('camera-change', this.#onTurn);
    return guide;
  }

  readonly #onUse = (event: Event): void => {
    if (event.type !== 'pointermove' || (event as PointerEvent).buttons > 0) this.#isUsed = true;
  };

  readonly #onTurn = (): void => {
    if (this.#isTurned || !this.#isUsed || !this.#isPlaced) return;
    this.#isTurned = true;
    this.changed();
  };
}
