// The questions of a step.
import { html, nothing } from 'lit';
import { repeat } from 'lit/directives/repeat.js';
import { changeQuestion, removeQuestion } from '../model/edit.ts';
import type { Answer, Question, QuestionType, Step } from '../model/lesson.ts';
import { textField } from './fields.ts';
import { icon } from './icons.ts';
import type { Studio } from './studio.ts';

const types: readonly QuestionType[] = ['choice', 'find', 'label', 'value'];

type Field = Exclude<keyof Question, 'id' | 'type' | 'answers'>;

export function renderQuestions(studio: Studio, step: Step): unknown {
  const { words } = studio;
  return html`<fieldset class="questions">
    <legend>${words.questions}</legend>
    ${repeat(
      step.questions,
      ({ id }) => id,
      (question, i) => renderQuestion(studio, question, { number: i + 1, stepId: step.id }),
    )}
    <p class="hint" id=${`${step.id}-add`}>${words.addQuestion}</p>
    <div class="row" role="group" aria-labelledby=${`${step.id}-add`}>
      ${types.map((type) => html`<button class="small" @click=${() => studio.addQuestion(step.id, type)}>${icon('add')} ${words.questionTypes[type]}</button>`)}
    </div>
  </fieldset>`;
}

function renderQuestion(
  studio: Studio,
  question: Question,
  { number, stepId }: { readonly number: number; readonly stepId: string },
): unknown {
  const { words } = studio;
  const { id, type } = question;
  const field = (name: Field, label: string, rows?: number): unknown =>
    textField({
      id: `${id}-${name}`,
      label,
      value: question[name],
      ...(rows ? { rows } : {}),
      onInput: (text) =>
        studio.edit((lesson) => changeQuestion(lesson, id, { [name]: text }), { mark: `${id} ${name}` }),
    });
  const remove = (): void => {
    studio.focusNext = `#${stepId}-title`;
    studio.edit((lesson) => removeQuestion(lesson, id));
  };
  return html`<section class="question" id=${id} aria-label=${words.question(number)}>
    <h4>${words.question(number)}: ${words.questionTypes[type]}</h4>
    ${field('title', words.questionTitle, 2)}
    ${type === 'choice' ? renderAnswers(studio, question) : nothing}
    ${
      type === 'find' || type === 'label'
        ? html`${field('position', words.questionPlace)}
            <button @click=${() => studio.beginPlacing({ kind: 'question', id })}>${icon('place')} ${words.choosePlace}</button>`
        : nothing
    }
    ${type === 'find' ? field('radius', words.radius) : nothing}
    ${type === 'label' ? field('answer', words.names) : nothing}
    ${type === 'value' ? [field('answer', words.value), field('tolerance', words.tolerance)] : nothing}
    <details>
      <summary>${words.moreOfQuestion}</summary>
      ${field('hint', words.hint)} ${field('tries', words.tries)} ${field('right', words.right)} ${field('wrong', words.wrong)}
    </details>
    <button class="quiet" @click=${remove}>${icon('remove')} ${words.deleteQuestion}</button>
  </section>`;
}

function renderAnswers(studio: Studio, { id, answers }: Question): unknown {
  const { words } = studio;
  const set = (next: readonly Answer[], mark?: string): void =>
    studio.edit((lesson) => changeQuestion(lesson, id, { answers: next }), mark ? { mark } : {});
  const change = (at: number, changes: Partial<Answer>): Answer[] =>
    answers.map((one, i) => (i === at ? { ...one, ...changes } : one));
  const add = (): void => {
    studio.focusNext = `#${id}-answer-${answers.length}`;
    set([...answers, { text: '', isCorrect: false }]);
  };
  return html`<fieldset class="answers">
    <legend>${words.answers}</legend>
    ${answers.map(
      ({ text, isCorrect }, i) => html`<div class="answer">
        <label class="check"><input type="checkbox" aria-label=${words.isCorrect(i + 1)} .checked=${isCorrect} @change=${() => set(change(i, { isCorrect: !isCorrect }))} /> <span aria-hidden="true">${words.correct}</span></label>
        <input type="text" id=${`${id}-answer-${i}`} aria-label=${words.answer(i + 1)} placeholder=${words.answer(i + 1)} .value=${text} @input=${({ target }: Event) => set(change(i, { text: (target as HTMLInputElement).value }), `${id} answer ${i}`)} />
        <button class="quiet icon-only" aria-label=${words.deleteAnswer(i + 1)} title=${words.deleteAnswer(i + 1)} ?disabled=${answers.length <= 2} @click=${() => set(answers.filter((_, j) => j !== i))}>${icon('remove')}</button>
      </div>`,
    )}
    <button class="small" @click=${add}>${icon('add')} ${words.addAnswer}</button>
  </fieldset>`;
}
