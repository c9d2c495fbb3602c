import { spacingOf } from '../volume/grid.ts';
import { summarize } from '../volume/histogram.ts';
import { buildMacrocells } from '../volume/macrocells.ts';
import { chooseReduction, reduceVolume } from '../volume/reduce.ts';
import type { DeviceLimits } from '../volume/reduce.ts';
import type { Volume } from '../volume/volume.ts';
import type { DecodedVolume } from './decoded-volume.ts';
import type { CoarseListener, CoarseVolume } from './load-request.ts';

/** Volumes of more bytes than this get a coarse one that stands in for them. */
export const minForCoarse = 2 ** 25;

/** Maximum number of bytes of a coarse volume: 128 x 128 x 128 voxels of 16 bits. */
export const maxCoarse = 2 ** 22;

/**
 * Make a decoded volume fit the device, and count its values.
 * @param onCoarse - is told a stand-in for a large volume as soon as its values are counted
 */
export function finishVolume(decoded: DecodedVolume, limits: DeviceLimits, onCoarse?: CoarseListener): Volume {
  if (decoded.polar) return finishPolar(decoded, decoded.macrocells!);
  const factors = chooseReduction(decoded, limits);
  const isReduced = factors.some((f) => f > 1);
  const { dimensions, samples, indexToWorld } = isReduced ? reduceVolume(decoded, factors) : decoded;
  const { samples: _all, macrocells: _none, ...rest } = decoded;
  const outline: CoarseVolume['of'] = {
    ...rest,
    dimensions,
    indexToWorld,
    spacing: spacingOf(indexToWorld),
    ...summarize(samples, decoded.slope, decoded.intercept),
    ...(isReduced ? { reduced: { from: decoded.dimensions, to: dimensions } } : {}),
  };
  if (onCoarse && samples.byteLength > minForCoarse) onCoarse(makeCoarse(outline, samples, limits));
  return { ...outline, samples, macrocells: buildMacrocells(samples, dimensions) };
}

/** It lies where the large one lies, and has its range and histogram: so it gets the same camera and the same colours. */
function makeCoarse(of: CoarseVolume['of'], all: Volume['samples'], limits: DeviceLimits): CoarseVolume {
  const block = { dimensions: of.dimensions, samples: all, indexToWorld: of.indexToWorld };
  const { dimensions, samples, indexToWorld } = reduceVolume(block, chooseReduction(block, { ...limits, maxBytes: maxCoarse }));
  const volume: Volume = {
    ...of,
    dimensions,
    samples,
    indexToWorld,
    spacing: spacingOf(indexToWorld),
    macrocells: buildMacrocells(samples, dimensions),
    coarse: true,
  };
  return { volume, of };
}

/** Radar gates are never averaged: too many of them for a device are an error. */
function finishPolar(decoded: DecodedVolume, macrocells: Volume['macrocells']): Volume {
  const { samples, slope, intercept, indexToWorld } = decoded;
  const minValid = samples instanceof Float32Array ? -Infinity : 1;
  return { ...decoded, spacing: spacingOf(indexToWorld), macrocells, ...summarize(samples, slope, intercept, minValid), hasNoData: true };
}
