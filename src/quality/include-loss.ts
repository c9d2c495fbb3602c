// What a lossy form of a volume, such as a video, leaves in a picture, and how it enters the picture's error.
import { evaluate } from '../optics/transfer/transfer-function.ts';
import type { Premultiplied, TransferFunction } from '../optics/transfer/transfer-function.ts';
import { finestSpacing } from '../volume/grid.ts';
import type { GridFrame } from '../volume/grid.ts';
import type { Histogram } from '../volume/histogram.ts';
import type { Lossy } from '../volume/volume.ts';
import type { ErrorPart, ErrorParts, PictureError } from './error-estimate.ts';

/** How values become colours. */
export interface ColorsOfValues {
  readonly transferFunction: TransferFunction;
  /** Reference lengths per world length, times the opacity factor. */
  readonly opticalScale: number;
}

/** The values that a picture shows, and how far they are apart. */
export interface ShownValues {
  readonly histogram: Histogram;
  readonly grid: GridFrame;
}

/** The light of a pixel is taken to come from so many voxels of one value: of lengths from 1 to 16, this one came closest to what was measured, see docs/numbers/accuracy.md. */
const voxelsDeep = 8;

/** Colours with less opacity show nothing in 8 bits. */
const visible = 0.5 / 255;

/**
 * How much the colours of visible values change where values are off by `apart`: root mean square over the values of a volume, 0..1. It says how one look of a
 * volume compares with another, not what a pixel's error is: errors of neighbouring voxels differ, and some cancel out.
 */
export function changeOfColors(
  { transferFunction, opticalScale }: ColorsOfValues,
  { histogram: { low, high, counts }, grid }: ShownValues,
  apart: number,
): number {
  const depth = voxelsDeep * finestSpacing(grid) * opticalScale;
  const colorOf = (value: number): Premultiplied => {
    const [red, green, blue, opacity] = evaluate(transferFunction, value);
    if (opacity === 0) return [0, 0, 0, 0];
    const seen = -Math.expm1(Math.log1p(-opacity) * depth);
    return [(red / opacity) * seen, (green / opacity) * seen, (blue / opacity) * seen, seen];
  };
  let [sum, seen] = [0, 0];
  counts.forEach((count, bin) => {
    if (count === 0) return;
    const value = low + ((bin + 0.5) / counts.length) * (high - low);
    const color = colorOf(value);
    for (const other of [colorOf(value - apart), colorOf(value + apart)]) {
      if (color[3] < visible && other[3] < visible) continue;
      for (let c = 0; c < 4; c++) sum += count * (other[c] - color[c]) ** 2;
      seen += 4 * count;
    }
  });
  return Math.sqrt(sum / Math.max(1, seen));
}

/**
 * What a lossy form leaves in a picture of the present colours: what was measured when it was made, times how much more the present colours change with the same error of
 * values than the colours of those pictures. No bound of the largest error is known, as a few small pictures were compared; but there is none where no value changed.
 * @param made - the colours of the pictures that were compared when the form was made
 * @returns null where no pictures were compared
 */
export function scaleLoss(
  lossy: Lossy,
  values: ShownValues,
  { now, made }: { readonly now: ColorsOfValues; readonly made: ColorsOfValues },
): ErrorPart | null {
  const { rms, max, picture } = lossy;
  if (!picture) return null;
  const before = changeOfColors(made, values, rms);
  const times = before > 0 ? changeOfColors(now, values, rms) / before : 1;
  const scaled = (error: number): number => Math.min(255, times * error);
  return { rms: scaled(picture.rms), p99: scaled(picture.p99), max: max === 0 ? 0 : null };
}

/** The error of a picture, and with it that of one more cause: squares add up, as the causes do not depend on each other; the largest ones may meet. */
export function includePart(
  whole: PictureError,
  name: Exclude<keyof ErrorParts, 'steps'>,
  part: ErrorPart,
): PictureError {
  const { rms, p99, max, parts = { steps: { rms, p99, max } } } = whole;
  return {
    ...whole,
    rms: Math.hypot(rms, part.rms),
    p99: Math.min(255, p99 + part.p99),
    max: max === null || part.max === null ? null : Math.min(255, max + part.max),
    parts: { ...parts, [name]: part },
  };
}
