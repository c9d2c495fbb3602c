import { lumaOf } from '../../src/formats/base/channels.ts';
import { keepColors, mixChannels } from '../../src/volume/channels.ts';
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

/** The same fields as the red, green and blue of a file. */
export function colorVolume(dimensions: Vector3): Volume {
  const volumes = channelVolumes(dimensions);
  const { length } = volumes[0].samples;
  const rgb = Uint8Array.from({ length: 3 * length }, (_, at) => {
    const { samples, slope, intercept } = volumes[at % 3];
    return Math.max(0, Math.min(255, Math.round(255 * (slope * samples[Math.floor(at / 3)] + intercept))));
  });
  const samples = Uint8Array.from({ length }, (_, i) => lumaOf(rgb[3 * i], rgb[3 * i + 1], rgb[3 * i + 2]));
  const { grid, unit, format } = volumes[0];
  return {
    ...{ grid, unit, format, samples, slope: 1, intercept: 0 },
    macrocells: buildMacrocells(samples, dimensions),
    ...summarize(samples, 1, 0),
    channels: keepColors([0, 1, 2].map((c) => rgb.filter((_, at) => at % 3 === c))),
  };
}

/** Red, green and blue of each voxel of a volume in colours; undefined for others. */
export function rgbOf({ channels }: Volume): number[] | undefined {
  if (!channels) return undefined;
  const { colors, list } = channels;
  const rgb = Array.from({ length: (3 * colors.length) / 4 }, (_, at) => colors[4 * Math.floor(at / 3) + (at % 3)]);
  if (rgb.some((number, at) => list[at % 3].samples[Math.floor(at / 3)] !== number))
    throw new Error('what is drawn is not what is picked');
  return rgb;
}
