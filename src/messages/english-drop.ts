import type { DropMessages } from './drop-messages.ts';

/** English messages for opening files and choosing series. The file is loaded where a page has one of these elements. */
export const english: DropMessages = {
  openFiles: 'Open files…',
  openFolder: 'Open a folder…',
  dropHint: 'Or drop files or a folder on the picture, or paste them. They stay on this device: nothing is uploaded.',
  dropHere: 'Drop to open',
  dropReading: 'Reading …',
  dropEmpty: 'There are no files in it.',
  dropRead: (format, size, count) => `${format}, ${size} voxels. Files: ${count}.`,
  seriesList: 'Series',
  seriesNumber: (number) => `Series ${number}`,
  seriesSlices: (count) => `Slices: ${count}`,
  seriesFiles: (count) => `Files: ${count}`,
  seriesPlane: { axial: 'axial', coronal: 'coronal', sagittal: 'sagittal', oblique: 'oblique' },
};
