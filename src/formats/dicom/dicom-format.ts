import type { VolumeFormat } from '../base/format.ts';
import { isDicom } from './is-dicom.ts';

export const dicom: VolumeFormat = {
  name: 'DICOM',
  words: 'DICOM (.dcm)',
  endings: ['dcm', 'dicom', 'ima'],
  beginning: 'a DICOM header',
  matches: ({ bytes }) => isDicom(bytes),
  takesFiles: true,
  isSlice: true,
  load: async () => (await import('#rare/formats/dicom/read-dicom.ts')).readDicom,
};
