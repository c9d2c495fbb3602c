import { cellSize } from '../../volume/cell-size.ts';
import { summarize } from '../../volume/histogram.ts';
import { emptyMacrocells } from '../../volume/macrocells.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import type { DecodedPolarVolume } from '../base/decoded-volume.ts';
import type { CoarseVolume } from '../base/load-request.ts';
import { suggestRadarLook } from './suggest-radar-look.ts';
import type { PolarOutline } from './suggest-radar-look.ts';

/** Of a radar of more bytes nothing is told before its macrocells are made: there would be a second copy of it meanwhile. */
const mostForetold = 2 ** 24;

/** Radar gates are never averaged: too many of them for a device are an error. */
export function outlinePolar({ makeMacrocells: _later, ...decoded }: DecodedPolarVolume): PolarOutline {
  const { samples, slope, intercept } = decoded;
  const minValid = samples instanceof Float32Array ? -Infinity : 1;
  const outline = { ...decoded, ...summarize(samples, slope, intercept, minValid), hasNoData: true };
  return { ...outline, ...suggestRadarLook(outline) };
}

/** The same with macrocells that hold nothing, in memory of its own; null of a large one. */
export function foretellPolar({ samples, ...of }: PolarOutline): CoarseVolume | null {
  if (samples.byteLength > mostForetold) return null;
  const cells = of.grid.dimensions.map((n) => Math.ceil(n / cellSize)) as unknown as Vector3;
  return { volume: { ...of, samples: samples.slice(), macrocells: emptyMacrocells(samples, cells), coarse: true }, of };
}
