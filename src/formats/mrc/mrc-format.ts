import type { VolumeFormat } from '../base/format.ts';

export const mrc: VolumeFormat = {
  name: 'MRC',
  words: 'MRC, CCP4 map (.mrc, .mrcs, .ccp4)',
  endings: ['mrc', 'mrcs', 'ccp4'],
  beginning: 'an MRC header, which has the letters MAP at byte 208',
  matches: ({ bytes, unpacked }) => isMrc(unpacked ?? bytes),
  load: async () => (await import('#rare/formats/mrc/read-mrc.ts')).readMrc,
};

/** The letters MAP, which are followed by a blank or, of some programs, by a zero. Source: MRC2014, word 53 */
function isMrc(bytes: Uint8Array): boolean {
  return (
    bytes.length > 212 && String.fromCharCode(...bytes.subarray(208, 211)) === 'MAP' && [0, 0x20].includes(bytes[211])
  );
}
