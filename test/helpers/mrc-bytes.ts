/** Words of an MRC header, numbered from 1 as MRC2014 does: whole numbers, and floats. */
export interface MrcWords {
  readonly ints?: Readonly<Record<number, number>>;
  readonly floats?: Readonly<Record<number, number>>;
  /** Byte 212: 0x44 for the low byte first, 0x11 for the high one. */
  readonly stamp?: number;
  readonly littleEndian?: boolean;
  readonly samples?: Uint8Array;
}

/** An MRC file of 3 x 2 x 2 voxels of 8 bits and 1 Angstrom, unless words say something else. */
export function mrcBytes({
  ints = {},
  floats = {},
  stamp = 0x44,
  littleEndian = true,
  samples = Uint8Array.from({ length: 12 }, (_, i) => 20 * i),
}: MrcWords = {}): Uint8Array<ArrayBuffer> {
  const bytes = new Uint8Array(1024 + samples.length);
  const view = new DataView(bytes.buffer);
  const whole = { 1: 3, 2: 2, 3: 2, 4: 0, 8: 3, 9: 2, 10: 2, 17: 1, 18: 2, 19: 3, ...ints };
  for (const [word, n] of Object.entries(whole)) view.setInt32(4 * Number(word) - 4, n, littleEndian);
  const parts = { 11: 3, 12: 2, 13: 2, 14: 90, 15: 90, 16: 90, ...floats };
  for (const [word, n] of Object.entries(parts)) view.setFloat32(4 * Number(word) - 4, n, littleEndian);
  bytes.set([0x4d, 0x41, 0x50, 0x20, stamp, stamp], 208);
  bytes.set(samples, 1024);
  return bytes;
}
