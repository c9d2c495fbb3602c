import type { Vector3 } from '../../volume/matrix.ts';
import { KeptAnswers } from './kept-answers.ts';
import { isRight } from './question.ts';
import type { Question, Response } from './question.ts';

/** Detail of `answer`. */
export interface AnswerDetail {
  /** The id of the `<volume-question>`; empty where it has none. */
  readonly id: string;
  /** The chosen answers, separated by commas; the place `x y z`; or the text of the field. */
  readonly response: string;
  /** Numbers of the chosen answers in the list, from 0; empty for other types of questions. */
  readonly chosen: readonly number[];
  readonly correct: boolean;
  /** How many answers the reader has given, with this one. */
  readonly tries: number;
}

const kept = (): KeptAnswers => new KeptAnswers(() => localStorage, location.pathname);

/** The answers to one question so far. */
export class Answering {
  result: AnswerDetail | null = null;
  #tries = Infinity;
  #asked = '';
  #storedAs = '';

  constructor(readonly element: Pick<HTMLElement, 'id'>) {}

  /** How many tries are left; Infinity for any number. */
  get left(): number {
    return this.#tries - (this.result?.tries ?? 0);
  }

  /** Numbers of the answers that were chosen last. */
  get chosen(): readonly number[] {
    return this.result?.chosen ?? [];
  }

  get isDone(): boolean {
    return this.result !== null && (this.result.correct || this.left <= 0);
  }

  /** A place that the reader has shown; null where there is none. */
  get position(): Vector3 | null {
    const numbers = (this.result?.response ?? '').split(' ').map(Number);
    return numbers.length === 3 && numbers.every(Number.isFinite) ? (numbers as unknown as Vector3) : null;
  }

  /** @param storedAs - the id under which the page keeps the answer; empty where it keeps none */
  ask(question: Question, storedAs: string): void {
    const asked = JSON.stringify(question);
    this.#tries = question.tries;
    if (asked === this.#asked && storedAs === this.#storedAs) return;
    if (this.#asked !== '' && asked !== this.#asked) this.result = null;
    [this.#asked, this.#storedAs] = [asked, storedAs];
    const found = storedAs && !this.result ? kept().recall(storedAs, asked) : null;
    if (!found) return;
    const { response, chosen, correct, tries } = found;
    this.result = { id: storedAs, response, chosen, correct, tries };
  }

  /** Take an answer that was given earlier, and kept elsewhere. */
  restore({ response, chosen, correct, tries }: Omit<AnswerDetail, 'id'>): void {
    this.result = { id: this.element.id, response, chosen, correct, tries };
  }

  /** @param place - of the question, as `position` has it; null where it is not known */
  answer(question: Question, response: Response, place: Vector3 | null): AnswerDetail {
    this.result = {
      id: this.element.id,
      response: writeResponse(question, response),
      chosen: 'chosen' in response ? response.chosen : [],
      correct: isRight(question, response, place),
      tries: (this.result?.tries ?? 0) + 1,
    };
    if (this.#storedAs) kept().keep(this.#storedAs, { ...this.result, asked: this.#asked });
    return this.result;
  }

  reset(): void {
    if (this.#storedAs) kept().forget(this.#storedAs);
    this.result = null;
  }
}

function writeResponse({ choices }: Question, response: Response): string {
  if ('chosen' in response) return response.chosen.map((i) => choices[i]?.text ?? '').join(', ');
  return 'text' in response ? response.text : response.position.map((x) => Number(x.toPrecision(7))).join(' ');
}
