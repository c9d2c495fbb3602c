import { mixChannels } from '../../src/volume/channels.ts';
import type { Channel } from '../../src/volume/channels.ts';
import { summarize } from '../../src/volume/histogram.ts';
import { buildMacrocells } from '../../src/volume/macrocells.ts';
import type { Vector3 } from '../../src/volume/matrix.ts';
import type { Volume } from '../../src/volume/volume.ts';
import { smoothField, syntheticVolume } from './synthetic.ts';

/** Three fields of the unit cube, 0..1: a wave, a ball, and a slope that is dark in half of the cube. */
export const channelFields: readonly ((x: number, y: number, z: number) => number)[] = [
  smoothField,
  (x, y, z) => Math.exp(-9 * ((x - 0.4) ** 2 + (y - 0.6) ** 2 + (z - 0.4) ** 2)),
  (x, y) => Math.max(0, x + y - 1),
];

export const channelColors: readonly Vector3[] = [
  [0.1, 0.9, 0.3],
  [1, 0.2, 0.9],
  [0.2, 0.4, 1],
];

/** Channels of these fields, on one grid. */
export function channelVolumes(dimensions: Vector3): Volume[] {
  return channelFields.map((field) => syntheticVolume({ dimensions, kind: 'uint16', field }));
}

/** The volume that shows them together. */
export function channelVolume(dimensions: Vector3): Volume {
  const volumes = channelVolumes(dimensions);
  const list = volumes.map(({ samples, slope, intercept }, i): Channel => ({
    number: i + 1,
    name: ['DNA', 'actin', ''][i],
    color: channelColors[i],
    window: [0, 1],
    samples,
    slope,
    intercept,
  }));
  const { samples, slope, ...channels } = mixChannels(list);
  const { grid, unit, format } = volumes[0];
  return {
    grid,
    unit,
    format,
    samples,
    slope,
    intercept: 0,
    macrocells: buildMacrocells(samples, dimensions),
    ...summarize(samples, slope, 0),
    channels,
  };
}
