// The places of one question in the picture: the one that is asked for, and those that a reader shows.
import { VolumeViewError } from '../../core/errors.ts';
import type { NoteMessages } from '../../messages/note-messages.ts';
import type { QuestionMessages } from '../../messages/question-messages.ts';
import { stretchOf } from '../../radar/polar-geometry.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import { socketOf } from '../model/view-socket.ts';
import type { VolumePosition } from '../model/volume-pick.ts';
import { locateNote } from '../notes/note-place.ts';
import { Aim } from '../picking/aim.ts';
import type { AimedView, AimOwner } from '../picking/aim.ts';
import type { Answering } from './answering.ts';
import type { Question, Response } from './question.ts';
import { PlaceMark } from '../notes/place-mark.ts';

/** The sentences that it uses. */
export interface PlaceLocale {
  readonly messages: QuestionMessages & NoteMessages;
  /** A value with its unit. */
  value(value: number, unit: string): string;
  percent(share: number): string;
}

/** What it notifies. */
export interface PlaceListeners {
  /** A reader has shown a place; null where nothing is seen. */
  take(response: Response | null): void;
  /** The reader has ended the crosshair. */
  ended(): void;
  /** The reader has pressed the marked place. */
  pressed(): void;
}

export class QuestionPlaces implements AimOwner {
  /** Where the place of the question is, as `position` has it; null where it is not known. */
  place: Vector3 | null = null;
  readonly #asked: PlaceMark;
  readonly #given: PlaceMark;
  #question: Question | null = null;
  #view: AimedView | null = null;
  #aim: Aim | null = null;

  constructor(
    readonly element: HTMLElement,
    readonly answering: Answering,
    readonly locale: PlaceLocale,
    readonly listeners: PlaceListeners,
  ) {
    const messages = (): NoteMessages => locale.messages;
    this.#asked = new PlaceMark(element, messages, listeners.pressed);
    this.#given = new PlaceMark(element, messages, () => {});
  }

  /** False in a closed step, also where its text is visible: in a tour that follows the page. */
  get #isAsked(): boolean {
    const step = this.element.closest('volume-tour volume-step');
    return this.element.offsetWidth > 0 && (!step || step.matches(':is(:state(open), [data-state-open])'));
  }

  get isWaiting(): boolean {
    return this.#question?.type === 'find' && !this.answering.isDone && this.#isAsked;
  }

  get crosshair(): string {
    return this.locale.messages.questionCrosshair;
  }

  get crosshairKeys(): string {
    return this.locale.messages.questionCrosshairKeys;
  }

  describe(found: VolumePosition | null, across: number, down: number): string {
    const { messages } = this.locale;
    // The name of a label would be the answer.
    const value = found && Number.isFinite(found.value) ? this.locale.value(found.value, found.unit) : '';
    const what = found ? value || messages.questionPlace : messages.questionNothing;
    return messages.questionUnder(what, this.locale.percent(across), this.locale.percent(down));
  }

  take(found: VolumePosition | null): void {
    this.listeners.take(
      found && { position: found.position, ...(found.label !== undefined && { label: found.label }) },
    );
  }

  ended(byKey: boolean): void {
    if (byKey) this.listeners.ended();
  }

  /** Show the crosshair. */
  aim(): void {
    if (this.isWaiting) this.#aim?.begin(this);
  }

  /** Show what a question shows now. @throws {VolumeViewError} `attribute/invalid` where its place can't be found */
  show(question: Question | null, view: HTMLElement | null): void {
    [this.#question, this.place] = [question, null];
    const picture = view?.shadowRoot?.querySelector<HTMLElement>('.picture') ?? null;
    if (!question || !view || !picture) return this.leave();
    if (this.#view !== view) this.leave();
    this.#view = view as AimedView;
    if (question.type === 'find') {
      this.#aim ??= Aim.of(this.#view, picture);
      this.#aim.add(this);
    }
    const { volume } = socketOf(view);
    const stretch = volume ? stretchOf(volume.grid) : 1;
    const [x, y, z] = this.#locate(view) ?? [NaN, NaN, NaN];
    if (Number.isFinite(x)) this.place = [x, y, z / stretch];
    const isSeen = volume !== null && this.#isAsked;
    const { messages } = this.locale;
    const { isDone, position, result } = this.answering;
    // The place to find is shown after the last try.
    const isShown = question.type !== 'find' || (isDone && result?.correct === false);
    const label = question.type === 'find' ? messages.questionSolutionPlace : messages.questionPlace;
    this.#asked.show(view, picture, isSeen && isShown && this.place ? { at: [x, y, z], label } : null);
    const given = question.type === 'find' && isSeen ? position : null;
    this.#given.show(
      view,
      picture,
      given && { at: [given[0], given[1], given[2] * stretch], label: messages.questionYours },
    );
  }

  /** The question is no longer in the page, or belongs to another view. */
  leave(): void {
    this.#aim?.drop(this);
    this.#aim = this.#view = null;
    for (const mark of [this.#asked, this.#given]) mark.show(null, null, null);
  }

  /** In the world as it is drawn. */
  #locate(view: HTMLElement): Vector3 | null {
    const { volume } = socketOf(view);
    if (!volume || !this.#question?.place) return null;
    try {
      return locateNote(this.#question.place, {
        volume,
        labels: socketOf(view).last('labels')?.shown ?? null,
        labelsMayCome: view.querySelector('volume-labels, segmentedvolumedata') !== null,
      });
    } catch (error) {
      const { message } = error as VolumeViewError;
      throw new VolumeViewError('attribute/invalid', message.replaceAll('<volume-note>', '<volume-question>'));
    }
  }
}
