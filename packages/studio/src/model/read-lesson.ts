// Reads a lesson from the HTML that the studio wrote, or that an author wrote in its way.
import { readLesson } from '../../../lesson-writers/src/index.ts';
import type { LessonElement, LessonNode } from '../../../lesson-writers/src/index.ts';
import { freeId } from './edit.ts';
import { emptyLesson } from './lesson.ts';
import type { Lesson, Note, Question, QuestionType, Step, ViewAttributes } from './lesson.ts';

/** A lesson that was read. */
export interface ReadLesson {
  readonly lesson: Lesson;
  /** What its view shows: the address in its `src`. */
  readonly src: string;
  /** Names of elements that the studio does not keep. */
  readonly left: readonly string[];
}

/** Attributes of a view that the studio writes by itself, or that its pages do not need. */
const notKept = ['id', 'src', 'alt', 'controls', 'controlslist', 'class', 'authoring', 'poster', 'loading'];

const types: readonly string[] = ['choice', 'find', 'label', 'value'] satisfies QuestionType[];

/** @returns null where there is no `<volume-view>` with a `src` */
export function readLessonHtml(html: string): ReadLesson | null {
  const { nodes, head, problems } = readLesson(html);
  const left = new Set(problems.map(({ message }) => /<([\w-]+)>/.exec(message)?.[1] ?? 'HTML'));
  const view = find(nodes, 'volume-view')[0];
  const src = view && textOf(view, 'src');
  if (!view || !src) return null;
  const heading = find(nodes, 'h1')[0];
  const base = Object.fromEntries(view.attributes.filter(([name]) => !notKept.includes(name))) as ViewAttributes;
  const slice = readSlice(find(view.children, 'volume-slice')[0]);
  const own: ViewAttributes = slice ? { ...base, slice } : base;
  const notes = find(nodes, 'volume-note').map(readNote);
  const empty: Lesson = {
    ...emptyLesson,
    title: (heading ? wordsOf(heading) : head.title) ?? '',
    alt: textOf(view, 'alt') ?? '',
    language: head.language ?? 'en',
    credits: head.author ?? '',
    licence: head.license ?? '',
    view: own,
  };
  const lesson = find(nodes, 'volume-step').reduce(
    (before, step) => ({ ...before, steps: [...before.steps, readStep(step, before)] }),
    notes.reduce((before, note) => ({ ...before, notes: [...before.notes, named(note, 'note', before)] }), empty),
  );
  for (const name of [
    'volume-labels',
    'volume-layer',
    'volume-surface',
    'volume-terrain',
    'volume-clip',
    'volume-label-list',
    'table',
    'a',
    'img',
  ])
    if (find(nodes, name).length > 0) left.add(name);
  // In the foot of a page is a link to its licence, which is written again.
  if (!find(find(nodes, 'main'), 'a').length) left.delete('a');
  return { lesson: { ...lesson, view: lesson.steps[0]?.view ?? own }, src, left: [...left] };
}

function readNote(note: LessonElement): Note {
  return {
    id: textOf(note, 'id') ?? '',
    label: textOf(note, 'label') ?? '',
    text: paragraphsOf(note.children),
    position: textOf(note, 'position') ?? '',
  };
}

function readStep(step: LessonElement, before: Lesson): Step {
  const heading = step.children.find(
    (child): child is LessonElement => isElement(child) && /^h[1-6]$/.test(child.name),
  );
  const own = step.attributes.filter(([name]) => !['id', 'class', 'notes', 'label', 'alt'].includes(name));
  const id = freeId('step', before);
  let count = before;
  const questions = find(step.children, 'volume-question').map((one) => {
    const question = named(readQuestion(one), 'question', count);
    count = { ...count, steps: [...count.steps, { ...emptyStep, id: '', questions: [question] }] };
    return question;
  });
  return {
    id,
    title: heading ? wordsOf(heading) : (textOf(step, 'label') ?? ''),
    text: paragraphsOf(step.children.filter((child) => child !== heading)),
    view: { ...before.view, ...(Object.fromEntries(own) as ViewAttributes) },
    notes: (textOf(step, 'notes') ?? '').split(/\s+/).filter((one) => before.notes.some((note) => note.id === one)),
    questions,
  };
}

const emptyStep: Step = { id: '', title: '', text: '', view: {}, notes: [], questions: [] };

function readQuestion(element: LessonElement): Question {
  const text = (name: string): string => textOf(element, name) ?? '';
  const type = text('type') || 'choice';
  const slotted = (slot: string): string =>
    element.children
      .filter((child): child is LessonElement => isElement(child) && textOf(child, 'slot') === slot)
      .map(wordsOf)
      .join('\n');
  const title = element.children.find(
    (child): child is LessonElement =>
      isElement(child) && /^(h[1-6]|p)$/.test(child.name) && textOf(child, 'slot') === null,
  );
  return {
    id: text('id'),
    type: (types.includes(type) ? type : 'choice') as QuestionType,
    title: title ? wordsOf(title) : '',
    answers: find(element.children, 'li').map((item) => ({
      text: wordsOf(item),
      isCorrect: textOf(item, 'correct') !== null,
    })),
    position: text('position'),
    radius: text('radius'),
    answer: text('answer'),
    tolerance: text('tolerance'),
    tries: text('tries'),
    hint: slotted('hint'),
    right: slotted('right'),
    wrong: slotted('wrong'),
  };
}

/** @returns 'axial 20', as the attribute of a step has it; null where none is shown */
function readSlice(slice: LessonElement | undefined): string | null {
  if (!slice || textOf(slice, 'hidden') !== null) return null;
  return [textOf(slice, 'type') ?? 'axial', textOf(slice, 'at')].filter((one) => one !== null).join(' ');
}

/** An id that the lesson does not have yet, where the element has none or another one has it too. */
function named<T extends { readonly id: string }>(one: T, kind: 'note' | 'question', lesson: Lesson): T {
  const taken = [
    ...lesson.notes.map(({ id }) => id),
    ...lesson.steps.flatMap(({ id, questions }) => [id, ...questions.map((question) => question.id)]),
  ];
  return one.id && !/\s/.test(one.id) && !taken.includes(one.id) ? one : { ...one, id: freeId(kind, lesson) };
}

const isElement = (node: LessonNode): node is LessonElement => typeof node !== 'string';

const textOf = (element: LessonElement, name: string): string | null =>
  element.attributes.find(([own]) => own === name)?.[1] ?? null;

/** All elements of a name, also inside of others. */
function find(nodes: readonly LessonNode[], name: string): LessonElement[] {
  return nodes
    .filter(isElement)
    .flatMap((node) => [...(node.name === name ? [node] : []), ...find(node.children, name)]);
}

/** The words in an element, on one line. */
function wordsOf(element: LessonElement): string {
  const all = (nodes: readonly LessonNode[]): string =>
    nodes.map((node) => (isElement(node) ? (node.name === 'br' ? ' ' : all(node.children)) : node)).join('');
  return all(element.children).replace(/\s+/g, ' ').trim();
}

/** Paragraphs with empty lines between them; questions and pictures are left out. */
function paragraphsOf(nodes: readonly LessonNode[]): string {
  const blocks: string[] = [];
  const visit = (node: LessonNode): void => {
    if (!isElement(node)) {
      if (node.trim()) blocks.push(node.replace(/\s+/g, ' ').trim());
    } else if (node.name === 'p' || /^h[1-6]$/.test(node.name) || node.name === 'li') blocks.push(linesOf(node));
    else if (!/^volume-|^img$/.test(node.name)) node.children.forEach(visit);
  };
  nodes.forEach(visit);
  return blocks.join('\n\n');
}

function linesOf(element: LessonElement): string {
  const all = (nodes: readonly LessonNode[]): string =>
    nodes
      .map((node) =>
        isElement(node) ? (node.name === 'br' ? '\u0000' : all(node.children)) : node.replace(/\s+/g, ' '),
      )
      .join('');
  return all(element.children)
    .split('\u0000')
    .map((line) => line.trim())
    .join('\n')
    .trim();
}
