import type { HandleMessages } from './handle-messages.ts';

/** English messages for handles over a picture. The file is loaded with the elements that have handles. */
export const english: HandleMessages = {
  handleKeys: 'Arrow keys move it across the picture, Page up and Page down away and nearer, with Shift farther.',
  handleKeysAlong: 'Arrow keys, Page up and Page down move it, with Shift farther.',
};
