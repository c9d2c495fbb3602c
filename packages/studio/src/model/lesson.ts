// A lesson as its author makes it: a plain value, from which the page, the tag and the packages are written.

/** Texts of attributes by their names, as `<volume-step>` has them: the camera, the look, the cut; `slice` is one of them. */
export type ViewAttributes = Readonly<Record<string, string>>;

/** A name at a place of the volume. */
export interface Note {
  readonly id: string;
  readonly label: string;
  /** Plain text; an empty line begins a paragraph. */
  readonly text: string;
  /** World units: `x y z`. */
  readonly position: string;
}

/** What a learner does: chooses, clicks a place, names a marked place, reads a value. */
export type QuestionType = 'choice' | 'find' | 'label' | 'value';

export interface Answer {
  readonly text: string;
  readonly isCorrect: boolean;
}

export interface Question {
  readonly id: string;
  readonly type: QuestionType;
  readonly title: string;
  /** `choice` only. */
  readonly answers: readonly Answer[];
  /** World units: `x y z`; empty where there is none. */
  readonly position: string;
  /** `find`: world units. */
  readonly radius: string;
  /** `label`: names with commas between them. `value`: a number. */
  readonly answer: string;
  /** `value`: by how much a right answer may differ. */
  readonly tolerance: string;
  /** How often a learner may answer; empty for any number. */
  readonly tries: string;
  readonly hint: string;
  readonly right: string;
  readonly wrong: string;
}

export interface Step {
  readonly id: string;
  readonly title: string;
  /** As that of a note. */
  readonly text: string;
  /** All of the view: what is absent here is as a new view has it. */
  readonly view: ViewAttributes;
  /** Ids of the notes that are open. */
  readonly notes: readonly string[];
  readonly questions: readonly Question[];
}

export interface Lesson {
  readonly title: string;
  /** What the picture shows, for people who do not see it. */
  readonly alt: string;
  /** As the attribute `lang` of HTML has it. */
  readonly language: string;
  readonly credits: string;
  readonly licence: string;
  /** Which of the kept files are its data; null before there are some. */
  readonly data: string | null;
  /** The picture that the author has before them. */
  readonly view: ViewAttributes;
  readonly notes: readonly Note[];
  readonly steps: readonly Step[];
}

export const emptyLesson: Lesson = {
  title: '',
  alt: '',
  language: 'en',
  credits: '',
  licence: '',
  data: null,
  view: {},
  notes: [],
  steps: [],
};

/** Steps, and notes, of a lesson. */
export const maxParts = 200;

/** Which attributes of a view are its camera: a person changes them by turning the picture. */
export const cameraAttributes = ['camera-orbit', 'camera-target', 'field-of-view'] as const;

/** Which attributes a look sets. */
export const lookAttributes = [
  'look',
  'transfer-function',
  'transfer-function-2d',
  'gradient-opacity',
  'surface-values',
  'value-window',
  'reference-length',
  'opacity-factor',
  'light-factor',
  'projection',
  'shading',
] as const;
