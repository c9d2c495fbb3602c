import type { ClipMessages } from './clip-messages.ts';

/** English messages for planes and boxes that cut volumes. The file is loaded where a page has some. */
export const english: ClipMessages = {
  clipPlane: 'Cutting plane',
  clipBox: 'Cutting box',
  clipSides: [
    ['Box, lower x', 'Box, upper x'],
    ['Box, lower y', 'Box, upper y'],
    ['Box, lower z', 'Box, upper z'],
  ],
};
