import type { VolumeFormat } from '../base/format.ts';
import { isDicom } from './is-dicom.ts';

export const dicom: VolumeFormat = {
  name: 'DICOM',
  words: 'DICOM (.dcm)',
  endings: ['dcm', 'dicom', 'ima'],
  // The reader itself refuses other files: the usual words for it have the name of the file.
  beginning: null,
  matches: ({ bytes, unpacked }) => isDicom(unpacked ?? bytes),
  takesFiles: true,
  isSlice: true,
  load: async () => (await import('#rare/formats/dicom/read-dicom.ts')).readDicom,
};
