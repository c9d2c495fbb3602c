import type { VolumeFormat } from '../base/format.ts';
import { startsWith } from '../base/starts-with.ts';

/** Any file that is packed as a whole, such as `.nii.zst`. */
export const zstd: VolumeFormat = {
  name: 'Zstandard',
  words: 'any of these packed with Zstandard (.zst)',
  endings: ['zst'],
  beginning: 'a Zstandard header',
  matches: ({ bytes }) => startsWith(bytes, '\x28\xb5\x2f\xfd'),
  // It may be the data of a header.
  last: true,
  load: async () => (await import('./read-zstd.ts')).readZstd,
};
