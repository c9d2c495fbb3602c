import { windowFromHistogram } from '../optics/transfer/window.ts';
import type { Volume } from '../volume/volume.ts';
import { windowAround } from './gray-levels.ts';

/** Soft tissue, Hounsfield units: what a CT is looked at with first. */
const softTissue = windowAround(40, 400);

/** Data values of black and white for slices of a volume, where nobody says any. */
export function suitingWindow({ unit, transferFunction, window, histogram }: Pick<Volume, 'unit' | 'transferFunction' | 'window' | 'histogram'>): readonly [number, number] {
  const isCt = unit === 'HU' || (unit === '' && transferFunction === 'ct-bone');
  return isCt ? softTissue : (window ?? windowFromHistogram(histogram));
}

/** Whether slices of a volume have its transfer function's colours, where nobody says so. */
export function suitsColors({ isDiscrete, transferFunction }: Pick<Volume, 'isDiscrete' | 'transferFunction'>): boolean {
  return isDiscrete === true || transferFunction === 'diverging';
}
