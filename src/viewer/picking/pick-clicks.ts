// Clicks and taps on a picture, which pick the place under them: loaded where an element is `pickable` or has a readout.
import { placeInElement } from '../../page/pointer-place.ts';
import type { VolumePick } from '../model/volume-pick.ts';

/** An element in which a person points at something. */
export interface PickedView extends HTMLElement {
  readonly pickable: boolean;
  pick(x: number, y: number): Promise<VolumePick | null>;
}

type Place = readonly [x: number, y: number];

/** A press that moves at least this far is a drag, CSS pixels. Touches do not turn the picture before that either. */
const slop = { mouse: 3, touch: 6 };

/** One object for each element, however many copies of the script the page has. */
const key = Symbol.for('volume-view.clicks');

/** The clicks on an element. They pick while it is `pickable`, or while another object needs them. */
export function clicksOn(view: PickedView & { [key]?: PickClicks }): PickClicks {
  return (view[key] ??= new PickClicks(view));
}

/** Whether an event is on the picture itself, and not on a control over it. */
export function isOnPicture(event: Event): boolean {
  return event.composedPath().some((part) => part instanceof Element && part.matches('.picture'));
}

/** See `clicksOn`. */
export class PickClicks {
  #holders = 0;
  readonly #takers = new Set<(event: MouseEvent) => void>();
  /** Where the present press began; null if it has become a drag. */
  #press: Place | null = null;

  constructor(readonly view: PickedView) {
    view.addEventListener('pointerdown', ({ isPrimary, button, clientX, clientY }) => {
      this.#press = isPrimary && button === 0 ? [clientX, clientY] : null; // A second finger makes it another gesture.
    });
    view.addEventListener('pointermove', ({ clientX, clientY, pointerType }) => {
      const far = pointerType === 'touch' ? slop.touch : slop.mouse;
      if (this.#press && Math.hypot(clientX - this.#press[0], clientY - this.#press[1]) >= far) this.#press = null;
    });
    view.addEventListener('pointercancel', () => (this.#press = null));
    view.addEventListener('click', (event) => {
      const press = this.#press;
      this.#press = null;
      if (!press || !isOnPicture(event)) return;
      for (const take of this.#takers) take(event);
      if (view.pickable || this.#holders > 0) void this.fire(placeInElement(view, event));
    });
  }

  /** Let clicks pick. @returns a function that ends it */
  hold(): () => void {
    this.#holders++;
    return () => void this.#holders--;
  }

  /** Let a listener have the clicks too. @returns a function that ends it */
  take(listener: (event: MouseEvent) => void): () => void {
    this.#takers.add(listener);
    return () => void this.#takers.delete(listener);
  }

  /** Notify the page what is at a place. */
  async fire([x, y]: Place): Promise<void> {
    try {
      const detail = await this.view.pick(x, y);
      this.view.dispatchEvent(new CustomEvent('volume-pick', { detail }));
    } catch (error) {
      console.warn(error); // A part of the package could not be loaded.
    }
  }
}
