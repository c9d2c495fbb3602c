// What an author does to a lesson, as functions from a lesson to a new one. An id that is not there changes nothing.
import { maxParts } from './lesson.ts';
import type { Lesson, Note, Question, QuestionType, Step, ViewAttributes } from './lesson.ts';

/** The first free one of `note-1`, `note-2` … */
export function freeId(kind: 'note' | 'step' | 'question', lesson: Lesson): string {
  const taken = new Set([
    ...lesson.notes.map(({ id }) => id),
    ...lesson.steps.flatMap(({ id, questions }) => [id, ...questions.map((one) => one.id)]),
  ]);
  let number = 1;
  while (taken.has(`${kind}-${number}`)) number++;
  return `${kind}-${number}`;
}

/** Sets attributes of the present view; null removes one. */
export function changeView(lesson: Lesson, changes: Readonly<Record<string, string | null>>): Lesson {
  return { ...lesson, view: mergeView(lesson.view, changes) };
}

export function mergeView(view: ViewAttributes, changes: Readonly<Record<string, string | null>>): ViewAttributes {
  const entries = Object.entries({ ...view, ...changes }).filter(
    (entry): entry is [string, string] => entry[1] !== null,
  );
  return Object.fromEntries(entries);
}

/** Whether two views have the same attributes. */
export function isSameView(a: ViewAttributes, b: ViewAttributes): boolean {
  const names = Object.keys(a);
  return names.length === Object.keys(b).length && names.every((name) => a[name] === b[name]);
}

/** A step that keeps the present view, at the end or after another one. @param after - id of a step */
export function addStep(lesson: Lesson, after: string | null, open: readonly string[] = []): Lesson {
  if (lesson.steps.length >= maxParts) return lesson;
  const step: Step = {
    id: freeId('step', lesson),
    title: '',
    text: '',
    view: lesson.view,
    notes: open.filter((id) => lesson.notes.some((note) => note.id === id)),
    questions: [],
  };
  const found = lesson.steps.findIndex(({ id }) => id === after);
  const steps = [...lesson.steps];
  steps.splice(found < 0 ? steps.length : found + 1, 0, step);
  return { ...lesson, steps };
}

export function changeStep(lesson: Lesson, id: string, changes: Partial<Omit<Step, 'id'>>): Lesson {
  return { ...lesson, steps: lesson.steps.map((step) => (step.id === id ? { ...step, ...changes } : step)) };
}

/** @param by - places towards the end; it stops at both ends */
export function moveStep(lesson: Lesson, id: string, by: number): Lesson {
  return { ...lesson, steps: move(lesson.steps, id, by) };
}

export function removeStep(lesson: Lesson, id: string): Lesson {
  return { ...lesson, steps: lesson.steps.filter((step) => step.id !== id) };
}

export function addNote(lesson: Lesson, position: string): Lesson {
  if (lesson.notes.length >= maxParts) return lesson;
  return { ...lesson, notes: [...lesson.notes, { id: freeId('note', lesson), label: '', text: '', position }] };
}

export function changeNote(lesson: Lesson, id: string, changes: Partial<Omit<Note, 'id'>>): Lesson {
  return { ...lesson, notes: lesson.notes.map((note) => (note.id === id ? { ...note, ...changes } : note)) };
}

/** The steps that open it open it no longer. */
export function removeNote(lesson: Lesson, id: string): Lesson {
  return {
    ...lesson,
    notes: lesson.notes.filter((note) => note.id !== id),
    steps: lesson.steps.map((step) =>
      step.notes.includes(id) ? { ...step, notes: step.notes.filter((one) => one !== id) } : step,
    ),
  };
}

export function addQuestion(lesson: Lesson, stepId: string, type: QuestionType): Lesson {
  const question: Question = {
    id: freeId('question', lesson),
    type,
    title: '',
    answers:
      type === 'choice'
        ? [
            { text: '', isCorrect: true },
            { text: '', isCorrect: false },
          ]
        : [],
    position: '',
    radius: type === 'find' ? '10' : '',
    answer: '',
    tolerance: '',
    tries: '',
    hint: '',
    right: '',
    wrong: '',
  };
  return changeStepOf(lesson, stepId, (questions) => [...questions, question]);
}

export function changeQuestion(lesson: Lesson, id: string, changes: Partial<Omit<Question, 'id'>>): Lesson {
  return changeStepOf(lesson, null, (questions) =>
    questions.some((one) => one.id === id)
      ? questions.map((one) => (one.id === id ? { ...one, ...changes } : one))
      : questions,
  );
}

export function moveQuestion(lesson: Lesson, id: string, by: number): Lesson {
  return changeStepOf(lesson, null, (questions) => move(questions, id, by));
}

export function removeQuestion(lesson: Lesson, id: string): Lesson {
  return changeStepOf(lesson, null, (questions) =>
    questions.some((one) => one.id === id) ? questions.filter((one) => one.id !== id) : questions,
  );
}

/** @param stepId - null for all steps */
function changeStepOf(
  lesson: Lesson,
  stepId: string | null,
  change: (questions: readonly Question[]) => readonly Question[],
): Lesson {
  return {
    ...lesson,
    steps: lesson.steps.map((step) => {
      if (stepId !== null && step.id !== stepId) return step;
      const questions = change(step.questions);
      return questions === step.questions ? step : { ...step, questions };
    }),
  };
}

/** The same list where nothing moves. */
function move<T extends { readonly id: string }>(list: readonly T[], id: string, by: number): readonly T[] {
  const from = list.findIndex((one) => one.id === id);
  const to = Math.min(list.length - 1, Math.max(0, from + by));
  if (from < 0 || to === from) return list;
  const moved = [...list];
  moved.splice(to, 0, ...moved.splice(from, 1));
  return moved;
}
