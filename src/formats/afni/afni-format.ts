import type { VolumeFormat } from '../base/format.ts';

export const afni: VolumeFormat = {
  name: 'AFNI',
  words: 'AFNI (.HEAD, .BRIK)',
  endings: ['head', 'brik'],
  // A file of samples has no mark.
  beginning: null,
  matches: ({ text }) => /^type\s*=\s*(?:string|integer|float)-attribute\s/.test(text),
  takesFiles: true,
  load: async () => (await import('#rare/formats/afni/read-afni.ts')).readAfni,
};
