import { html, nothing } from 'lit';
import type { PropertyValues } from 'lit';
import { invalidAttribute } from '../../src/core/errors.ts';
import type { VolumeViewError } from '../../src/core/errors.ts';
import { TourLocale } from '../../src/messages/tour-locale.ts';
import { childrenOf } from '../../src/page/page-children.ts';
import { socketOf } from '../../src/viewer/model/view-socket.ts';
import type { ViewPart } from '../../src/viewer/model/view-socket.ts';
import { readStep } from '../../src/viewer/tours/step-value.ts';
import type { StepValue } from '../../src/viewer/tours/step-value.ts';
import { findTargets, TourGuide, usualDuration } from '../../src/viewer/tours/tour-guide.ts';
import { readDwell, usualDwell } from '../../src/viewer/tours/tour-player.ts';
import { flag, number } from '../internal/property-kinds.ts';
import { property, ReflectingElement } from '../internal/reflecting-element.ts';
import { spokenStyles } from '../internal/spoken-styles.ts';
import { companionGap } from '../internal/view-width.ts';
import { VolumeLink } from '../internal/volume-link.ts';
import { emit } from '../internal/volume-view-events.ts';
import type { VolumeStep } from '../volume-step/volume-step.ts';
import { TourAutoplay } from './tour-autoplay.ts';
import { TourScroll } from './tour-scroll.ts';
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

/** Paths in a box of 24 by 24. */
const icons = {
  play: 'M8 5l11 7-11 7z',
  pause: 'M9 5v14M15 5v14',
  previous: 'M15 5l-7 7 7 7',
  next: 'M9 5l7 7-7 7',
  leave: 'M6 6l12 12M18 6L6 18',
};

/** What a person does before the picture turns. */
const uses = ['pointerdown', 'pointermove', 'wheel', 'keydown'] as const;

const classes = { play: 'play', pause: 'play', previous: 'turns', next: 'turns', leave: 'leave' };

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
  static override readonly styles = [companionGap, spokenStyles, styles];

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
  /** Through this the view gets the speed of its camera. */
  readonly #part: ViewPart = {
    key: 'tour',
    element: this,
    // A camera is at its place after five times this time, by the eye: 99.3 % of the way.
    attribute: (name) => (name === 'interpolationDecay' && this.hasAttribute('duration') ? `${this.#time / 5}` : null),
  };
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
  #guide: TourGuide | null = null;
  /** What the view got last; empty for nothing. */
  #given = '';
  /** The step of the last `step-change`; null before the first one. */
  #known: number | null = null;
  readonly #seen = new Set<VolumeStep>();
  #isComplete = false;
  /** Whether a person has turned the picture since the step opened. */
  #isTurned = false;
  /** Whether a person has used the view since then. The event of a picture that glides after a turn may come late. */
  #isUsed = false;
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
    this.#leaveView();
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
    attempt(() => (this.#time = this.#readTime()));
    attempt(() => (this.#isScrolled = this.#readBy()));
    attempt(() => (this.#number = this.#readNumber()));
    this.#number = Math.min(this.#number, this.#steps.length); // Steps may have been removed.
    attempt(() => (this.#dwell = this.#readDwell()));
    if (document.readyState === 'loading') return;
    this.#report(problems[0] ?? null);
    if (this.#known !== null && this.#known !== this.#number)
      this.#said = this.#isPlayed || this.#isScrolled ? '' : this.#describe();
  }

  /** @throws {VolumeViewError} `attribute/invalid` */
  #readTime(): number {
    const text = this.readText('duration');
    if (text === null) return usualDuration;
    const time = number.read(text);
    if (time !== null && time >= 0) return time;
    throw invalidAttribute('duration of <volume-tour>', text, 'milliseconds, 0 or more');
  }

  /** @throws {VolumeViewError} `attribute/invalid` */
  #readBy(): boolean {
    const text = this.readText('by')?.trim().toLowerCase() ?? '';
    if (text === '' || text === 'scroll') return text === 'scroll';
    throw invalidAttribute('by of <volume-tour>', text, 'scroll');
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

  /** @throws {VolumeViewError} `attribute/invalid`; the open step then stays */
  #readNumber(): number {
    const [text, count] = [this.readText('step'), this.#steps.length];
    if (count === 0) return 0;
    const given = text === null ? 1 : number.read(text);
    if (given !== null && Number.isInteger(given) && given >= 0 && given <= count) return given;
    throw invalidAttribute('step of <volume-tour>', text!, `the number of a step, 1 to ${count}, or 0 for none`);
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
    if (!view || this.#number === 0 || !value || this.#guide?.view !== view) this.#leaveView();
    if (view && this.#number > 0 && value) this.#show(view, value);
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

  /** Show a step in the view, unless it is there. */
  #show(view: HTMLElement, value: StepValue<Element>): void {
    const given = JSON.stringify([this.#number, value.settings.map(({ name, text }) => [name, text])]);
    if (given === this.#given) return;
    if (!this.#guide) {
      for (const { key, element } of socketOf(view).parts)
        if (key === this.localName && element !== this) (element as VolumeTour).leave();
      this.#guide = new TourGuide(view);
      void socketOf(view).join(this.#part);
      for (const type of uses) view.addEventListener(type, this.#onUse, { capture: true, passive: true });
      view.addEventListener('camera-change', this.#onTurn);
    }
    this.#given = given;
    if (this.#isTurned) this.requestUpdate(); // The button goes.
    this.#isTurned = false;
    this.#guide.open(value, this.#values, this.#time);
    this.#isUsed = false;
  }

  #leaveView(): void {
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

  /** Notify the page of another step. */
  #notify(): void {
    const [step, count] = [this.#number, this.#steps.length];
    if (count === 0 || step === this.#known) return;
    const isFirst = this.#known === null;
    this.#known = step;
    if (isFirst && step === 0) return;
    const open = this.#steps.at(step - 1)!;
    const detail: StepChangeDetail = { step, count, id: step > 0 ? open.id : '' };
    emit(this, 'step-change', detail);
    if (step > 0) this.#seen.add(open);
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

  readonly #onUse = (event: Event): void => {
    if (event.type !== 'pointermove' || (event as PointerEvent).buttons > 0) this.#isUsed = true;
  };

  readonly #onTurn = (): void => {
    const isPlaced = this.#values.some(({ settings }) =>
      settings.some(({ name }) => name.startsWith('camera-') || name === 'field-of-view'),
    );
    if (this.#isTurned || !this.#isUsed || !isPlaced) return;
    this.#isTurned = true;
    this.requestUpdate();
  };

  /** Back to the open step, after a person has turned the picture. */
  readonly #onBack = (): void => {
    this.#given = '';
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
    const isLoading = document.readyState === 'loading';
    return html`${this.#problem ? html`<p class="error" part="error" role="alert" lang="en">${this.#problem.message}</p>` : nothing}
      ${this.#link.view || isLoading ? nothing : html`<p class="hint" part="hint">${messages.noView(this.htmlFor)}</p>`}
      ${this.#steps.length === 0 || this.#isScrolled ? nothing : html`<div class="bar" part="bar" role="group" aria-label=${messages.tour}>${this.#number === 0 ? this.#renderWords(messages.tourStart, () => this.#choose(1)) : this.#renderButtons()}</div>`}
      <slot></slot>
      ${this.#isTurned ? html`<div class="bar back">${this.#renderWords(messages.tourBack, this.#onBack)}</div>` : nothing}
      <div class="spoken" role="status">${this.#said}</div>`;
  }

  #renderButtons(): unknown {
    const { messages } = this.#locale;
    const [step, count] = [this.#number, this.#steps.length];
    return html`${this.#renderPlay()}
      ${this.#renderIcon('previous', messages.tourPrevious, step === 1, () => this.#choose(step - 1))}
      <ol class="dots">${this.#steps.map((_, i) => this.#renderDot(i + 1))}</ol>
      ${this.#renderIcon('next', messages.tourNext, step === count, () => this.#choose(step + 1))}
      ${this.#renderIcon('leave', messages.tourLeave, false, () => this.#choose(0))}`;
  }

  #renderPlay(): unknown {
    const { play, pause } = this.#locale.messages;
    const { paused } = this;
    if (paused && !this.autoplay) return nothing;
    return this.#renderIcon(paused ? 'play' : 'pause', paused ? play : pause, false, () => this.#player.ask(paused));
  }

  #renderDot(step: number): unknown {
    const title = this.#titleOf(step);
    return html`<li><button type="button" part="dot" title=${title} aria-label=${`${this.#locale.number(step)}. ${title}`} aria-current=${step === this.#number ? 'step' : nothing} @click=${() => this.#choose(step)}></button></li>`;
  }

  #renderIcon(icon: keyof typeof icons, label: string, isDisabled: boolean, act: () => void): unknown {
    return html`<button type="button" class=${classes[icon]} part="button" title=${label} aria-label=${label} ?disabled=${isDisabled} @click=${act}>
      <svg viewBox="0 0 24 24" aria-hidden="true"><path d=${icons[icon]}></path></svg>
    </button>`;
  }

  #renderWords(text: string, act: () => void): unknown {
    return html`<button type="button" class="words" part="button" @click=${act}>${text}</button>`;
  }
}

declare global {
  interface HTMLElementTagNameMap {
    'volume-tour': VolumeTour;
  }
}
