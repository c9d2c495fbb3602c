import type { VolumeFormat } from '../base/format.ts';
import { startsWith } from '../base/starts-with.ts';

export const npy: VolumeFormat = {
  name: 'NPY',
  words: 'a NumPy array (.npy)',
  endings: ['npy'],
  beginning: 'the mark NUMPY',
  matches: ({ bytes, unpacked }) => startsWith(unpacked ?? bytes, '\x93NUMPY'),
  load: async () => (await import('#rare/formats/npy/read-npy.ts')).readNpy,
};
