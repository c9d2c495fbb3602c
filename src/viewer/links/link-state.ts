// What a view with `link-state` does with the address of its page. It is loaded with the first such view, or the first link that is made.
import { VolumeViewError } from '../../core/errors.ts';
import { readStep } from '../tours/step-value.ts';
import { findTargets, writeSetting } from '../tours/tour-guide.ts';
import { socketOf } from '../model/view-socket.ts';
import type { Aspect } from '../model/error-state.ts';
import { checkAttribute } from './check-attribute.ts';
import type { AttributeProblem } from './check-attribute.ts';
import { readLink, writeLink } from './link-address.ts';
import type { ViewLink } from './link-address.ts';
import { linkAttributes } from './link-attributes.ts';

/** A `<volume-view>` into which links lead. */
export interface LinkedView extends HTMLElement {
  getView(): Record<string, string>;
}

/** A `<volume-tour>` of the view. */
type Tour = HTMLElement & { step: number | null; updateComplete?: Promise<unknown> };

/** The texts of attributes by their names. */
type Texts = Readonly<Record<string, string>>;

/** The views that follow the address. */
const followed = new WeakMap<LinkedView, LinkState>();

/** Opens what the address of the page says, now and whenever it changes, as long as the view has `link-state`. It never writes the address. */
class LinkState {
  /** Counts the links, so that only the last one opens. */
  #run = 0;
  /** What the errors of the last link are about. */
  #reported: readonly Aspect[] = [];

  constructor(
    readonly view: LinkedView,
    readonly tag: Texts,
  ) {
    const held = new WeakRef<LinkState>(this); // A view that has gone is not kept.
    addEventListener('hashchange', () => void held.deref()?.open());
    // The tour may come after the view.
    if (document.readyState === 'loading')
      document.addEventListener('DOMContentLoaded', () => setTimeout(() => void this.open()), { once: true });
    else void this.open();
  }

  async open(): Promise<void> {
    const { view } = this;
    const isThere = view.isConnected && view.hasAttribute('link-state');
    const link = isThere ? readLink(location.hash, view.id) : null;
    const run = ++this.#run;
    if (!link) return;
    view.scrollIntoView({ block: 'nearest' });
    const problems: AttributeProblem[] = [];
    const good = new Map<string, string>();
    for (const [name, text] of link.attributes) {
      const problem = await checkAttribute(name, text, socketOf(view).volume);
      if (problem) problems.push(problem);
      else good.set(name, text);
    }
    if (link.step !== null && document.querySelector('volume-tour:not(:defined)'))
      await customElements.whenDefined('volume-tour');
    const tour = tourOf(view);
    if (tour && link.step !== null) await openStep(tour, link.step);
    if (run !== this.#run) return;
    const base = baseOf(view, this.tag, tour);
    for (const name of linkAttributes) {
      const text = good.get(name) ?? base[name] ?? null;
      writeSetting({ target: view, name, text }, view);
    }
    const { errors } = socketOf(view).view ?? {};
    for (const aspect of this.#reported) errors?.clear(aspect);
    this.#reported = problems.map(({ aspect }) => aspect);
    for (const { aspect, error } of problems) errors?.report(aspect, error);
  }
}

/**
 * The address of the page with the present view. A view with `link-state` follows the address from then on.
 * @param tag - the texts of the attributes that the tag had at first
 * @throws {VolumeViewError} `attribute/invalid` where the view has no id
 */
export function linkOf(view: LinkedView, tag: Texts = {}): string {
  if (view.hasAttribute('link-state') && !followed.has(view)) followed.set(view, new LinkState(view, tag));
  if (view.id === '')
    throw new VolumeViewError(
      'attribute/invalid',
      '<volume-view> got no id; expected one, as a link finds the view by its id.',
    );
  const tour = tourOf(view);
  const now: Texts = { ...tag, ...view.getView() };
  const base = baseOf(view, tag, tour);
  const attributes = new Map(
    linkAttributes
      .filter((name) => Object.hasOwn(now, name) && now[name] !== base[name])
      .map((name) => [name, now[name]]),
  );
  const address = new URL(location.href);
  address.hash = writeLink(view.id, { step: tour && (tour.step ?? 1), attributes } satisfies ViewLink);
  return address.href;
}

/** The tour through this view, once it is defined. */
function tourOf(view: HTMLElement): Tour | null {
  return (socketOf(view).parts.find(({ key }) => key === 'volume-tour')?.element as Tour | undefined) ?? null;
}

/** Show a step at once: the attributes of the link come after those of the step. */
async function openStep(tour: Tour, step: number): Promise<void> {
  const duration = tour.getAttribute('duration');
  tour.setAttribute('duration', '0');
  tour.setAttribute('step', `${step}`);
  await tour.updateComplete;
  if (duration === null) tour.removeAttribute('duration');
  else tour.setAttribute('duration', duration);
}

/** The texts that a view has without a link: those of the tag, and of the open step of its tour. */
function baseOf(view: HTMLElement, tag: Texts, tour: Tour | null): Texts {
  const step = tour?.querySelectorAll(':scope > volume-step')[(tour.step ?? 1) - 1];
  if (!step) return tag;
  const { settings } = readStep(step.attributes, findTargets(view));
  const own = settings.filter(({ target, text }) => target === view && text !== null);
  return { ...tag, ...Object.fromEntries(own.map(({ name, text }) => [name, text!])) };
}
