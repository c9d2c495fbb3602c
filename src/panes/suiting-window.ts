import { windowFromHistogram } from '../optics/transfer/window.ts';
import type { Volume } from '../volume/volume.ts';
import { windowAround } from './gray-levels.ts';

/** Soft tissue, Hounsfield units: the usual first window for a CT whose file has none. */
const softTissue = windowAround(40, 400);

/** The default window for slices of a volume: data values of black and white. The first one of a file comes first, as in DICOM viewers. */
export function suitingWindow({
  unit,
  transferFunction,
  window,
  windows,
  histogram,
}: Pick<Volume, 'unit' | 'transferFunction' | 'window' | 'windows' | 'histogram'>): readonly [number, number] {
  const [first] = windows ?? [];
  if (first) return [first.from, first.to];
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
