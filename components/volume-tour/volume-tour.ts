import type { PropertyValues } from 'lit';
import type { VolumeViewError } from '../../src/core/errors.ts';
import { TourLocale } from '../../src/messages/tour-locale.ts';
import { childrenOf } from '../../src/page/page-children.ts';
import { readStep } from '../../src/viewer/tours/step-value.ts';
import type { StepValue } from '../../src/viewer/tours/step-value.ts';
import {
  readBy,
  readDuration,
  readDwell,
  readStepNumber,
  usualDuration,
  usualDwell,
} from '../../src/viewer/tours/tour-attributes.ts';
import { findTargets } from '../../src/viewer/tours/tour-guide.ts';
import { blockStyles, textButtonStyles } from '../internal/block-styles.ts';
import { flag, number } from '../internal/property-kinds.ts';
import { property, ReflectingElement } from '../internal/reflecting-element.ts';
import { spokenStyles } from '../internal/spoken-styles.ts';
import { companionGap } from '../internal/view-width.ts';
import { VolumeLink } from '../internal/volume-link.ts';
import { emit } from '../internal/volume-view-events.ts';
import type { VolumeStep } from '../volume-step/volume-step.ts';
import { TourAutoplay } from './tour-autoplay.ts';
import { TourScroll } from './tour-scroll.ts';
import { TourView } from './tour-view.ts';
import { renderTour } from './volume-tour-parts.ts';
import { styles } from './volume-tour-styles.ts';

/** Detail of `step-change`. */
export interface StepChangeDetail {
  /** Number of the step that is open now, from 1; 0 where none is. */
  readonly step: number;
  /** Number of all steps. */
  readonly count: number;
  /** The id of the `<volume-step>`; empty where it has none. */
  readonly id: string;
}

/**
 * A way through a volume in steps: each `<volume-step>` has a text, and attributes that the `<volume-view>` gets while the step is open.
 * One step is open at a time; buttons, dots and arrow keys lead to the others, Escape leaves the tour. Then the view is as before.
 *
 * `<volume-tour for="head"><volume-step camera-orbit="90deg 80deg auto"><h3>From the side</h3></volume-step></volume-tour>`
 *
 * Whoever turns the picture by hand may go on from there, or back to the step. On paper and without scripts all texts are there.
 *
 * @tag volume-tour
 * @slot - the `<volume-step>`s
 * @csspart bar - the box around the buttons
 * @csspart button - each button
 * @csspart dot - the button of each step
 * @csspart hint - the text where the page has no such view
 * @csspart error - the text where an attribute can't be read
 * @cssproperty --volume-tour-color - colour of the dot of the open step; by default that of the text
 * @cssproperty --volume-view-focus-color - colour of the ring around the element with the focus; by default that of the text
 * @fires {CustomEvent<StepChangeDetail>} step-change - another step is open, or none
 * @fires {CustomEvent<null>} tour-complete - each step has been open
 * @fires {CustomEvent<ErrorDetail>} error - an attribute of the tour, or of a step, can't be read; the attribute is ignored
 */
export class VolumeTour extends ReflectingElement {
  static override readonly styles = [blockStyles, textButtonStyles, companionGap, spokenStyles, styles];

  /** The id of the `<volume-view>`; by default the nearest one. */
  @property({ attribute: 'for' }) htmlFor!: string | null;

  /**
   * Number of the open step, from 1; 0 for none.
   * @default 1
   */
  @property({ kind: number }) step!: number | null;

  /**
   * How long a move to another step takes, milliseconds; 0 for none. Under `prefers-reduced-motion` there is none either.
   * @default 600
   */
  @property({ kind: number }) duration!: number | null;

  /**
   * Opens one step after the other without a person, and starts again after the last. It waits while a person uses the tour or the view, and
   * there is a button that pauses it. If a person has asked their system for less motion, it waits for `play()` or this button.
   */
  @property({ kind: flag }) autoplay!: boolean;

  /**
   * How long a step stays open while the tour plays, seconds, 1 to 3600. A `<volume-step>` may have its own.
   * @default 10
   */
  @property({ kind: number }) dwell!: number | null;

  /**
   * `scroll`: all texts are visible, and the step whose text is in the middle of the page is open. There are no buttons then, and no
   * `autoplay`.
   */
  @property() by!: string | null;

  readonly #link = new VolumeLink(this, () => this.requestUpdate(), []);
  readonly #locale = new TourLocale(this);
  readonly #player = new TourAutoplay(
    this,
    () => this.#advance(),
    () => this.requestUpdate(),
  );
  readonly #scroll = new TourScroll(this, (step, isInside) => {
    // Another tour of the view may be open, elsewhere in the page.
    if (step === this.#number || (this.#number === 0 && !isInside)) return;
    this.#reached = this.step = step;
  });
  readonly #shown = new TourView(this, () => this.requestUpdate());
  #steps: readonly VolumeStep[] = [];
  #values: readonly StepValue<Element>[] = [];
  /** Number of the open step. */
  #number = 0;
  /** Duration of a move, ms. */
  #time = usualDuration;
  /** How long the open step stays open while the tour plays, ms. */
  #dwell = usualDwell;
  /** Whether the tour follows the page as a person scrolls. */
  #isScrolled = false;
  /** The step to which the page was scrolled; null before that. */
  #reached: number | null = null;
  /** Whether the tour has opened the step by itself. */
  #isPlayed = false;
  #problem: VolumeViewError | null = null;
  /** The number of the last `step-change`; null before the first one. */
  #known: number | null = null;
  /** Its step; undefined for none. Where steps are added or removed, another one may have the same number. */
  #knownStep: VolumeStep | undefined;
  readonly #seen = new Set<VolumeStep>();
  #isComplete = false;
  /** Whether a person has chosen the step, and the focus follows. */
  #takesFocus = false;
  #said = '';

  constructor() {
    super();
    new MutationObserver((records) => {
      if (records.some(({ type, target }) => type === 'childList' || (target as Element).localName === 'volume-step'))
        this.requestUpdate();
    }).observe(this, { childList: true, subtree: true, attributes: true });
    this.addEventListener('keydown', (event) => this.#onKey(event));
    // The steps, and the notes that they name, may come after this tag.
    if (document.readyState === 'loading')
      document.addEventListener('DOMContentLoaded', () => this.requestUpdate(), { once: true });
  }

  /** Open the next step. Returns whether there is one. */
  next(): boolean {
    return this.#go(this.#number + 1);
  }

  /** Open the previous step. Returns whether there is one. */
  previous(): boolean {
    return this.#number > 1 && this.#go(this.#number - 1);
  }

  /** Open one step after the other, as `autoplay` does. */
  play(): void {
    this.#player.ask(true);
  }

  /** The open step stays. */
  pause(): void {
    this.#player.ask(false);
  }

  /** Whether it does not play, as nobody wants it to. A tour that plays may wait for a person who uses it. */
  get paused(): boolean {
    return this.#player.paused;
  }

  /** Close the open step: the view is as before the tour. */
  leave(): void {
    this.#shown.leave();
    this.step = 0;
  }

  protected override willUpdate(changed: PropertyValues<this>): void {
    if (changed.has('htmlFor') && this.hasUpdated) this.#link.find();
    const { view } = this.#link;
    const targets = view && findTargets(view);
    this.#steps = childrenOf(this, 'volume-step', 'volume-tour') as VolumeStep[];
    this.#values = targets ? this.#steps.map(({ attributes }) => readStep(attributes, targets)) : [];
    const problems = this.#values.flatMap((value) => value.problem ?? []);
    const attempt = (read: () => void): void => {
      try {
        read();
      } catch (error) {
        problems.unshift(error as VolumeViewError);
      }
    };
    attempt(() => (this.#time = readDuration(this.readText('duration'))));
    attempt(() => (this.#isScrolled = readBy(this.readText('by'))));
    attempt(() => (this.#number = readStepNumber(this.readText('step'), this.#steps.length)));
    this.#number = Math.min(this.#number, this.#steps.length); // Steps may have been removed.
    attempt(() => (this.#dwell = this.#readDwell()));
    if (document.readyState === 'loading') return;
    this.#report(problems[0] ?? null);
    if (this.#known !== null && this.#isOther) this.#said = this.#isPlayed || this.#isScrolled ? '' : this.#describe();
  }

  /** @throws {VolumeViewError} `attribute/invalid` */
  #readDwell(): number {
    const own = this.#steps[this.#number - 1]?.getAttribute('dwell') ?? null;
    return (
      readDwell(own, 'dwell of <volume-step>') ??
      readDwell(this.readText('dwell'), 'dwell of <volume-tour>') ??
      usualDwell
    );
  }

  /** Send an error to the page, unless it is the last one. */
  #report(error: VolumeViewError | null): void {
    const isNew = error?.message !== this.#problem?.message;
    this.#problem = error;
    if (error && isNew) emit(this, 'error', { code: error.code, message: error.message, cause: error.cause });
  }

  protected override updated(): void {
    if (document.readyState === 'loading') return;
    // A step may not be defined yet; then all of its text is there.
    this.#steps.forEach((step, i) => step.setOpen?.(i + 1 === this.#number, this.#isScrolled));
    const { view } = this.#link;
    const value = this.#values.at(this.#number - 1);
    if (!view || this.#number === 0 || !value || this.#shown.view !== view) this.#shown.leave();
    if (view && this.#number > 0 && value)
      this.#shown.show(view, { number: this.#number, value, all: this.#values, time: this.#time });
    this.#move(view);
    this.#notify();
    if (this.#takesFocus) void this.#moveFocus();
  }

  /** What leads on without a choice: time, or the page that a person scrolls. */
  #move(view: HTMLElement | null): void {
    this.#isPlayed = false;
    const autoplay = this.autoplay && !this.#isScrolled;
    this.#player.follow({ view: this.isConnected ? view : null, step: this.#number, dwell: this.#dwell, autoplay });
    this.#scroll.follow(this.#isScrolled && this.isConnected ? this.#steps : [], view);
    if (this.#isScrolled && this.#number !== this.#reached) {
      if (this.#known !== null && this.#number > 0) this.#scroll.show(this.#number);
      this.#reached = this.#number;
    }
  }

  #advance(): void {
    this.#isPlayed = true;
    this.step = (this.#number % this.#steps.length) + 1;
  }

  get #openStep(): VolumeStep | undefined {
    return this.#steps[this.#number - 1];
  }

  /** Whether it is another step than that of the last `step-change`. */
  get #isOther(): boolean {
    return this.#number !== this.#known || this.#openStep !== this.#knownStep;
  }

  /** Notify the page of another step. */
  #notify(): void {
    const [step, count, open] = [this.#number, this.#steps.length, this.#openStep];
    if (count === 0 || !this.#isOther) return;
    const isFirst = this.#known === null;
    [this.#known, this.#knownStep] = [step, open];
    if (isFirst && step === 0) return;
    const detail: StepChangeDetail = { step, count, id: open?.id ?? '' };
    emit(this, 'step-change', detail);
    if (open) this.#seen.add(open);
    if (this.#isComplete || !this.#steps.every((one) => this.#seen.has(one))) return;
    this.#isComplete = true;
    emit(this, 'tour-complete', null);
  }

  #go(step: number): boolean {
    if (step > this.#steps.length) return false;
    this.step = step;
    return true;
  }

  /** A person chooses a step, or leaves. */
  #choose(step: number): void {
    if (step < 0 || step > this.#steps.length) return;
    this.#takesFocus = true;
    if (step === 0) this.leave();
    else this.step = step;
  }

  /** Back to the open step, after a person has turned the picture. */
  readonly #onBack = (): void => {
    this.#shown.forget();
    this.#takesFocus = true; // The button disappears.
    this.requestUpdate();
  };

  #onKey(event: KeyboardEvent): void {
    const [from] = event.composedPath() as HTMLElement[];
    if (event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey || this.#number === 0) return;
    if (this.#isScrolled) return;
    if (from.matches('input, textarea, select, [contenteditable]')) return;
    const isOwn = this.shadowRoot!.contains(from) || from === this.#headingOf(this.#number);
    const isRtl = getComputedStyle(this).direction === 'rtl';
    const steps: Readonly<Record<string, number>> = {
      Escape: 0,
      ...(isOwn && {
        [isRtl ? 'ArrowLeft' : 'ArrowRight']: Math.min(this.#number + 1, this.#steps.length),
        [isRtl ? 'ArrowRight' : 'ArrowLeft']: Math.max(this.#number - 1, 1),
        Home: 1,
        End: this.#steps.length,
      }),
    };
    if (!Object.hasOwn(steps, event.key)) return;
    event.preventDefault();
    this.#choose(steps[event.key]);
  }

  /** Where the text of a step begins. */
  #headingOf(step: number): HTMLElement {
    const element = this.#steps[step - 1];
    return element.querySelector<HTMLElement>('h1, h2, h3, h4, h5, h6') ?? element;
  }

  /** The focus goes to the heading of the step, and after the tour to the button that starts it. */
  async #moveFocus(): Promise<void> {
    this.#takesFocus = false;
    if (this.#number === 0) return this.shadowRoot!.querySelector<HTMLElement>('button')?.focus();
    const step = this.#steps[this.#number - 1];
    const heading = this.#headingOf(this.#number);
    await step.updateComplete;
    if (!heading.hasAttribute('tabindex')) heading.tabIndex = -1;
    heading.focus({ preventScroll: this.#isScrolled });
  }

  #titleOf(step: number): string {
    const element = this.#steps[step - 1];
    const heading = this.#headingOf(step);
    const title = heading === element ? element.getAttribute('label') : heading.textContent;
    return (
      title?.trim().replace(/\s+/g, ' ').slice(0, 200) || this.#locale.messages.tourStep(this.#locale.number(step))
    );
  }

  /** The sentence for screen readers. */
  #describe(): string {
    const { messages } = this.#locale;
    if (this.#number === 0) return messages.tourLeft;
    const [step, count] = [this.#number, this.#steps.length].map((one) => this.#locale.number(one));
    return messages.tourStepOf(step, count, this.#titleOf(this.#number));
  }

  protected override render(): unknown {
    const { messages } = this.#locale;
    const { paused } = this;
    return renderTour({
      messages,
      step: this.#number,
      titles: this.#isScrolled ? [] : this.#steps.map((_, i) => this.#titleOf(i + 1)),
      number: (value) => this.#locale.number(value),
      problem: this.#problem?.message ?? null,
      lack: this.#link.view || document.readyState === 'loading' ? null : messages.noView(this.htmlFor),
      player: paused && !this.autoplay ? null : paused ? 'play' : 'pause',
      isTurned: this.#shown.isTurned,
      said: this.#said,
      choose: (step) => this.#choose(step),
      play: (isOn) => this.#player.ask(isOn),
      back: this.#onBack,
    });
  }
}

declare global {
  interface HTMLElementTagNameMap {
    'volume-tour': VolumeTour;
  }
}
