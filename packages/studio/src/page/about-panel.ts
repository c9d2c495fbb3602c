// Title, credits and licence, which the exports show, and the scan.
import { html } from 'lit';
import type { Lesson } from '../model/lesson.ts';
import { textField } from './fields.ts';
import type { Studio } from './studio.ts';

type Field = 'title' | 'alt' | 'language' | 'credits' | 'licence';

/** One of the fields, which are in this panel and in the dialog of the exports. @param prefix - of its id */
export function aboutField(studio: Studio, name: Field, prefix: string): unknown {
  const { words, lesson } = studio;
  const hints: Partial<Record<Field, string>> = {
    alt: words.altHint,
    language: words.languageHint,
    credits: words.creditsHint,
    licence: words.licenceHint,
  };
  return textField({
    id: `${prefix}-${name}`,
    label: words[name],
    value: lesson[name],
    ...(hints[name] ? { hint: hints[name] } : {}),
    isNeeded: name !== 'alt',
    onInput: (text) => studio.edit((before: Lesson) => ({ ...before, [name]: text }), { mark: name }),
  });
}

export function renderAbout(studio: Studio): unknown {
  const { words } = studio;
  return html`<h2>${words.aboutTitle}</h2>
    ${(['title', 'alt', 'credits', 'licence', 'language'] as const).map((name) => aboutField(studio, name, 'about'))}
    <h2>${words.dataTitle}</h2>
    <p class="hint">${words.faceWarning}</p>
    <button id="change-data" @click=${() => studio.showStart()}>${words.changeData}</button>`;
}
