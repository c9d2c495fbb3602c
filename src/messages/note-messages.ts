/** The messages of <volume-note>. */
export interface NoteMessages {
  /** Name of all notes of a picture together. */
  readonly notes: string;
  /** Name of a note that has no name of its own. */
  readonly note: (number: string) => string;
  /** Said of a note whose place is behind other parts of the volume. */
  readonly noteBehind: string;
  /** Said of a note whose place is not in the picture. */
  readonly noteOutside: string;
  /** The button in a text of the page that marks its place in the picture. */
  readonly noteShow: (name: string) => string;
}
