import type { ClipTerms } from './clip-terms.ts';

/** English messages for planes and boxes that cut volumes. The file is loaded where a page has some. */
export const english: ClipTerms = {
  clipPlane: 'Cutting plane',
  clipBox: 'Cutting box',
  clipSides: [['Box, lower x', 'Box, upper x'], ['Box, lower y', 'Box, upper y'], ['Box, lower z', 'Box, upper z']],
};
