import { socketOf } from '../../src/viewer/model/view-socket.ts';
import { TourPlayer } from '../../src/viewer/tours/tour-player.ts';

/** What plays a tour needs to know about the page. */
interface TourState {
  /** null where there is none, or the tour is not in the page. */
  readonly view: HTMLElement | null;
  /** Number of the open step; 0 where none is. */
  readonly step: number;
  /** How long it stays open, ms. */
  readonly dwell: number;
  readonly autoplay: boolean;
}

/**
 * Plays a tour without a person, and waits while one uses the tour or its view: the pointer is over it, it has the focus of keys, or the
 * picture was turned a moment ago. It also waits for the picture, and while the view is out of sight.
 */
export class TourAutoplay {
  readonly #player: TourPlayer;
  readonly #reduced = matchMedia('(prefers-reduced-motion: reduce)');
  /** The last choice of a person or a script; null where nobody has chosen. */
  #asked: boolean | null = null;
  #autoplay = false;
  #watched: HTMLElement | null = null;
  #watch = new AbortController();
  #key = '';

  /**
   * @param advance - opens the next step
   * @param changed - called when it plays, or no longer
   */
  constructor(
    readonly tour: HTMLElement,
    advance: () => void,
    readonly changed: () => void,
  ) {
    this.#player = new TourPlayer(advance);
    this.#reduced.addEventListener('change', () => {
      this.#asked = null;
      this.#apply();
    });
  }

  get paused(): boolean {
    return this.#player.paused;
  }

  /** A person or a script starts it, or pauses it. */
  ask(isOn: boolean): void {
    this.#asked = isOn;
    this.#apply();
  }

  /** The attributes, the view or the step may have changed. */
  follow({ view, step, dwell, autoplay }: TourState): void {
    if (view !== this.#watched) this.#listen(view);
    this.#player.hold('no view', view === null);
    this.#player.hold('no step', step === 0);
    if (autoplay !== this.#autoplay) this.#asked = null;
    this.#autoplay = autoplay;
    const key = `${step} ${dwell}`;
    if (key !== this.#key) this.#player.stay(dwell);
    this.#key = key;
    this.#apply();
  }

  #apply(): void {
    const isOn = this.#asked ?? (this.#autoplay && !this.#reduced.matches);
    if (isOn !== this.paused) return;
    if (isOn) this.#player.play();
    else this.#player.pause();
    this.changed();
  }

  #listen(view: HTMLElement | null): void {
    this.#watch.abort();
    this.#watched = view;
    if (!view) return;
    this.#watch = new AbortController();
    const { signal } = this.#watch;
    this.#watchUse(this.tour, signal);
    this.#watchUse(view, signal);
    view.addEventListener('camera-change', () => this.#player.restart(), { signal });
    const showPicture = (): void => this.#player.hold('no picture', !socketOf(view).view?.viewer?.scene);
    for (const type of ['load', 'render']) view.addEventListener(type, showPicture, { signal });
    showPicture();
    const sight = new IntersectionObserver((entries) =>
      this.#player.hold('out of sight', !entries.at(-1)!.isIntersecting),
    );
    sight.observe(view);
    signal.addEventListener('abort', () => sight.disconnect());
  }

  /** Wait while a person uses an element. */
  #watchUse(element: HTMLElement, signal: AbortSignal): void {
    const name = element.localName;
    const hold = (way: string, isHeld: boolean): void => this.#player.hold(`${way} ${name}`, isHeld);
    // From one part of an element to another one, the events of the pointer and of the focus stay in its shadow.
    const on = (types: readonly string[], listener: (event: Event) => void): void => {
      for (const place of [element, element.shadowRoot])
        for (const type of types) place?.addEventListener(type, listener, { signal });
    };
    hold('pointer', false);
    // Whoever has just pressed the button that plays is still there, with the pointer and with the focus.
    on(['pointerover'], (event) => hold('pointer', !isPlayButton(event)));
    on(['pointerleave', 'pointercancel'], () => hold('pointer', false));
    // The focus of a finger or a mouse stays where it was when its owner has left.
    on(['focusin'], (event) => {
      const [target] = event.composedPath() as Element[];
      hold('focus', target.matches(':focus-visible') && !isPlayButton(event));
    });
    on(['focusout'], () => hold('focus', false));
    hold('focus', false);
    on(['keydown', 'wheel', 'pointerdown'], () => this.#player.restart());
  }
}

function isPlayButton(event: Event): boolean {
  return event.composedPath().some((target) => target instanceof Element && target.matches('button.play'));
}
