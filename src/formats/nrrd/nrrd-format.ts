import type { VolumeFormat } from '../base/format.ts';
import { startsWith } from '../base/starts-with.ts';

export const nrrd: VolumeFormat = {
  name: 'NRRD',
  words: 'NRRD (.nrrd, .nhdr)',
  endings: ['nrrd', 'nhdr'],
  beginning: 'the mark NRRD',
  matches: ({ bytes }) => startsWith(bytes, 'NRRD00'),
  takesFiles: true,
  load: async () => (await import('#rare/formats/nrrd/read-nrrd.ts')).readNrrd,
};
