import type { QuestionMessages } from './question-messages.ts';

/** English messages for questions about volumes. The file is loaded where a page has some. */
export const english: QuestionMessages = {
  questionChooseAll: 'Choose all that are right.',
  questionFind: 'Click the place in the picture.',
  questionCrosshair: 'Crosshair',
  questionCrosshairKeys: 'Arrow keys move the crosshair, with Shift farther. Enter answers, Escape ends.',
  questionUnder: (value, across, down) => `${value}. ${across} from the left, ${down} from the top`,
  questionNothing: 'Nothing is seen there',
  questionAnswer: 'Answer',
  questionEmpty: 'Give an answer first.',
  questionHint: 'Hint',
  questionRight: 'Right.',
  questionWrong: 'Not right.',
  questionTriesLeft: (count) => `Tries left: ${count}.`,
  questionSolution: (text) => `Right answer: ${text}`,
  questionScore: (right, count) => `Right answers so far: ${right} of ${count}`,
  questionPlace: 'This place',
  questionYours: 'Your answer',
  questionSolutionPlace: 'Right place',
};
