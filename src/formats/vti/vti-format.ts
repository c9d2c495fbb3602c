import type { VolumeFormat } from '../base/format.ts';

export const vti: VolumeFormat = {
  name: 'VTI',
  words: 'VTK image data (.vti)',
  endings: ['vti'],
  beginning: '<VTKFile type="ImageData">',
  matches: ({ text }) =>
    /^(?:<\?xml[^>]{0,200}>\s*)?(?:<!--[^]{0,400}?-->\s*)?<VTKFile\b[^>]{0,300}\btype\s*=\s*["']ImageData["']/.test(
      text,
    ),
  load: async () => (await import('#rare/formats/vti/read-vti.ts')).readVti,
};
