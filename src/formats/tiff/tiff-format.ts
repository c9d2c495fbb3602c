import type { VolumeFormat } from '../base/format.ts';
import { startsWith } from '../base/starts-with.ts';

/** Little and big endian, of 32 and of 64 bits (BigTIFF). */
const marks = ['II*\0', 'MM\0*', 'II+\0', 'MM\0+'];

export const tiff: VolumeFormat = {
  name: 'TIFF',
  words: 'TIFF, OME-TIFF (.tif, .tiff)',
  endings: ['tif', 'tiff'],
  beginning: 'the mark of a TIFF file',
  matches: ({ bytes, unpacked }) => marks.some((mark) => startsWith(unpacked ?? bytes, mark)),
  takesFiles: true,
  mayBeSlice: true,
  load: async () => (await import('#rare/formats/tiff/read-tiff.ts')).readTiff,
};
