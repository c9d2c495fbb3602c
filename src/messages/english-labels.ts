import type { LabelMessages } from './label-messages.ts';

/** English messages of the list of labels. The file is loaded where a page has such a list. */
export const english: LabelMessages = {
  labelList: 'Labels',
  findLabel: 'Find a label',
  allLabels: 'Show all',
  onlyThis: 'Only this',
  onlyLabel: (name) => `Only this: ${name}`,
  otherParts: 'Everything else',
  labelsShown: (shown, count) => `${shown} of ${count} shown`,
  moreLabels: (count) => `${count} more: find them by their names.`,
  noLabels: 'This volume has no labels.',
  labelsComing: 'No labels are shown yet.',
  labelsHidden: 'The labels are hidden.',
  noSuchLabel: 'No label has this name.',
};
