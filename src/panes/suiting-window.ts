import { windowFromHistogram } from '../optics/transfer/window.ts';
import type { Volume } from '../volume/volume.ts';
import { windowAround } from './gray-levels.ts';

/** Soft tissue, Hounsfield units: the usual first window for a CT. */
const softTissue = windowAround(40, 400);

/** The default window for slices of a volume: data values of black and white. */
export function suitingWindow({
  unit,
  transferFunction,
  window,
  histogram,
}: Pick<Volume, 'unit' | 'transferFunction' | 'window' | 'histogram'>): readonly [number, number] {
  const isCt = unit === 'HU' || (unit === '' && transferFunction === 'ct-bone');
  return isCt ? softTissue : (window ?? windowFromHistogram(histogram));
}

/** Whether slices of a volume use its transfer function's colours by default. */
export function suitsColors({
  isDiscrete,
  transferFunction,
}: Pick<Volume, 'isDiscrete' | 'transferFunction'>): boolean {
  return isDiscrete === true || transferFunction === 'diverging';
}
