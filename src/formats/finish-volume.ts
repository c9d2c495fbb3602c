import { spacingOf } from '../volume/grid.ts';
import { summarize } from '../volume/histogram.ts';
import { buildMacrocells } from '../volume/macrocells.ts';
import { chooseReduction, reduceVolume } from '../volume/reduce.ts';
import type { DeviceLimits } from '../volume/reduce.ts';
import type { Volume } from '../volume/volume.ts';
import type { DecodedVolume } from './decoded-volume.ts';

/** Make a decoded volume fit the device, and count its values. */
export function finishVolume(decoded: DecodedVolume, limits: DeviceLimits): Volume {
  if (decoded.polar) return finishPolar(decoded, decoded.macrocells!);
  const factors = chooseReduction(decoded, limits);
  const isReduced = factors.some((f) => f > 1);
  const block = isReduced ? reduceVolume(decoded, factors) : decoded;
  const { dimensions, samples, indexToWorld } = block;
  return {
    ...decoded,
    dimensions,
    samples,
    indexToWorld,
    spacing: spacingOf(indexToWorld),
    macrocells: buildMacrocells(samples, dimensions),
    ...summarize(samples, decoded.slope, decoded.intercept),
    ...(isReduced ? { reduced: { from: decoded.dimensions, to: dimensions } } : {}),
  };
}

/** Rays keep their gates: what a device can not hold, it says. */
function finishPolar(decoded: DecodedVolume, macrocells: Volume['macrocells']): Volume {
  const { samples, slope, intercept, indexToWorld } = decoded;
  const leastValid = samples instanceof Float32Array ? -Infinity : 1;
  return { ...decoded, spacing: spacingOf(indexToWorld), macrocells, ...summarize(samples, slope, intercept, leastValid), hasNoData: true };
}
