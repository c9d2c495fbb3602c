import type { HandleTerms } from './handle-terms.ts';

/** Of handles over a picture, which are loaded with the elements that have some. */
export const english: HandleTerms = {
  handleKeys: 'Arrow keys move it across the picture, Page up and Page down away and nearer, with Shift farther.',
  handleKeysAlong: 'Arrow keys, Page up and Page down move it, with Shift farther.',
};
