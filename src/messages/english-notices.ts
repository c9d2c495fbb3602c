import type { NoticeMessages } from './notice-messages.ts';

/** English messages of the sign for notices. The file is loaded with the first sign. */
export const english: NoticeMessages = {
  notices: (count) => `Notes on the data: ${count}`,
  noticesAre: 'Not in the picture, or not as in the file:',
  madeSmaller: (from, to) => `The volume was made smaller for this device: ${from} voxels are ${to}.`,
};
