import type { NoteMessages } from './note-messages.ts';

/** English messages for notes in volumes. The file is loaded where a page has some. */
export const english: NoteMessages = {
  notes: 'Notes',
  note: (number) => `Note ${number}`,
  noteBehind: 'Behind other parts',
  noteOutside: 'Outside the picture',
  noteShow: (name) => `Show in the picture: ${name}`,
};
