// What a run can be told, so that a quick one is possible: REPEATS=1 SIZES=128 ERROR_SIZE=32 SCENES=mni152 npm run bench -- quality
import { findSharedData } from '../../scripts/shared-data.mjs';

/** Timed runs of each thing; medians are reported. */
export const repeats = Number(process.env.REPEATS ?? 5);

/** Rays along each side of the pictures whose errors are measured. */
export const errorSize = Number(process.env.ERROR_SIZE ?? 128);

/**
 * Pixels along each side of square pictures.
 * @param {readonly number[]} usual
 */
export function readSizes(usual) {
  return process.env.SIZES?.split(',').map(Number) ?? [...usual];
}

/** Volumes that are measured, see bench-scenes.ts; without the shared data, what there is. */
export function readScenes() {
  if (process.env.SCENES) return process.env.SCENES.split(',');
  const isThere = findSharedData('/shared-data/medical/aorta_mosaic/aorta4096.png') !== null;
  if (!isThere) console.log('left out: the aorta and the skull (they need ../shared/data); the CT phantom stands in');
  return [...(isThere ? ['mni152', 'aorta', 'cranium'] : ['mni152', 'ct-phantom']), 'shell', 'specks', 'wires'];
}
