// The files of the specs' volumes. `WRITE_DATA=1 npx playwright test test/e2e/data.spec.ts` writes them.
import { gzipSync } from 'fflate';
import { encode } from 'fast-png';
import { niftiBytes } from '../../helpers/nifti-bytes.ts';
import { ball, field } from './volumes.ts';

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
