// A lesson of the studio with all that it can have.
import * as edit from '../../packages/studio/src/model/edit.ts';
import { emptyLesson } from '../../packages/studio/src/model/lesson.ts';
import type { Lesson, Question, QuestionType } from '../../packages/studio/src/model/lesson.ts';

/** Without steps. */
export const named: Lesson = {
  ...emptyLesson,
  title: 'A head',
  alt: 'A head, MRI',
  credits: 'Made by a program',
  licence: 'CC0 1.0',
  data: 'data-1',
};

/** A question of each type, complete. */
const questions: Readonly<Record<QuestionType, Partial<Question>>> = {
  choice: {
    title: 'Which is "brighter" & why?',
    answers: [
      { text: 'Grey <b>matter</b>', isCorrect: false },
      { text: 'White matter', isCorrect: true },
    ],
    hint: 'Look < inside',
    right: 'Yes',
    wrong: 'No',
    tries: '2',
  },
  find: { title: 'Where is it?', position: '1.5 -17 8', radius: '12' },
  label: { title: 'What is it?', position: '1 2 3', answer: 'thalamus, "left" thalamus' },
  value: { title: 'What value?', answer: '140', tolerance: '15' },
};

export function wholeLesson(): Lesson {
  let lesson = edit.addNote(named, '1.5 -17 8');
  lesson = edit.changeNote(lesson, 'note-1', {
    label: 'Thalamus & "co"',
    text: 'Nearly all <senses>.\n\nSecond\nline',
  });
  lesson = edit.addNote(lesson, '4 5 6');
  lesson = edit.addStep({ ...lesson, view: { look: 'textbook', 'camera-orbit': '30deg 70deg auto' } }, null, [
    'note-1',
  ]);
  const cut = { look: 'textbook', 'camera-orbit': '0deg 2deg auto', region: '0 -120 -80 90 90 100', slice: 'axial 20' };
  lesson = edit.addStep({ ...lesson, view: cut }, null);
  lesson = edit.changeStep(lesson, 'step-1', { title: 'From <outside>', text: 'One & two.\n\nA "quoted" text' });
  lesson = edit.changeStep(lesson, 'step-2', { title: 'Inside', text: '' });
  for (const [type, fields] of Object.entries(questions) as [QuestionType, Partial<Question>][]) {
    lesson = edit.addQuestion(lesson, 'step-2', type);
    const { id } = lesson.steps[1].questions.at(-1)!;
    lesson = edit.changeQuestion(lesson, id, fields);
  }
  return lesson;
}
