import { isSingleSlice } from '../../volume/volume.ts';
import { sliceStops } from '../../volume/slice-stops.ts';
import { spanAround } from '../../optics/transfer/span-around.ts';
import type { Histogram } from '../../volume/histogram.ts';
import type { DecodedCartesianVolume } from '../base/decoded-volume.ts';
import { presetOfUnit } from './suggested-appearance.ts';
import type { SuggestedAppearance } from './suggested-appearance.ts';

/** So many of the darkest and of the brightest pixels may be black and white. */
const beyond = 0.005;

/** Numbers of 8 bits that go above this are gray values of a screen. */
const darkest = 127;

/** Black and white of soft tissue, Hounsfield units: centre 40, width 400. */
const softTissue = [-160, 240] as const;

/**
 * The appearance of one slice: a picture in gray, as people look at radiographs, films and single slices. Labels, statistics and reflectivities keep their colours.
 * @param found - what its values suggest of any volume
 */
export function sliceAppearance(
  { grid, channels, samples, slope, intercept, unit }: DecodedCartesianVolume,
  histogram: Histogram,
  found: SuggestedAppearance | null,
): SuggestedAppearance | null {
  const isCt = unit === 'HU' || found?.transferFunction === presetOfUnit('HU');
  const isMask = found !== null && histogram.counts.filter(Boolean).length === 2;
  const isScale = found?.transferFunction === 'diverging' || (!isCt && presetOfUnit(unit) !== undefined);
  if (channels || !isSingleSlice(grid) || found?.isDiscrete || isMask || isScale) return found;
  const isScreen = samples instanceof Uint8Array && slope === 1 && intercept === 0 && histogram.high > darkest;
  return { window: isCt ? softTissue : isScreen ? [0, 255] : middleOf(histogram), transferFunction: sliceStops };
}

/** From the darkest to the brightest value, without the few that lie apart. */
function middleOf({ low, high, counts }: Histogram): readonly [number, number] {
  if (!(high > low)) return spanAround(low);
  const few = beyond * counts.reduce((sum, count) => sum + count, 0);
  let [below, above] = [0, counts.length];
  for (let left = few; left >= counts[below]; below++) left -= counts[below];
  for (let left = few; left >= counts[above - 1]; above--) left -= counts[above - 1];
  const width = (high - low) / counts.length;
  return [low + below * width, low + above * width];
}
