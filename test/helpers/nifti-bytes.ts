import type { Volume } from '../../src/volume/volume.ts';

const dataTypes = { Uint8Array: [2, 8], Uint16Array: [512, 16], Float32Array: [16, 32] } as const;

/** A NIfTI-1 file, little-endian, with the affine as its sform. */
export function niftiBytes(volume: Volume): Uint8Array<ArrayBuffer> {
  const { samples, slope, intercept } = volume;
  const { dimensions, spacing, indexToWorld } = volume.grid;
  const [code, bits] = dataTypes[samples.constructor.name as keyof typeof dataTypes];
  const bytes = new Uint8Array(352 + samples.byteLength);
  const view = new DataView(bytes.buffer);
  view.setInt32(0, 348, true);
  [3, ...dimensions, 1, 1, 1, 1].forEach((n, i) => view.setInt16(40 + 2 * i, n, true));
  view.setInt16(70, code, true);
  view.setInt16(72, bits, true);
  [1, ...spacing].forEach((s, i) => view.setFloat32(76 + 4 * i, s, true));
  view.setFloat32(108, 352, true);
  view.setFloat32(112, slope, true);
  view.setFloat32(116, intercept, true);
  bytes[123] = 2; // millimetres
  view.setInt16(254, 1, true);
  indexToWorld.slice(0, 12).forEach((entry, i) => view.setFloat32(280 + 4 * i, entry, true));
  bytes.set([0x6e, 0x2b, 0x31, 0], 344);
  bytes.set(new Uint8Array(samples.buffer, samples.byteOffset, samples.byteLength), 352);
  return bytes;
}
