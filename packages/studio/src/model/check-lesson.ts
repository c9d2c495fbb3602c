// What is missing before a lesson can be given to learners.
import type { Lesson, Question } from './lesson.ts';

/** What is missing, and where an author goes to mend it. */
export interface Lack {
  readonly kind:
    | 'data'
    | 'title'
    | 'credits'
    | 'licence'
    | 'language'
    | 'step-title'
    | 'question-title'
    | 'question-answers'
    | 'question-correct'
    | 'question-place'
    | 'question-answer'
    | 'question-number'
    | 'question-radius'
    | 'question-tries'
    | 'note-place';
  /** Of the step, from 1; of the note, from 1. */
  readonly number?: number;
  /** Of the step, or of the note. */
  readonly id?: string;
}

/** In the order of the lesson. */
export function findLacks(lesson: Lesson): readonly Lack[] {
  const { title, credits, licence, language, data, notes, steps } = lesson;
  const texts = { title, credits, licence };
  return [
    ...(data === null ? [{ kind: 'data' } as const] : []),
    ...(['title', 'credits', 'licence'] as const).filter((kind) => texts[kind].trim() === '').map((kind) => ({ kind })),
    ...(/^[A-Za-z]{2,8}(-[A-Za-z0-9]{1,8}){0,5}$/.test(language) ? [] : [{ kind: 'language' } as const]),
    ...notes.flatMap(({ id, position }, i) =>
      isPlace(position) ? [] : [{ kind: 'note-place', number: i + 1, id } as const],
    ),
    ...steps.flatMap(({ id, title, questions }, i) => [
      ...(title.trim() === '' ? [{ kind: 'step-title', number: i + 1, id } as const] : []),
      ...questions.flatMap(findLacksOf).map((kind) => ({ kind, number: i + 1, id })),
    ]),
  ];
}

function findLacksOf(question: Question): Lack['kind'][] {
  const { type, title, answers, position, radius, answer, tolerance, tries } = question;
  const lacks: Lack['kind'][] = [];
  if (title.trim() === '') lacks.push('question-title');
  if (type === 'choice') {
    if (answers.length < 2 || answers.some(({ text }) => text.trim() === '')) lacks.push('question-answers');
    if (!answers.some(({ isCorrect }) => isCorrect)) lacks.push('question-correct');
  }
  if ((type === 'find' || type === 'label') && !isPlace(position)) lacks.push('question-place');
  if (type === 'find' && !(Number(radius) > 0)) lacks.push('question-radius');
  if (type === 'label' && answer.trim() === '') lacks.push('question-answer');
  if (type === 'value' && !(isNumber(answer) && (tolerance === '' || (isNumber(tolerance) && Number(tolerance) >= 0))))
    lacks.push('question-number');
  if (tries !== '' && !(Number.isInteger(Number(tries)) && Number(tries) >= 1)) lacks.push('question-tries');
  return lacks;
}

const isNumber = (text: string): boolean => text.trim() !== '' && Number.isFinite(Number(text));

const isPlace = (text: string): boolean => {
  const numbers = text.trim().split(/\s+/);
  return numbers.length === 3 && numbers.every(isNumber);
};
