import { prefersLessMotion } from '../scenes/page-watcher.ts';
import { socketOf } from '../model/view-socket.ts';
import { blendStops } from './blend-stops.ts';
import { lookAttributes, placeAttributes } from './step-attributes.ts';
import type { Setting, StepTargets, StepValue } from './step-value.ts';
import { TourState } from './tour-state.ts';

const looks: readonly string[] = lookAttributes;
const places: readonly string[] = placeAttributes;

/** Takes one view through the steps of a tour, by its attributes and those of its companions. */
export class TourGuide {
  readonly #state = new TourState<Element>((element, name) => element.getAttribute(name));
  #frame = 0;

  constructor(readonly view: HTMLElement) {}

  /**
   * Go to a step.
   * @param all - all steps of the tour: what any of them sets is remembered before it changes
   * @param duration - of the change of colours, ms. The view itself moves its camera
   */
  open(step: StepValue<Element>, all: readonly StepValue<Element>[], duration: number): void {
    for (const { settings } of all) this.#state.remember(settings);
    this.#write(this.#state.textsIn(step.settings), duration);
  }

  /** Back to how everything was before the tour. */
  leave(): void {
    this.#write(this.#state.textsIn(), 0);
  }

  #write(settings: readonly Setting<Element>[], duration: number): void {
    cancelAnimationFrame(this.#frame);
    const isLook = ({ target, name }: Setting<Element>): boolean => target === this.view && looks.includes(name);
    for (const setting of settings) if (!isLook(setting)) writeSetting(setting, this.view);
    this.#changeLook(settings.filter(isLook), duration);
  }

  /** Colours are mixed on the way where they have stops at the same values; any other appearance changes in the middle of the way. */
  #changeLook(settings: readonly Setting<Element>[], duration: number): void {
    const changes = settings.filter(({ name, text }) => this.view.getAttribute(name) !== text);
    if (changes.length === 0) return;
    const end = (): void => changes.forEach((setting) => writeSetting(setting, this.view));
    const hasPicture = Boolean(socketOf(this.view).view?.viewer?.scene);
    if (!(duration > 0) || prefersLessMotion() || !hasPicture) return end();
    const [{ name, text }] = changes;
    const blend =
      changes.length === 1 && name === 'transfer-function' ? blendStops(this.view.getAttribute(name), text) : null;
    const began = performance.now();
    const step = (): void => {
      const share = (performance.now() - began) / duration;
      if (share >= (blend ? 1 : 0.5)) return end();
      if (blend) this.view.setAttribute(name, blend(share));
      this.#frame = requestAnimationFrame(step);
    };
    this.#frame = requestAnimationFrame(step);
  }
}

/** Give an element the text of an attribute. @param view - of the tour */
export function writeSetting({ target, name, text }: Setting<Element>, view: Element): void {
  // A person may have moved the camera, or chosen another scan or other labels: only an attribute that is set again takes that back.
  const isPlace = target === view ? places.includes(name) : name === 'only';
  if (!isPlace && target.getAttribute(name) === text) return;
  if (isPlace && text === null) target.setAttribute(name, '');
  if (text === null) target.removeAttribute(name);
  else target.setAttribute(name, text);
}

/** The elements that the steps of a tour through this view may change. The notes may come later than the view. */
export function findTargets(view: HTMLElement): StepTargets<Element> {
  const page = view.getRootNode() as Document | ShadowRoot | Element;
  const notes = new Set<Element>([
    ...view.querySelectorAll('volume-note'),
    ...(view.id ? page.querySelectorAll(`volume-note[for="${CSS.escape(view.id)}"]`) : []),
    ...socketOf(view).parts.flatMap(({ key, element }) => (key === 'volume-note' && element ? [element] : [])),
  ]);
  return {
    view,
    notes: [...notes].map((target) => ({ id: target.id, target })),
    slice: view.querySelector('volume-slice'),
    labels: view.querySelector('volume-labels'),
  };
}
