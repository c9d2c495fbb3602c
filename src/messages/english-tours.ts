import type { TourMessages } from './tour-messages.ts';

/** English messages for tours through volumes. The file is loaded where a page has one. */
export const english: TourMessages = {
  tour: 'Tour',
  tourStart: 'Start the tour',
  tourPrevious: 'Previous step',
  tourNext: 'Next step',
  tourLeave: 'Leave the tour',
  tourBack: 'Back to this step',
  tourStep: (number) => `Step ${number}`,
  tourStepOf: (number, count, title) => `Step ${number} of ${count}: ${title}`,
  tourLeft: 'The tour is closed.',
};
