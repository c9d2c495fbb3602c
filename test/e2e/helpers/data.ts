// The files of the specs' volumes. `WRITE_DATA=1 npx playwright test test/e2e/data.spec.ts` writes them.
import { gzipSync } from 'fflate';
import { encode } from 'fast-png';
import type { Volume } from '../../../src/volume/volume.ts';
import { ball, field } from './volumes.ts';

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
  bytes.set(new Uint8Array(samples.buffer), 352);
  return bytes;
}

/** Tiles per row and column of the mosaic. */
export const mosaicTiles = 4;

/** The field's slices as a PNG, row by row from the top left. */
export function mosaicBytes(): Uint8Array {
  const [nx, ny, nz] = field.grid.dimensions;
  const width = nx * mosaicTiles;
  const data = new Uint8Array(width * ny * mosaicTiles);
  for (let k = 0; k < nz; k++) {
    for (let j = 0; j < ny; j++) {
      const row = Math.floor(k / mosaicTiles) * ny + j;
      const from = (k * ny + j) * nx;
      data.set(field.samples.subarray(from, from + nx), row * width + (k % mosaicTiles) * nx);
    }
  }
  return encode({ width, height: ny * mosaicTiles, data, channels: 1, depth: 8 });
}

const manifest = {
  image: 'field.png',
  mosaic: `${mosaicTiles}x${mosaicTiles}`,
  spacing: field.grid.spacing,
  slope: 1 / 255,
  window: [0.1, 0.9],
  unit: 'au',
  title: 'A smooth field',
  credit: 'made by test/e2e/helpers/data.ts',
};

/** Files below test/e2e/pages/data, by name. */
export const files: Readonly<Record<string, Uint8Array>> = {
  'field.nii': niftiBytes(field),
  'field.nii.gz': gzipSync(niftiBytes(field), { mtime: 0 }),
  'field.png': mosaicBytes(),
  'field.json': new TextEncoder().encode(`${JSON.stringify(manifest, null, 2)}\n`),
  'ball.nii': niftiBytes(ball),
};
