import { summarize } from '../../volume/histogram.ts';
import type { PolarVolume } from '../../volume/volume.ts';
import type { DecodedPolarVolume } from '../decoded-volume.ts';
import { suggestRadarLook } from './suggest-radar-look.ts';

/** Radar gates are never averaged: too many of them for a device are an error. */
export function finishPolar(decoded: DecodedPolarVolume): PolarVolume {
  const { samples, slope, intercept } = decoded;
  const minValid = samples instanceof Float32Array ? -Infinity : 1;
  const volume: PolarVolume = { ...decoded, ...summarize(samples, slope, intercept, minValid), hasNoData: true };
  return { ...volume, ...suggestRadarLook(volume) };
}
