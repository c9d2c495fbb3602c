/** The messages of <volume-question>. Numbers are passed as text, already formatted for the language. */
export interface QuestionMessages {
  /** Above answers of which several are right. */
  readonly questionChooseAll: string;
  /** What a reader does to find a place. */
  readonly questionFind: string;
  /** The button that shows a crosshair for keys; the crosshair has this name too. */
  readonly questionCrosshair: string;
  readonly questionCrosshairKeys: string;
  /** What is under the crosshair, and where in the picture it is: shares of its width and height in percent. */
  readonly questionUnder: (value: string, across: string, down: string) => string;
  /** In place of a value, where nothing is seen. */
  readonly questionNothing: string;
  /** The button that gives an answer. */
  readonly questionAnswer: string;
  /** Said where no answer was chosen or written. */
  readonly questionEmpty: string;
  readonly questionHint: string;
  readonly questionRight: string;
  readonly questionWrong: string;
  readonly questionTriesLeft: (count: string) => string;
  /** The right answer, after the last try. */
  readonly questionSolution: (text: string) => string;
  /** How many questions are answered right, of all. */
  readonly questionScore: (right: string, count: string) => string;
  /** Names of places in the picture: the one that is asked for, the one that the reader chose, the right one. */
  readonly questionPlace: string;
  readonly questionYours: string;
  readonly questionSolutionPlace: string;
}
