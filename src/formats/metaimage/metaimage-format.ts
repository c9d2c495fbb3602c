import type { VolumeFormat } from '../base/format.ts';

export const metaImage: VolumeFormat = {
  name: 'MetaImage',
  words: 'MetaImage (.mha, .mhd)',
  endings: ['mha', 'mhd'],
  beginning: 'the lines of a MetaImage header',
  // Lines `name = value`; one of the first says what the object is, or how many axes it has.
  matches: ({ text }) =>
    /^(?:[A-Za-z]\w*[ \t]*[=:][^\r\n]*\r?\n)*(?:ObjectType[ \t]*[=:][ \t]*Image|NDims[ \t]*[=:][ \t]*\d)/.test(text),
  takesFiles: true,
  load: async () => (await import('#rare/formats/metaimage/read-metaimage.ts')).readMetaImage,
};
