import { summarize } from '../../volume/histogram.ts';
import { chooseCellSize } from '../../volume/cell-size.ts';
import { emptyMacrocells } from '../../volume/macrocells.ts';
import type { DecodedPolarVolume } from '../base/decoded-volume.ts';
import type { CoarseVolume } from '../base/load-request.ts';
import { suggestRadarAppearance } from './suggest-radar-appearance.ts';
import type { PolarOutline } from './suggest-radar-appearance.ts';

/** Larger radar volumes, bytes, are not reported before their macrocells are made: the report would need a second copy. */
const maxPreviewBytes = 2 ** 24;

/** Radar gates are never averaged: if there are too many of them for a device, it is an error. */
export function outlinePolar({ makeMacrocells: _later, kinds, ...decoded }: DecodedPolarVolume): PolarOutline {
  const { samples, slope, intercept } = decoded;
  const minValid = samples instanceof Float32Array ? -Infinity : 1;
  const outline = { ...decoded, ...summarize(samples, slope, intercept, { minValid }), hasNoData: true };
  return { ...outline, ...suggestRadarAppearance(outline, kinds) };
}

/** A copy with empty macrocells, so that the renderer can prepare for this volume; null for a large one. */
export function predictPolar({ samples, ...of }: PolarOutline): CoarseVolume | null {
  if (samples.byteLength > maxPreviewBytes) return null;
  const { dimensions } = of.grid;
  return {
    volume: {
      ...of,
      samples: samples.slice(),
      macrocells: emptyMacrocells(samples, dimensions, chooseCellSize(dimensions)),
      coarse: true,
    },
    of,
  };
}
