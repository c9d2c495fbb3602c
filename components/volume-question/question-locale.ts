import type { ReactiveControllerHost } from 'lit';
import { english as companions } from '../../src/messages/english-companions.ts';
import { english as notes } from '../../src/messages/english-notes.ts';
import { english as questions } from '../../src/messages/english-questions.ts';
import { LocaleController } from '../../src/messages/locale-controller.ts';
import type { CompanionMessages } from '../../src/messages/messages.ts';
import type { NoteMessages } from '../../src/messages/note-messages.ts';
import type { QuestionMessages } from '../../src/messages/question-messages.ts';
import type { AnswerDetail } from '../../src/viewer/questions/answering.ts';

/** The sentences of a question. */
export class QuestionLocale extends LocaleController<CompanionMessages & NoteMessages & QuestionMessages> {
  constructor(host: ReactiveControllerHost & HTMLElement) {
    super(host, { ...companions, ...notes, ...questions });
  }

  value(value: number, unit: string): string {
    return [this.number(value, { maximumSignificantDigits: 4 }), unit].filter((text) => text !== '').join(' ');
  }

  percent(share: number): string {
    return this.number(share, { style: 'percent' });
  }

  /** @param left - how many tries are left */
  sayOutcome(isRight: boolean, left: number): string {
    const { questionRight, questionWrong, questionTriesLeft } = this.messages;
    if (isRight) return questionRight;
    return Number.isFinite(left) && left > 0
      ? `${questionWrong} ${questionTriesLeft(this.number(left))}`
      : questionWrong;
  }

  /** How many questions of the tour around it are answered right, else of the page; empty where it is the only one. */
  sayScore(question: HTMLElement): string {
    const scope = question.closest('volume-tour') ?? (question.getRootNode() as Document | ShadowRoot);
    const all = [
      ...scope.querySelectorAll<HTMLElement & { readonly result?: AnswerDetail | null }>(question.localName),
    ];
    const right = all.filter(({ result }) => result?.correct);
    return all.length > 1 ? this.messages.questionScore(this.number(right.length), this.number(all.length)) : '';
  }
}
