// Names at places of the volume.
import { html, nothing } from 'lit';
import { repeat } from 'lit/directives/repeat.js';
import { changeNote, removeNote } from '../model/edit.ts';
import type { Note } from '../model/lesson.ts';
import { textField } from './fields.ts';
import { icon } from './icons.ts';
import type { Studio } from './studio.ts';

export function renderNotes(studio: Studio): unknown {
  const { words, lesson } = studio;
  return html`<h2>${words.notesTitle}</h2>
    ${lesson.notes.length === 0 ? html`<p class="hint">${words.notesEmpty}</p>` : nothing}
    <ol class="cards">
      ${repeat(
        lesson.notes,
        ({ id }) => id,
        (note, i) => renderNote(studio, note, i + 1),
      )}
    </ol>
    <button class="primary" id="add-note" @click=${() => studio.beginPlacing({ kind: 'note', id: null })}>${icon('place')} ${words.addNote}</button>`;
}

function renderNote(studio: Studio, note: Note, number: number): unknown {
  const { words, before } = studio;
  const isOpen = before.note === note.id;
  const set = (name: 'label' | 'text' | 'position', text: string): void =>
    studio.edit((lesson) => changeNote(lesson, note.id, { [name]: text }), { mark: `${note.id} ${name}` });
  return html`<li class=${isOpen ? 'card open' : 'card'}>
    <h3><button class="head" id=${`${note.id}-open`} aria-expanded=${isOpen} @click=${() => studio.show({ note: isOpen ? null : note.id })}>${words.note(number, note.label)}</button></h3>
    ${
      isOpen
        ? html`<div class="body">
            ${textField({ id: `${note.id}-label`, label: words.noteName, value: note.label, onInput: (text) => set('label', text) })}
            ${textField({ id: `${note.id}-text`, label: words.noteText, value: note.text, rows: 3, onInput: (text) => set('text', text) })}
            ${textField({ id: `${note.id}-position`, label: words.notePlace, value: note.position, onInput: (text) => set('position', text) })}
            <div class="row">
              <button @click=${() => studio.beginPlacing({ kind: 'note', id: note.id })}>${icon('place')} ${words.moveNote}</button>
              <button class="quiet" @click=${() => remove(studio, note.id)}>${icon('remove')} ${words.deleteNote}</button>
            </div>
          </div>`
        : nothing
    }
  </li>`;
}

function remove(studio: Studio, id: string): void {
  studio.focusNext = '#add-note';
  studio.edit((lesson) => removeNote(lesson, id));
}
