import type { CompareMessages } from './compare-messages.ts';

/** English messages for two views that are compared. The file is loaded where a page has them. */
export const english: CompareMessages = {
  compareDivider: 'Divider between the two pictures',
};
