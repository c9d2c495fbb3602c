// Writes a lesson as HTML: all texts of the author are escaped here.
import { escapeMarkup } from '../../../lesson-writers/src/index.ts';
import type { Lesson, Note, Question, Step, ViewAttributes } from './lesson.ts';

/** The id of the view in what is written. */
export const viewId = 'volume';

/**
 * What stands between the tags of the body.
 * @param src - of the volume, from the page
 * @param poster - of the picture that is shown first
 */
export function writeLessonHtml(lesson: Lesson, src: string, poster?: string): string {
  const { title, alt, notes, steps } = lesson;
  const base = baseView(lesson);
  const { slice, ...own } = base;
  const opening = attributesOf({ id: viewId, src, ...(poster ? { poster } : {}), alt: alt || title, ...own });
  const hasSlice = slice !== undefined || steps.some(({ view }) => view.slice !== undefined);
  const inside = [...notes.map(writeNote), ...(hasSlice ? [writeSlice(slice)] : [])];
  const view = `<volume-view${opening} controls controlslist="nocopy noembed nolink">${inside.map((line) => `\n  ${line}`).join('')}${inside.length > 0 ? '\n' : ''}</volume-view>`;
  const tour =
    steps.length > 0
      ? `\n<volume-tour for="${viewId}">\n${steps.map((step) => writeStep(step, base)).join('\n')}\n</volume-tour>`
      : '';
  return `<h1>${escapeMarkup(title)}</h1>\n<div class="lesson">\n${view}${tour}\n</div>\n`;
}

/** What all steps have: it stands on the view itself. A step that lacks an attribute could not take it away. */
export function baseView({ steps, view }: Lesson): ViewAttributes {
  if (steps.length === 0) return view;
  const [first, ...others] = steps;
  return Object.fromEntries(
    Object.entries(first.view).filter(([name, text]) => others.every((step) => step.view[name] === text)),
  );
}

function writeNote({ id, position, label, text }: Note): string {
  return `<volume-note${attributesOf({ id, position, label })}>${writeParagraphs(text)}</volume-note>`;
}

/** A slice that is hidden until a step shows it. @param slice - as the attribute of a step, 'axial 20' */
function writeSlice(slice: string | undefined): string {
  const [type, at] = (slice ?? '').split(' ');
  return slice === undefined || type === 'none'
    ? '<volume-slice hidden></volume-slice>'
    : `<volume-slice${attributesOf({ type, ...(at ? { at } : {}) })}></volume-slice>`;
}

function writeStep({ title, text, view, notes, questions }: Step, base: ViewAttributes): string {
  const own = Object.fromEntries(Object.entries(view).filter(([name]) => base[name] === undefined));
  const attributes = attributesOf({ ...own, ...(notes.length > 0 ? { notes: notes.join(' ') } : {}) });
  const parts = [
    ...(title ? [`<h2>${escapeMarkup(title)}</h2>`] : []),
    ...(text ? [writeParagraphs(text)] : []),
    ...questions.map(writeQuestion),
  ];
  return `  <volume-step${attributes}>${parts.map((part) => `\n    ${part}`).join('')}\n  </volume-step>`;
}

function writeQuestion(question: Question): string {
  const { id, type, title, answers, position, radius, answer, tolerance, tries, hint, right, wrong } = question;
  const given: Record<string, string> = {
    id,
    type,
    position: type === 'choice' ? '' : position,
    radius: type === 'find' ? radius : '',
    answer: type === 'label' || type === 'value' ? answer : '',
    tolerance: type === 'value' ? tolerance : '',
    tries,
  };
  const attributes = Object.fromEntries(Object.entries(given).filter(([, text]) => text !== ''));
  const list =
    type === 'choice'
      ? `<ul>${answers.map((one) => `<li${one.isCorrect ? ' correct' : ''}>${escapeMarkup(one.text)}</li>`).join('')}</ul>`
      : '';
  const said = Object.entries({ hint, right, wrong })
    .filter(([, text]) => text !== '')
    .map(([slot, text]) => `<p slot="${slot}">${escapeMarkup(text)}</p>`);
  return `<volume-question${attributesOf(attributes)}><h3>${escapeMarkup(title)}</h3>${list}${said.join('')}</volume-question>`;
}

/** Lines become lines, and empty lines divide paragraphs. */
function writeParagraphs(text: string): string {
  return text
    .split(/\n[ \t]*\n\s*/)
    .map((paragraph) => paragraph.trim())
    .filter(Boolean)
    .map((paragraph) => `<p>${paragraph.split('\n').map(escapeMarkup).join('<br>')}</p>`)
    .join('');
}

function attributesOf(attributes: Readonly<Record<string, string>>): string {
  return Object.entries(attributes)
    .map(([name, text]) => ` ${name}="${escapeMarkup(text)}"`)
    .join('');
}
