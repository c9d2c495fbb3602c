// What a lesson is, and what goes into its files.

/** A file, by its path in a folder: `/` between folders, no `/` at the beginning. */
export interface LessonFile {
  readonly path: string;
  readonly bytes: Uint8Array;
}

export interface Lesson {
  /** A page, or what stands between the tags of its body: `<volume-view>`, notes, tours, questions, and text. */
  readonly html: string;
  /** The files that the HTML names, by the paths that it names them with. */
  readonly files: readonly LessonFile[];
  readonly title: string;
  /** The language of the texts, as in the attribute `lang` of HTML: `en`, `pt-BR`. */
  readonly language: string;
  /** The licence under which the data may be passed on. */
  readonly licence: string;
  /** Who made the data. */
  readonly credits: string;
}

/** What a writer refuses in a lesson. */
export interface LessonProblem {
  /** In words: what was got, what was expected. */
  readonly message: string;
  /** Of the HTML, from 1; null where it concerns no line. */
  readonly line: number | null;
}

/** A lesson that a writer refuses. */
export class LessonError extends Error {
  constructor(readonly problems: readonly LessonProblem[]) {
    super(problems.map(({ message, line }) => (line === null ? message : `line ${line}: ${message}`)).join('\n'));
  }
}

/** The files of the element that a page of a lesson loads: `volume-view.iife.js`, `volume-view.css`, `x3dom.js`, and those of the folder `classic`. */
export type Player = readonly LessonFile[];
