import type { Vector3 } from './matrix.ts';
import type { Samples } from './samples.ts';

/** One channel of a volume of several: what a microscope saw of one dye, for instance. */
export interface ChannelInfo {
  /** Its number in the file, from 1. */
  readonly number: number;
  /** What the file calls it; '' where it does not. */
  readonly name: string;
  /** Red, green and blue, 0..1. */
  readonly color: Vector3;
  /** The data values that are black, and that have all of the colour. */
  readonly window: readonly [number, number];
}

/** A channel with its values. */
export interface Channel extends ChannelInfo {
  /** On the grid of the volume. Data value = slope * sample + intercept; NaN means no data. */
  readonly samples: Samples;
  readonly slope: number;
  readonly intercept: number;
}

/** What makes a volume out of several channels, or out of colours: these are the channels R, G and B. */
export interface ChannelColors {
  /** For each voxel red, green, blue, and what they are divided by, 0..255: the brightness of channels, or 255 in volumes of colours and in pictures of channels. */
  readonly colors: Uint8Array<ArrayBuffer>;
  /** The number of `colors` that is full light. */
  readonly full: number;
  readonly list: readonly Channel[];
  /** What a page may know of them. */
  readonly infos: readonly ChannelInfo[];
}

/** Channels as one volume. */
interface MixedChannels extends ChannelColors {
  /** The brightness of each voxel: brightness = slope * sample. */
  readonly samples: Uint8Array<ArrayBuffer>;
  readonly slope: number;
}

/**
 * Adds the light of channels, voxel by voxel. Each one gives its colour times the share of its window, 0..1, at which its value is. The sum of the
 * shares is the brightness, and the sum of the colours its light: red, green and blue are never above it.
 * Both are rounded to 255 steps of the largest brightness. Where a channel has no data it gives nothing.
 * @param isPicture - the light is a picture, as that of one slice: it is kept up to full light, above which each colour ends, and where there is none it is black
 */
export function mixChannels(list: readonly Channel[], isPicture = false): MixedChannels {
  const { length } = list[0].samples;
  const shares = list.map(sharesOf);
  let max = 0;
  for (let i = 0; i < length; i++) {
    let sum = 0;
    for (const share of shares) sum += share(i);
    if (sum > max) max = sum;
  }
  const largest = max || 1;
  const scale = 255 / largest;
  const full = isPicture ? 255 : scale;
  const samples = new Uint8Array(length);
  const colors = new Uint8Array(4 * length);
  for (let i = 0; i < length; i++) {
    let [sum, red, green, blue] = [0, 0, 0, 0];
    for (let c = 0; c < shares.length; c++) {
      const share = shares[c](i);
      const { color } = list[c];
      sum += share;
      red += share * color[0];
      green += share * color[1];
      blue += share * color[2];
    }
    samples[i] = Math.round(scale * sum);
    colors[4 * i] = Math.min(255, Math.round(full * red));
    colors[4 * i + 1] = Math.min(255, Math.round(full * green));
    colors[4 * i + 2] = Math.min(255, Math.round(full * blue));
    colors[4 * i + 3] = isPicture ? 255 : samples[i];
  }
  const infos = list.map(infoOf);
  return { samples, slope: largest / 255, colors, full, list, infos };
}

/**
 * The colours of voxels, as a file has them. What is between voxels has the mean of their colours, and the opacity of its brightness.
 * @param planes - red, green and blue of all voxels, 0..255; they are kept
 */
export function keepColors(planes: readonly Uint8Array<ArrayBuffer>[]): ChannelColors {
  const list = planes.map((samples, c): Channel => ({
    number: c + 1,
    name: 'RGB'[c],
    color: [Number(c === 0), Number(c === 1), Number(c === 2)],
    window: [0, 255],
    samples,
    slope: 1,
    intercept: 0,
  }));
  const colors = new Uint8Array(4 * planes[0].length).fill(255);
  for (let i = 0; i < planes[0].length; i++) for (let c = 0; c < 3; c++) colors[4 * i + c] = planes[c][i];
  return { colors, full: 255, list, infos: list.map(infoOf) };
}

const infoOf = ({ number, name, color, window }: Channel): ChannelInfo => ({ number, name, color, window });

/** The share of its window that a channel has in a voxel, 0..1. */
function sharesOf({ samples, slope, intercept, window: [low, high] }: Channel): (voxel: number) => number {
  const of = (sample: number): number => {
    const share = (slope * sample + intercept - low) / (high - low);
    return share > 0 ? Math.min(1, share) : 0; // NaN is no data.
  };
  if (samples instanceof Float32Array) return (voxel) => of(samples[voxel]);
  const known = Float64Array.from({ length: samples instanceof Uint8Array ? 0x100 : 0x10000 }, (_, sample) =>
    of(sample),
  );
  return (voxel) => known[samples[voxel]];
}

const planes = new WeakMap<Uint8Array, readonly Uint8Array<ArrayBuffer>[]>();

/** Red, green, blue and brightness of all voxels, each for itself. They are kept as long as the colours are. */
export function planesOf({ colors }: Pick<ChannelColors, 'colors'>): readonly Uint8Array<ArrayBuffer>[] {
  const known =
    planes.get(colors) ??
    [0, 1, 2, 3].map((part) => {
      const plane = new Uint8Array(colors.length / 4);
      for (let voxel = 0; voxel < plane.length; voxel++) plane[voxel] = colors[4 * voxel + part];
      return plane;
    });
  planes.set(colors, known);
  return known;
}
