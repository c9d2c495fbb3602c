import { html, nothing } from 'lit';
import type { Answering } from '../../src/viewer/questions/answering.ts';
import { maxText, takesSeveral } from '../../src/viewer/questions/question.ts';
import type { Choice, Question } from '../../src/viewer/questions/question.ts';
import type { QuestionLocale } from './question-locale.ts';

/** An answer of the list, with copies of what an author wrote. */
export interface WrittenChoice extends Choice {
  readonly nodes: readonly Node[];
}

/** Max number of answers. */
const maxChoices = 100;

/** The answers of the lists that are children of a question. */
export function readChoices(element: Element): WrittenChoice[] {
  const items = [...element.querySelectorAll(':scope > ul:not([slot]) > li, :scope > ol:not([slot]) > li')];
  return items.slice(0, maxChoices).map((item) => ({
    text: (item.textContent ?? '').trim().replace(/\s+/g, ' ').slice(0, maxText),
    isCorrect: item.hasAttribute('correct'),
    nodes: [...item.childNodes].map((node) => node.cloneNode(true)),
  }));
}

/** What an author wrote for a slot, as text. */
export function textOf(element: Element, slot: string): string {
  const parts = [...element.children].filter((one) => one.getAttribute('slot') === slot);
  return parts.map((one) => (one.textContent ?? '').trim().replace(/\s+/g, ' ')).join(' ');
}

export interface QuestionParts {
  /** null where it can't be read. */
  readonly question: Question | null;
  readonly choices: readonly WrittenChoice[];
  readonly problem: string | null;
  /** What is missing; null for nothing. */
  readonly lack: string | null;
  readonly unit: string;
  readonly hasHint: boolean;
  readonly isHinted: boolean;
  readonly answering: Answering;
  readonly locale: QuestionLocale;
  /** Empty for none. */
  readonly score: string;
  readonly submit: (event: Event) => void;
  readonly hint: () => void;
  readonly aim: () => void;
  /** The sentence for screen readers. */
  readonly said: unknown;
}

export function renderQuestion(parts: QuestionParts): unknown {
  const { question, problem, lack, submit, said } = parts;
  const error = problem && html`<p class="error" part="error" role="alert" lang="en">${problem}</p>`;
  if (!question) return html`<slot></slot>${error ?? nothing}${said}`;
  return html`<form class=${question.type} novalidate autocomplete="off" @submit=${submit}>
      <div id="text"><slot></slot></div>
      ${error ?? nothing}${lack ? html`<p>${lack}</p>` : nothing}
      ${renderTask(question, parts)}${renderButtons(question, parts)}${renderHint(parts)}${renderFeedback(question, parts)}
    </form>${said}`;
}

function renderTask(question: Question, { choices, unit, answering, locale: { messages } }: QuestionParts): unknown {
  const { isDone, chosen, result } = answering;
  switch (question.type) {
    case 'choice': {
      const several = takesSeveral(question);
      return html`${several ? html`<p class="task" id="task">${messages.questionChooseAll}</p>` : nothing}
        <div class="answers" part="answers" role=${several ? 'group' : 'radiogroup'} aria-labelledby="text" aria-describedby=${several ? 'task' : nothing}>
          ${choices.map(
            ({ nodes, isCorrect }, i) =>
              html`<label part="answer" class=${isDone && isCorrect ? 'right' : ''}>
                <input type=${several ? 'checkbox' : 'radio'} name="answer" .checked=${chosen.includes(i)} ?disabled=${isDone} />
                <span>${nodes}</span>${isDone && isCorrect ? html`<span aria-hidden="true">✓</span>` : nothing}
              </label>`,
          )}
        </div>`;
    }
    case 'find':
      return isDone ? nothing : html`<p class="task">${messages.questionFind}</p>`;
    case 'label':
    case 'value':
      return html`<div class="field" part="field">
        <input type="text" inputmode=${question.type === 'value' ? 'decimal' : 'text'} maxlength=${maxText} aria-labelledby="text" aria-describedby=${unit && question.type === 'value' ? 'unit' : nothing} spellcheck="false" autocapitalize="off" .value=${result?.response ?? ''} ?disabled=${isDone} />
        ${question.type === 'value' && unit ? html`<span id="unit">${unit}</span>` : nothing}
      </div>`;
  }
}

function renderButtons(
  { type }: Question,
  { answering, hasHint, isHinted, lack, locale: { messages }, hint, aim }: QuestionParts,
): unknown {
  if (answering.isDone) return nothing;
  const main =
    type !== 'find'
      ? html`<button part="button">${messages.questionAnswer}</button>`
      : lack
        ? nothing
        : html`<button type="button" class="aiming" part="button" @click=${aim}>${messages.questionCrosshair}</button>`;
  return html`<div class="buttons">
    ${main}${hasHint && !isHinted ? html`<button type="button" part="button" @click=${hint}>${messages.questionHint}</button>` : nothing}
  </div>`;
}

function renderHint({ answering, hasHint, isHinted }: QuestionParts): unknown {
  if (!hasHint || !isHinted || answering.isDone) return nothing;
  return html`<div class="hint" part="hint"><slot name="hint"></slot></div>`;
}

function renderFeedback(question: Question, { answering, locale, score }: QuestionParts): unknown {
  const { result, isDone, left } = answering;
  if (!result) return nothing;
  const { correct } = result;
  const solution = isDone && !correct ? solutionOf(question) : '';
  return html`<div class=${`feedback ${correct ? 'is-right' : 'is-wrong'}`} part="feedback" tabindex="-1">
    <p class="head">${locale.sayOutcome(correct, left)}</p>
    ${solution ? html`<p>${locale.messages.questionSolution(solution)}</p>` : nothing}
    <slot name=${correct ? 'right' : 'wrong'}></slot>
    ${score ? html`<p part="score">${score}</p>` : nothing}
  </div>`;
}

/** The right answer in words; empty for a place, which the picture shows. */
function solutionOf({ type, choices, answers }: Question): string {
  if (type !== 'choice') return answers[0] ?? '';
  return choices.flatMap(({ isCorrect, text }) => (isCorrect ? [text] : [])).join(', ');
}
