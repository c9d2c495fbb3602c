import type { VolumeFormat } from '../base/format.ts';
import { detectNifti } from '../nifti/nifti-header.ts';

export const analyze: VolumeFormat = {
  name: 'Analyze or NIfTI pair',
  words: 'Analyze 7.5 and NIfTI in two files (.hdr, .img)',
  endings: ['hdr', 'img'],
  // A file of samples has no mark.
  beginning: null,
  // A single NIfTI file, which has the mark "n+1" or "n+2", is recognized before.
  matches: ({ bytes, unpacked }) => detectNifti(unpacked ?? bytes) !== null,
  takesFiles: true,
  load: async () => (await import('#rare/formats/analyze/read-analyze.ts')).readAnalyze,
};
