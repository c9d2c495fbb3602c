import type { VolumeFormat } from '../base/format.ts';
import { startsWith } from '../base/starts-with.ts';

/** Any file that is packed as a whole, such as `.nii.bz2`. */
export const bzip2: VolumeFormat = {
  name: 'bzip2',
  words: 'any of these packed with bzip2 (.bz2)',
  endings: ['bz2'],
  beginning: 'a bzip2 header',
  matches: ({ bytes }) => startsWith(bytes, 'BZh'),
  // It may be the data of a header.
  last: true,
  load: async () => (await import('./read-bzip2.ts')).readBzip2,
};
