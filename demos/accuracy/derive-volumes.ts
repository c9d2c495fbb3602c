import { cartesianGrid } from '../../src/volume/grid.ts';
import { summarize } from '../../src/volume/histogram.ts';
import { buildMacrocells } from '../../src/volume/macrocells.ts';
import { reduceVolume } from '../../src/volume/reduce.ts';
import type { Volume } from '../../src/volume/volume.ts';

/** The same volume with so many per cent of its voxels along each axis: means over boxes. */
export function reduceTo(volume: Volume, percent: 100 | 50 | 25): Volume {
  if (percent === 100) return volume;
  const factor = 100 / percent;
  const block = reduceVolume({ ...volume.grid, samples: volume.samples }, [factor, factor, factor]);
  return {
    ...volume,
    samples: block.samples,
    grid: cartesianGrid(block.dimensions, block.indexToWorld),
    macrocells: buildMacrocells(block.samples, block.dimensions),
    ...summarize(block.samples, volume.slope, volume.intercept),
  };
}

/** The same volume in 8 bits over the full range of its values. */
export function quantizeTo8Bits(volume: Volume): Volume {
  if (volume.samples instanceof Uint8Array) return volume;
  const [low, high] = volume.range;
  const slope = (high - low) / 255 || 1;
  const samples = Uint8Array.from(volume.samples, (stored) =>
    Math.round((volume.slope * stored + volume.intercept - low) / slope),
  );
  return { ...volume, samples, slope, intercept: low, macrocells: buildMacrocells(samples, volume.grid.dimensions) };
}
