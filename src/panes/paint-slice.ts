import { evaluate, largestValue } from '../optics/transfer/transfer-function.ts';
import type { TransferFunction } from '../optics/transfer/transfer-function.ts';
import { valueOf } from '../volume/index-numbers.ts';
import { grayRange } from './gray-levels.ts';
import type { GrayLevels } from './gray-levels.ts';

/** Data value = slope * stored + intercept, or `ids[stored]` if there are `ids`. */
export interface StoredScale {
  readonly slope: number;
  readonly intercept: number;
  readonly ids?: readonly number[];
}

/** Fills a picture, RGBA, from stored values; it is transparent where there is no value. */
export type Painter = (values: Float64Array, pixels: Uint8ClampedArray, range: readonly [number, number]) => void;

/** Exact grey: rounded once, to 8 bits. */
export function grayPainter(levels: GrayLevels, { slope, intercept, ids }: StoredScale): Painter {
  const range = grayRange(levels);
  // 255 times what is larger may be more than a number holds.
  const part = Math.max(...range.map(Math.abs)) > largestValue ? 2 ** -20 : 1;
  const [black, white] = range.map((end) => end * part);
  return (values, pixels, [begin, end]) => {
    for (let i = begin, at = 4 * begin; i < end; i++, at += 4) {
      const value = part * (ids ? (ids[values[i]] ?? NaN) : slope * values[i] + intercept);
      if (Number.isNaN(value)) {
        pixels[at + 3] = 0;
        continue;
      }
      const gray = white > black ? (255 * (value - black)) / (white - black) : value > white ? 255 : 0;
      pixels[at] = pixels[at + 1] = pixels[at + 2] = gray; // The array clamps and rounds.
      pixels[at + 3] = 255;
    }
  };
}

/** Number of different colours in the table. */
const tableSize = 4096;

/**
 * The colours of a transfer function on an opaque ground, as in a legend: opacity does not darken them. Where the
 * transfer function is fully transparent, the picture is too. The values between the first and the last stop have 4,096
 * colours; each label has its own.
 */
export function colorPainter(stops: TransferFunction, scale: StoredScale, isDiscrete: boolean): Painter {
  const [low, high] = [stops[0].value, stops.at(-1)!.value];
  const colors = new Map<number, readonly number[]>();
  const colorOf = (value: number): readonly number[] => {
    const step = isDiscrete
      ? value
      : Math.round(((Math.min(high, Math.max(low, value)) - low) / (high - low || 1)) * tableSize);
    let color = colors.get(step);
    if (!color) {
      const [r, g, b, a] = evaluate(stops, isDiscrete ? value : low + (step / tableSize) * (high - low));
      color = a > 0 ? [(255 * r) / a, (255 * g) / a, (255 * b) / a, 255] : [0, 0, 0, 0];
      if (colors.size <= 2 ** 16) colors.set(step, color);
    }
    return color;
  };
  return (values, pixels, [begin, end]) => {
    for (let i = begin; i < end; i++) {
      const value = valueOf(scale, values[i]);
      if (Number.isNaN(value)) pixels[4 * i + 3] = 0;
      else pixels.set(colorOf(value), 4 * i);
    }
  };
}
