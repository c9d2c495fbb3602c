/** The messages of `authoring`, with which an author finds the places of notes. */
export interface AuthoringMessages {
  /** Name of the panel. */
  readonly authoring: string;
  /** What an author does first. */
  readonly authoringClick: string;
  /** The button that shows a crosshair for keys; the crosshair has this name too. */
  readonly authoringCrosshair: string;
  readonly authoringKeys: string;
  /** What is under the crosshair: a place, and its value. */
  readonly authoringUnder: (position: string, value: string) => string;
  readonly authoringNothing: string;
  /** Said when a place is chosen. */
  readonly authoringPlaced: (position: string) => string;
  /** The button that takes the place of the crosshair in panes of slices. */
  readonly authoringSlices: string;
  /** The field for the name of the note. */
  readonly authoringName: string;
  /** The note stands in the middle of a label; `label` is its number, and its name where it has one. */
  readonly authoringMiddle: (label: string) => string;
  /** The field with the tag. */
  readonly authoringTag: string;
  readonly authoringCopy: string;
  readonly authoringCopied: string;
  /** Said where the browser does not allow to copy. */
  readonly authoringByHand: string;
  /** The button that removes the place. */
  readonly authoringRemove: string;
}
