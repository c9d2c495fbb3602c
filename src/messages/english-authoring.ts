import type { AuthoringMessages } from './authoring-messages.ts';

/** English messages for authors of notes. The file is loaded where a view has `authoring`. */
export const english: AuthoringMessages = {
  authoring: 'Place of a note',
  authoringClick: 'Click the place of a note in the picture',
  authoringCrosshair: 'Crosshair',
  authoringKeys: 'Arrow keys move the crosshair, with Shift farther. Enter takes the place, Escape ends.',
  authoringUnder: (position, value) => `Place ${position}, value ${value}`,
  authoringNothing: 'Nothing is seen there',
  authoringPlaced: (position) => `Place: ${position}`,
  authoringSlices: 'Crosshair of the slices',
  authoringName: 'Name',
  authoringMiddle: (label) => `In the middle of label ${label}`,
  authoringTag: 'Tag',
  authoringCopy: 'Copy',
  authoringCopied: 'Copied. Its text goes between the tags.',
  authoringByHand: 'The browser does not allow copying. The tag is selected: copy it.',
  authoringRemove: 'Remove the place',
};
