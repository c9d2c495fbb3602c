import type { VolumeFormat } from '../base/format.ts';
import { isAfniHeader } from './is-afni-header.ts';

export const afni: VolumeFormat = {
  name: 'AFNI',
  words: 'AFNI (.HEAD, .BRIK)',
  endings: ['head', 'brik'],
  // A file of samples has no mark.
  beginning: null,
  matches: ({ text }) => isAfniHeader(text),
  takesFiles: true,
  load: async () => (await import('#rare/formats/afni/read-afni.ts')).readAfni,
};
