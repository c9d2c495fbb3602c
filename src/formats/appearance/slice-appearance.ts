import { isSingleSlice } from '../../volume/volume.ts';
import { ctSliceStops, isGraySlice, sliceStops } from '../../volume/slice-stops.ts';
import type { Histogram } from '../../volume/histogram.ts';
import type { DecodedCartesianVolume } from '../base/decoded-volume.ts';
import { findMostFrequent, pictureWindow, sortValues } from './picture-window.ts';
import { presetOfUnit } from './suggested-appearance.ts';
import type { SuggestedAppearance } from './suggested-appearance.ts';

/** Numbers of 8 bits that go above this are gray values of a screen. */
const darkest = 127;

/** Black and white of soft tissue, Hounsfield units: centre 40, width 400. */
const softTissue = [-160, 240] as const;

/** A CT in which fewer pixels than this share are soft tissue, such as a piece of a lung, has a window of its own values. */
const fewSoft = 0.02;

/** White of a PET in SUV, at least: with less, a slice of a healthy body would be as bright as one with hot spots. */
const usualUptake = 5;

/** In a map of both signs, such as t, at least this share of the pixels is exactly 0: what lies outside of the brain, or below a threshold. */
const usualZeros = 0.25;

/**
 * The appearance of one slice: a picture in gray, as people look at radiographs, films and single slices. Labels, statistics and reflectivities keep their colours.
 * @param found - what its values suggest of any volume
 */
export function sliceAppearance(
  decoded: DecodedCartesianVolume,
  histogram: Histogram,
  found: SuggestedAppearance | null,
): SuggestedAppearance | null {
  const { grid, channels, samples, slope, intercept, unit, levels } = decoded;
  // The coarsest level of a pyramid may be one slice where finer ones are volumes.
  const finest = levels ? { ...grid, dimensions: levels[0].dimensions } : grid;
  if (channels || !isSingleSlice(grid) || !isSingleSlice(finest)) return found;
  const isCt = unit === 'HU' || found?.transferFunction === presetOfUnit('HU');
  if (!isCt && presetOfUnit(unit) !== undefined) return found;
  const sorted = sortValues(samples, slope, intercept);
  if (!isGray(decoded, histogram) && hasMeaning(decoded, found, { histogram, sorted })) return found;
  const isScreen = isBytes(decoded) && (histogram.high > darkest || histogram.low === histogram.high);
  const window = isCt && hasSoftTissue(sorted) ? softTissue : isScreen ? ([0, 255] as const) : pictureWindow(sorted);
  return {
    window: unit === 'SUV' ? [0, Math.max(usualUptake, window[1])] : window,
    transferFunction: isCt ? ctSliceStops : sliceStops,
  };
}

/** Whether the numbers are bytes as they are, or turned, as where white is said to be 0. */
const isBytes = ({ samples, slope, intercept }: DecodedCartesianVolume): boolean =>
  samples instanceof Uint8Array && (slope === 1 ? intercept === 0 : slope === -1 && intercept === 255);

/**
 * Whether its file shows that it is a picture in gray, whatever its values are like: it has windows from black to white, it is DICOM, whose labels
 * are said to be some, it is one time of a film, or it has nothing but the black and the white of a screen.
 */
function isGray(decoded: DecodedCartesianVolume, { low, high, counts }: Histogram): boolean {
  const { isLabels, windows, format, transferFunction } = decoded;
  if (isLabels) return false;
  // A TIFF of one bit has 0 and 1.
  const white = format.includes('TIFF') ? high : 255;
  const isBlackAndWhite = isBytes(decoded) && low === 0 && high === white && countValues(counts) === 2;
  return isBlackAndWhite || !!windows?.length || format.startsWith('DICOM') || isGraySlice(transferFunction);
}

/** Whether its colours say what a value means: labels, a mask, or a map in which 0 means nothing. */
function hasMeaning(
  { intent, isLabels }: DecodedCartesianVolume,
  found: SuggestedAppearance | null,
  { histogram, sorted }: { readonly histogram: Histogram; readonly sorted: Float64Array },
): boolean {
  if (found?.transferFunction !== 'diverging')
    return found !== null && (!!isLabels || !!found.isDiscrete || isMask(histogram));
  const { first, count } = findMostFrequent(sorted);
  return !!intent || (sorted[first] === 0 && count >= usualZeros * sorted.length);
}

/** Whether values are 0 and another one, which may be rare. */
const isMask = ({ low, counts }: Histogram): boolean => low === 0 && countValues(counts) === 2;

const countValues = (counts: Uint32Array): number => counts.filter(Boolean).length;

function hasSoftTissue(sorted: Float64Array): boolean {
  const soft = sorted.filter((value) => value > softTissue[0] && value < softTissue[1]);
  return soft.length >= fewSoft * sorted.length;
}
