import { cartesianGrid } from '../volume/grid.ts';
import { summarize } from '../volume/histogram.ts';
import { buildMacrocells } from '../volume/macrocells.ts';
import { chooseReduction, reduceVolume } from '../volume/reduce.ts';
import type { DeviceLimits } from '../volume/reduce.ts';
import type { PolarVolume, Volume } from '../volume/volume.ts';
import type { DecodedCartesianVolume, DecodedPolarVolume, DecodedVolume } from './decoded-volume.ts';
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
  return isPolarVolume(decoded) ? finishPolar(decoded) : finishCartesian(decoded, limits, onCoarse);
}

function isPolarVolume(decoded: DecodedVolume): decoded is DecodedPolarVolume {
  return decoded.grid.kind === 'polar';
}

function finishCartesian(decoded: DecodedCartesianVolume, limits: DeviceLimits, onCoarse?: CoarseListener): Volume {
  const block = { ...decoded.grid, samples: decoded.samples };
  const factors = chooseReduction(block, limits);
  const isReduced = factors.some((f) => f > 1);
  const { dimensions, samples, indexToWorld } = isReduced ? reduceVolume(block, factors) : block;
  const { samples: _all, ...rest } = decoded;
  const outline: CoarseVolume['of'] = {
    ...rest,
    grid: cartesianGrid(dimensions, indexToWorld),
    ...summarize(samples, decoded.slope, decoded.intercept),
    ...(isReduced ? { reduced: { from: block.dimensions, to: dimensions } } : {}),
  };
  if (onCoarse && samples.byteLength > minForCoarse) onCoarse(makeCoarse(outline, samples, limits));
  return { ...outline, samples, macrocells: buildMacrocells(samples, dimensions) };
}

/** It lies where the large one lies, and has its range and histogram: so it gets the same camera and the same colours. */
function makeCoarse(of: CoarseVolume['of'], all: Volume['samples'], limits: DeviceLimits): CoarseVolume {
  const block = { ...of.grid, samples: all };
  const { dimensions, samples, indexToWorld } = reduceVolume(block, chooseReduction(block, { ...limits, maxBytes: maxCoarse }));
  const volume: Volume = {
    ...of,
    grid: cartesianGrid(dimensions, indexToWorld),
    samples,
    macrocells: buildMacrocells(samples, dimensions),
    coarse: true,
  };
  return { volume, of };
}

/** Radar gates are never averaged: too many of them for a device are an error. */
export function finishPolar(decoded: DecodedPolarVolume): PolarVolume {
  const { samples, slope, intercept } = decoded;
  const minValid = samples instanceof Float32Array ? -Infinity : 1;
  return { ...decoded, ...summarize(samples, slope, intercept, minValid), hasNoData: true };
}
