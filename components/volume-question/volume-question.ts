import { html, nothing } from 'lit';
import type { PropertyValues } from 'lit';
import { asVolumeViewError } from '../../src/core/errors.ts';
import type { VolumeViewError } from '../../src/core/errors.ts';
import { Answering } from '../../src/viewer/questions/answering.ts';
import type { AnswerDetail } from '../../src/viewer/questions/answering.ts';
import { readQuestion } from '../../src/viewer/questions/question.ts';
import type { Question, Response } from '../../src/viewer/questions/question.ts';
import { QuestionPlaces } from '../../src/viewer/questions/question-places.ts';
import { blockStyles, textButtonStyles } from '../internal/block-styles.ts';
import { flag, number, vector } from '../internal/property-kinds.ts';
import { property, ReflectingElement } from '../internal/reflecting-element.ts';
import { spokenStyles } from '../internal/spoken-styles.ts';
import { VolumeLink } from '../internal/volume-link.ts';
import { emit } from '../internal/volume-view-events.ts';
import type { Vector3 } from '../../src/volume/matrix.ts';
import { QuestionLocale } from './question-locale.ts';
import { readChoices, renderQuestion, textOf } from './volume-question-parts.ts';
import type { WrittenChoice } from './volume-question-parts.ts';
import { styles } from './volume-question-styles.ts';

/**
 * A question about a volume, next to its `<volume-view>` or in a `<volume-step>`: choose an answer, find a place in the picture, name a
 * marked place, or read a value. It says whether an answer is right, and sends nothing anywhere.
 *
 * `<volume-question for="head"><p>Which part is this?</p><ul><li correct>The thalamus</li><li>The pons</li></ul></volume-question>`
 *
 * Without scripts it is a text with a list.
 *
 * @tag volume-question
 * @slot - the question, and for `choice` a list of answers: those with the attribute `correct` are right
 * @slot hint - shown after a wrong answer, or when a reader asks for it
 * @slot right - shown after the right answer
 * @slot wrong - shown after a wrong answer
 * @csspart answers - the list of answers
 * @csspart answer - each answer of the list
 * @csspart field - the field for a name or a value
 * @csspart button - each button
 * @csspart hint - the box around the hint
 * @csspart feedback - the box that says whether the answer is right
 * @csspart score - how many questions are answered right
 * @csspart error - the text where an attribute can't be read
 * @cssproperty --volume-question-color - colour of a chosen answer
 * @cssproperty --volume-question-right-color - colour of what is right
 * @cssproperty --volume-question-wrong-color - colour of what is wrong
 * @cssproperty --volume-view-focus-color - colour of the ring around the element with the focus; by default that of the text
 * @fires {CustomEvent<AnswerDetail>} answer - a reader has answered; it bubbles
 * @fires {CustomEvent<ErrorDetail>} error - an attribute can't be read, or the place is not known
 */
export class VolumeQuestion extends ReflectingElement {
  static override readonly styles = [blockStyles, textButtonStyles, spokenStyles, styles];

  /** The id of the `<volume-view>`; by default the nearest one. */
  @property({ attribute: 'for' }) htmlFor!: string | null;

  /**
   * What a reader does: `choice` (an answer of a list), `find` (a place in the picture), `label` (the name of a marked place) or `value` (a
   * value).
   * @default choice
   */
  @property() type!: string | null;

  /** The place to find, or the marked place: `x y z` in world units, as `position` of a `<volume-note>`. */
  @property({ kind: vector }) position!: Vector3 | null;

  /** In place of `position`: the id of a label. To find one of several labels, their ids, separated by blanks. */
  @property() of!: string | null;

  /** In place of `position`, for a radar: degrees north. */
  @property({ kind: number }) latitude!: number | null;

  /** Degrees east. */
  @property({ kind: number }) longitude!: number | null;

  /**
   * With `latitude` and `longitude`: metres above sea level where the file gives the altitude of the radar, else above its antenna.
   * @default 0
   */
  @property({ kind: number }) height!: number | null;

  /** How far from the place to find a reader may click, in world units. */
  @property({ kind: number }) radius!: number | null;

  /** `label`: the names that are right, separated by commas; case, accents and hyphens do not matter. `value`: the right value. */
  @property() answer!: string | null;

  /**
   * `value`: how far from the right value an answer may be.
   * @default 0
   */
  @property({ kind: number }) tolerance!: number | null;

  /** `value`: the unit, shown after the field. */
  @property() unit!: string | null;

  /** How often a reader may answer. If absent: until the answer is right. */
  @property({ kind: number }) tries!: number | null;

  /** Whether the page keeps the answer in its own storage, so that it survives a reload. It needs an `id`. */
  @property({ kind: flag }) remember!: boolean;

  readonly #locale = new QuestionLocale(this);
  readonly #link = new VolumeLink(this, () => this.requestUpdate(), ['load', 'labels-change']);
  readonly #answering = new Answering(this);
  readonly #places = new QuestionPlaces(this, this.#answering, this.#locale, {
    take: (response) => this.#take(response, false),
    ended: () => void this.#focusOn(this.#answering.isDone ? '.feedback' : '.aiming'),
    pressed: () => void this.#focusOn('.field input'),
  });
  readonly #sizes = new ResizeObserver(() => this.#showPlaces());
  #choices: readonly WrittenChoice[] = [];
  #areChoicesRead = false;
  #question: Question | null = null;
  #problem: VolumeViewError | null = null;
  #isHinted = false;
  #said = '';
  #root: Node | null = null;
  #tour: Element | null = null;

  constructor() {
    super();
    new MutationObserver(() => {
      this.#areChoicesRead = false;
      this.requestUpdate();
    }).observe(this, {
      attributes: true,
      characterData: true,
      childList: true,
      subtree: true,
    });
    if (document.readyState === 'loading')
      document.addEventListener('DOMContentLoaded', () => this.requestUpdate(), { once: true });
  }

  /** The last answer; null before there is one. */
  get result(): AnswerDetail | null {
    return this.#answering.result;
  }

  /** Whether there is nothing more to answer: the answer is right, or there are no tries left. */
  get done(): boolean {
    return this.#answering.isDone;
  }

  /** Forget the answers, also those that the page keeps, and ask again. */
  reset(): void {
    this.#answering.reset();
    this.#isHinted = false;
    this.#said = '';
    this.shadowRoot?.querySelector('form')?.reset();
    this.requestUpdate();
  }

  /**
   * Show an answer that the reader gave earlier: the detail of its event `answer`, which a page or a course has kept. It fires no event.
   * Whether it is right is not judged again.
   */
  restore(answer: Omit<AnswerDetail, 'id'>): void {
    this.#answering.restore(answer);
    this.#isHinted = !answer.correct;
    this.requestUpdate();
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.#sizes.observe(this); // In a closed step it has no size.
    this.#root = this.getRootNode();
    this.#root.addEventListener('answer', this.#onChange);
    this.#tour = this.closest('volume-tour');
    this.#tour?.addEventListener('step-change', this.#onChange);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#sizes.disconnect();
    this.#root?.removeEventListener('answer', this.#onChange);
    this.#tour?.removeEventListener('step-change', this.#onChange);
    queueMicrotask(() => {
      if (!this.isConnected) this.#places.leave();
    });
  }

  protected override willUpdate(changed: PropertyValues<this>): void {
    if (changed.has('htmlFor') && this.hasUpdated) this.#link.find();
    if (document.readyState === 'loading') return;
    if (!this.#areChoicesRead) this.#choices = readChoices(this);
    this.#areChoicesRead = true;
    try {
      this.#question = readQuestion((name) => this.getAttribute(name), this.#choices);
      this.#answering.ask(this.#question, this.remember ? this.id : '');
      this.#report(null);
    } catch (thrown) {
      this.#question = null;
      this.#report(asVolumeViewError(thrown, '<volume-question>'));
    }
  }

  protected override updated(): void {
    this.#showPlaces();
  }

  #showPlaces(): void {
    try {
      this.#places.show(this.#question, this.#link.view);
    } catch (thrown) {
      this.#report(asVolumeViewError(thrown, '<volume-question>'));
      this.requestUpdate();
    }
  }

  /** Send an error to the page, unless it is the last one. */
  #report(error: VolumeViewError | null): void {
    const isNew = error?.message !== this.#problem?.message;
    this.#problem = error;
    if (error && isNew) emit(this, 'error', { code: error.code, message: error.message, cause: error.cause });
  }

  readonly #onChange = (): void => this.requestUpdate();

  readonly #onSubmit = (event: Event): void => {
    event.preventDefault();
    const inputs = [...(event.target as HTMLFormElement).querySelectorAll('input')];
    const [field] = inputs;
    const chosen = inputs.flatMap(({ checked }, i) => (checked ? [i] : []));
    const response: Response = this.#question?.type === 'choice' ? { chosen } : { text: field.value.trim() };
    if ('chosen' in response ? chosen.length > 0 : field.value.trim() !== '') this.#take(response, true);
    else {
      this.#said = this.#locale.messages.questionEmpty;
      this.requestUpdate();
      inputs[0]?.focus();
    }
  };

  /** @param byForm - then the focus goes to what is said about the answer, as the form ends */
  #take(response: Response | null, byForm: boolean): void {
    const [{ messages }, question] = [this.#locale, this.#question];
    if (!question || this.#answering.isDone) return;
    if (!response) this.#said = messages.questionNothing;
    else {
      const detail = this.#answering.answer(question, response, this.#places.place);
      if (!detail.correct) this.#isHinted = true;
      this.#said = this.#describe(detail);
      this.dispatchEvent(new CustomEvent('answer', { detail, bubbles: true }));
      if (byForm && this.#answering.isDone) void this.#focusOn('.feedback');
      else
        void this.updateComplete.then(() =>
          this.shadowRoot!.querySelector('.feedback')?.scrollIntoView({ block: 'nearest' }),
        );
    }
    this.requestUpdate();
  }

  /** The sentence for screen readers. */
  #describe({ correct }: AnswerDetail): string {
    const head = this.#locale.sayOutcome(correct, this.#answering.left);
    const more = ['hint', correct ? 'right' : 'wrong'].filter((slot) => slot !== 'hint' || !correct);
    return [head, ...more.map((slot) => textOf(this, slot))].filter((text) => text !== '').join(' ');
  }

  async #focusOn(selector: string): Promise<void> {
    await this.updateComplete;
    this.shadowRoot!.querySelector<HTMLElement>(selector)?.focus();
  }

  protected override render(): unknown {
    const { messages } = this.#locale;
    return renderQuestion({
      question: this.#question,
      choices: this.#choices,
      problem: this.#problem?.message ?? null,
      lack:
        this.#link.view || !this.#question || this.#question.type === 'choice' ? null : messages.noView(this.htmlFor),
      unit: this.unit ?? this.#link.volume?.unit ?? '',
      hasHint: this.querySelector(':scope > [slot=hint]') !== null,
      isHinted: this.#isHinted,
      answering: this.#answering,
      locale: this.#locale,
      score: this.#answering.result && this.#answering.isDone ? this.#locale.sayScore(this) : '',
      submit: this.#onSubmit,
      hint: () => {
        this.#isHinted = true;
        this.#said = textOf(this, 'hint');
        this.requestUpdate();
      },
      aim: () => this.#places.aim(),
      said: html`<div class="spoken" role="status">${this.#said || nothing}</div>`,
    });
  }
}

declare global {
  interface HTMLElementTagNameMap {
    'volume-question': VolumeQuestion;
  }
}
