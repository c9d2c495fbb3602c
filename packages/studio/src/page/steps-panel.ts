// The steps of the lesson: each one keeps a view, and has a title, a text and questions.
import { html, nothing } from 'lit';
import { repeat } from 'lit/directives/repeat.js';
import { changeStep, isSameView, moveStep } from '../model/edit.ts';
import type { Step } from '../model/lesson.ts';
import { textField } from './fields.ts';
import { icon } from './icons.ts';
import type { Painter } from './painter.ts';
import { renderQuestions } from './questions-panel.ts';
import type { Studio } from './studio.ts';

export function renderSteps(studio: Studio, painter: Painter): unknown {
  const { words, lesson } = studio;
  return html`<h2>${words.stepsTitle}</h2>
    ${lesson.steps.length === 0 ? html`<p class="hint">${words.stepsEmpty}</p>` : nothing}
    <ol class="cards">
      ${repeat(
        lesson.steps,
        ({ id }) => id,
        (step, i) => renderStep(studio, painter, { step, number: i + 1 }),
      )}
    </ol>
    <button class="primary" id="add-step" @click=${() => studio.addStep()}>${icon('add')} ${words.addStep}</button>`;
}

interface NumberedStep {
  readonly step: Step;
  /** From 1. */
  readonly number: number;
}

function renderStep(studio: Studio, painter: Painter, { step, number }: NumberedStep): unknown {
  const { words, before } = studio;
  const isOpen = before.step === step.id;
  const picture = painter.draw(step.view, true);
  return html`<li class=${isOpen ? 'card open' : 'card'} id=${step.id}>
    <h3><button class="head" id=${`${step.id}-open`} aria-expanded=${isOpen} @click=${() => studio.openStep(isOpen ? null : step.id)}>
      ${picture && picture !== 'none' ? html`<img src=${picture} alt="" width="72" height="54" />` : html`<span class="blank"></span>`}
      <span>${words.step(number, step.title)}</span>
    </button></h3>
    ${isOpen ? renderBody(studio, { step, number }) : nothing}
  </li>`;
}

function renderBody(studio: Studio, { step, number }: NumberedStep): unknown {
  const { words, lesson } = studio;
  const { id } = step;
  const set = (name: 'title' | 'text', text: string): void =>
    studio.edit((before) => changeStep(before, id, { [name]: text }), { mark: `${id} ${name}` });
  const isSeen = isSameView(studio.seen, step.view);
  const move = (by: number, button: string): void => {
    studio.edit((before) => moveStep(before, id, by));
    const at = studio.lesson.steps.findIndex((one) => one.id === id) + 1;
    studio.focusNext = `#${id}-${button}`;
    studio.show({ said: words.stepMoved(at, studio.lesson.steps.length) });
  };
  return html`<div class="body">
    ${textField({ id: `${id}-title`, label: words.stepTitle, value: step.title, onInput: (text) => set('title', text) })}
    ${textField({ id: `${id}-text`, label: words.stepText, value: step.text, rows: 4, hint: words.stepTextHint, onInput: (text) => set('text', text) })}
    <div class=${isSeen ? 'seen' : 'seen changed'}>
      <p>${isSeen ? words.stepKept : words.stepChanged}</p>
      ${
        isSeen
          ? nothing
          : html`<div class="row">
              <button id=${`${id}-update`} @click=${() => studio.edit((before) => changeStep(before, id, { view: before.view }), { withCamera: true })}>${icon('camera')} ${words.updateStep}</button>
              <button id=${`${id}-show`} @click=${() => studio.openStep(id)}>${words.showStep}</button>
            </div>`
      }
    </div>
    ${lesson.notes.length > 0 ? renderNotesOf(studio, step) : nothing}
    ${renderQuestions(studio, step)}
    <div class="row">
      <button id=${`${id}-up`} ?disabled=${number === 1} @click=${() => move(-1, 'up')}>${icon('up')} ${words.stepUp}</button>
      <button id=${`${id}-down`} ?disabled=${number === lesson.steps.length} @click=${() => move(1, 'down')}>${icon('down')} ${words.stepDown}</button>
      <button class="quiet" id=${`${id}-delete`} @click=${() => studio.removeStep(id)}>${icon('remove')} ${words.deleteStep}</button>
    </div>
  </div>`;
}

function renderNotesOf(studio: Studio, { id, notes }: Step): unknown {
  const { words, lesson } = studio;
  const toggle = (note: string): void =>
    studio.edit((before) =>
      changeStep(before, id, { notes: notes.includes(note) ? notes.filter((one) => one !== note) : [...notes, note] }),
    );
  return html`<fieldset>
    <legend>${words.stepNotes}</legend>
    ${lesson.notes.map(
      (note, i) =>
        html`<label class="check"><input type="checkbox" .checked=${notes.includes(note.id)} @change=${() => toggle(note.id)} /> ${words.note(i + 1, note.label)}</label>`,
    )}
  </fieldset>`;
}
