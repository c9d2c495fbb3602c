import type { VolumeFormat } from '../base/format.ts';
import { isDicom } from '../dicom/is-dicom.ts';
import { detectNifti } from '../nifti/nifti-header.ts';

export const analyze: VolumeFormat = {
  name: 'Analyze or NIfTI pair',
  words: 'Analyze 7.5 and NIfTI in two files (.hdr, .img)',
  endings: ['hdr', 'img'],
  // A file of samples has no mark.
  beginning: null,
  // A single NIfTI file, which has the mark "n+1" or "n+2", is recognized before.
  // Programs that keep both kinds of header write the length of this one before the mark of DICOM.
  matches: ({ bytes, unpacked }) => detectNifti(unpacked ?? bytes) !== null && !isDicom(unpacked ?? bytes),
  takesFiles: true,
  load: async () => (await import('#rare/formats/analyze/read-analyze.ts')).readAnalyze,
};
