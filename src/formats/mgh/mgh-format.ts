import type { VolumeFormat } from '../base/format.ts';

export const mgh: VolumeFormat = {
  name: 'MGH',
  words: 'MGH (.mgh, .mgz)',
  endings: ['mgh', 'mgz'],
  beginning: 'the version 1 of an MGH header',
  matches: ({ bytes, unpacked }) => isMgh(unpacked ?? bytes),
  load: async () => (await import('#rare/formats/mgh/read-mgh.ts')).readMgh,
};

/** MGH has no mark. It begins with version 1, above which are bits for the file's purpose; at 20 is a small number, its type. */
function isMgh(bytes: Uint8Array): boolean {
  const zeros = [0, 1, 20, 21, 22];
  return bytes.length > 24 && bytes[3] === 1 && zeros.every((at) => bytes[at] === 0);
}
