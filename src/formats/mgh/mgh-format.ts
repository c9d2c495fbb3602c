import type { VolumeFormat } from '../base/format.ts';

/** Bytes of the header; the samples follow it. */
export const mghHeaderBytes = 284;

export const mgh: VolumeFormat = {
  name: 'MGH',
  words: 'MGH (.mgh, .mgz)',
  endings: ['mgh', 'mgz'],
  beginning: null,
  matches: ({ bytes, unpacked }) => isMgh(unpacked ?? bytes),
  load: async () => (await import('#rare/formats/mgh/read-mgh.ts')).readMgh,
};

/**
 * MGH has no mark. It begins with version 1 and with four lengths and a type, all big-endian: small numbers, whose first
 * bytes are 0.
 */
function isMgh(bytes: Uint8Array): boolean {
  if (bytes.length < mghHeaderBytes) return false;
  const view = new DataView(bytes.buffer, bytes.byteOffset, mghHeaderBytes);
  const numbers = [1, 2, 3, 4].map((at) => view.getInt32(4 * at));
  return view.getInt32(0) === 1 && numbers.every((n) => n > 0 && n < 2 ** 24) && bytes[20] + bytes[21] + bytes[22] === 0;
}
