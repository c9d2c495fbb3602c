import type { VolumeFormat } from '../base/format.ts';

export const manifest: VolumeFormat = {
  name: 'manifest',
  words: 'a manifest (.json)',
  endings: ['json'],
  beginning: null,
  matches: ({ text }) => text.startsWith('{'),
  load: async () => (await import('#rare/formats/manifest/read-manifest.ts')).readManifestVolume,
};
