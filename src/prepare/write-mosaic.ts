import { VolumeViewError } from '../core/errors.ts';
import type { Manifest } from '../formats/manifest/manifest.ts';
import { multiply, scaleAndTranslate } from '../volume/matrix.ts';
import type { Vector3 } from '../volume/matrix.ts';
import type { GrayImage } from '../volume/mosaic.ts';
import { reduceLabels } from '../volume/reduce-labels.ts';
import { reduceDimensions, reduceVolume } from '../volume/reduce.ts';
import type { Block } from '../volume/reduce.ts';
import type { Samples } from '../volume/samples.ts';
import type { Volume } from '../volume/volume.ts';
import { ErrorSum, measureReduction } from './measure-error.ts';
import type { ValueError } from './measure-error.ts';
import { chooseFactors } from './fit-mosaic.ts';
import { layOut } from './mosaic-layout.ts';

/** Edge of the largest mosaic, pixels: what nearly all devices show. */
export const maxMosaicEdge = 8192;

/** Edge of a mosaic for phones: 4 Mi voxels, 8 MiB on the GPU. */
export const phoneMosaicEdge = 2048;

/** A manifest as it is written: `mosaic` and colours are texts, and the name of the image is still missing. */
export type MosaicManifest = Omit<Manifest, 'image' | 'mosaic' | 'labels'> & {
  readonly mosaic: string;
  readonly labels?: readonly { readonly id: number; readonly name?: string; readonly color?: string }[];
};

/** A volume as an image and its manifest. */
export interface VolumeMosaic {
  readonly image: GrayImage;
  readonly manifest: MosaicManifest;
  /** Of labels it is the share of voxels of the original that have another label, as `max` and `rms` have no meaning there. */
  readonly error: ValueError & { readonly changedLabels?: number };
  /** Voxels that the image holds, and before it was made smaller. */
  readonly dimensions: Vector3;
  readonly from: Vector3;
}

/**
 * Writes a volume on a grid of voxels as a mosaic. Numbers of 8 and 16 bits are kept as they are, and whole numbers whose range has 16
 * bits; all others become 65,534 equal steps from the smallest to the largest.
 * @param maxEdge - pixels; a volume that needs more is made smaller
 * @throws {VolumeViewError} `format/unsupported` where labels are too far apart, `format/too-large` where nothing makes it fit
 */
export function writeMosaic(volume: Volume, maxEdge = maxMosaicEdge): VolumeMosaic {
  const { grid, samples, ids, slope, intercept } = volume;
  const valueOf = ids ? (sample: number) => ids[sample] : (sample: number) => slope * sample + intercept;
  const original = { dimensions: grid.dimensions, indexToWorld: grid.indexToWorld, samples, valueOf };
  const factors = chooseFactors({ ...original, isDiscrete: volume.isDiscrete }, maxEdge);
  if (!factors)
    throw new VolumeViewError(
      'format/too-large',
      `a slice of ${grid.dimensions[0]} x ${grid.dimensions[1]} pixels, ${grid.dimensions[2]} times, does not fit into an image of ${maxEdge} x ${maxEdge}`,
    );
  const isReduced = factors.some((factor) => factor > 1);
  const block = !isReduced
    ? original
    : volume.isDiscrete
      ? reduceThings(original, factors)
      : reduceVolume(original, factors);
  const packed = packSamples(block.samples, volume);
  const { columns, rows } = layOut(block.dimensions, maxEdge)!;
  const rounding = isReduced ? null : measureRounding(samples, packed, valueOf);
  const error: VolumeMosaic['error'] =
    rounding ??
    (volume.isDiscrete
      ? { max: 0, rms: 0, changedLabels: countChanged(original, { ...block, samples: packed.pixels }, packed) }
      : measureReduction(original, { ...block, samples: packed.pixels, valueOf: packed.valueOf }));
  const { changedLabels } = error;
  const { unit, window, transferFunction, isDiscrete, anatomical, named, title, credit } = volume;
  return {
    image: tile(packed.pixels, block.dimensions, { columns, rows }),
    dimensions: block.dimensions,
    from: grid.dimensions,
    error,
    manifest: {
      mosaic: `${columns}x${rows}`,
      slices: block.dimensions[2],
      indexToWorld: block.indexToWorld.slice(0, 12),
      slope: packed.slope,
      intercept: packed.intercept,
      ...(packed.noData === undefined ? {} : { noData: packed.noData }),
      ...(unit ? { unit } : {}),
      ...(window && !isDiscrete ? { window } : {}),
      ...(transferFunction && !isDiscrete ? { transferFunction } : {}),
      ...(isDiscrete ? { labels: (named ?? []).map(writeLabel) } : {}),
      ...(anatomical === undefined ? {} : { anatomical }),
      ...(title ? { title } : {}),
      ...(credit ? { credit } : {}),
      prepared: {
        ...(isReduced ? { from: grid.dimensions } : {}),
        ...(changedLabels === undefined ? { maxError: error.max, rmsError: error.rms } : { changedLabels }),
      },
    },
  };
}

const writeLabel = ({ id, name, color }: NonNullable<Volume['named']>[number]) => ({
  id,
  ...(name ? { name: name.slice(0, 200) } : {}),
  ...(color
    ? {
        color: `#${color
          .map((part) =>
            Math.round(255 * part)
              .toString(16)
              .padStart(2, '0'),
          )
          .join('')}`,
      }
    : {}),
});

/** Labels have no mean: a larger voxel has the label that most of it has. */
function reduceThings(block: Block, factors: Vector3): Block {
  const { dimensions: from, samples } = block;
  if (samples instanceof Float32Array)
    throw new VolumeViewError(
      'format/unsupported',
      'its labels are no whole numbers of 16 bits, and it is too large for one image',
    );
  const dimensions = reduceDimensions(from, factors);
  const scale = from.map((n, axis) => n / dimensions[axis]) as unknown as Vector3;
  // The outer faces of the volume stay where they are.
  const shift = scale.map((s) => (s - 1) / 2) as unknown as Vector3;
  return {
    dimensions,
    samples: reduceLabels(
      { dimensions: from, numbers: samples, ids: { length: 2 ** (8 * samples.BYTES_PER_ELEMENT) } },
      dimensions,
    ).numbers,
    indexToWorld: multiply(block.indexToWorld, scaleAndTranslate(scale, shift)),
  };
}

interface Packed {
  readonly pixels: Uint8Array<ArrayBuffer> | Uint16Array<ArrayBuffer>;
  /** Data value = slope * pixel + intercept. */
  readonly slope: number;
  readonly intercept: number;
  readonly noData?: number;
  readonly valueOf: (pixel: number) => number;
}

function packSamples(samples: Samples, { ids, slope, intercept }: Volume): Packed {
  if (!(samples instanceof Float32Array) && !ids)
    return { pixels: samples, slope, intercept, valueOf: (pixel) => slope * pixel + intercept };
  let [low, high, hasNoData, isWhole] = [Infinity, -Infinity, false, true];
  for (const sample of samples) {
    const stored = ids ? ids[sample] : sample;
    if (!Number.isFinite(stored)) hasNoData = true;
    else {
      if (stored < low) low = stored;
      if (stored > high) high = stored;
      isWhole &&= Number.isInteger(stored);
    }
  }
  if (high < low) [low, high] = [0, 0];
  const first = hasNoData ? 1 : 0;
  const top = 65_535 - first;
  // The slope and intercept of ids are 1 and 0.
  const scale = ids ? { slope: 1, intercept: 0 } : { slope, intercept };
  const isExact = isWhole && high - low <= top;
  if (ids && !isExact)
    throw new VolumeViewError(
      'format/unsupported',
      `its labels reach from ${low} to ${high}; expected at most 65,536 from the smallest to the largest, which an image of 16 bits can hold. Renumber them, or put the file itself on the server`,
    );
  const step = isExact || high === low ? 1 : (high - low) / top;
  const Pixels = isExact && high - low + first <= 255 ? Uint8Array : Uint16Array;
  const pixels = new Pixels(samples.length);
  for (let i = 0; i < samples.length; i++) {
    const stored = ids ? ids[samples[i]] : samples[i];
    pixels[i] = Number.isFinite(stored) ? first + Math.round((stored - low) / step) : 0;
  }
  // Pixel `first` has the smallest value.
  const packedSlope = scale.slope * step;
  const packedIntercept = scale.slope * (low - first * step) + scale.intercept;
  return {
    pixels,
    slope: packedSlope,
    intercept: packedIntercept,
    ...(hasNoData ? { noData: 0 } : {}),
    valueOf: (pixel) => (hasNoData && pixel === 0 ? NaN : packedSlope * pixel + packedIntercept),
  };
}

function measureRounding(
  samples: Samples,
  { pixels, valueOf: written }: Packed,
  valueOf: (sample: number) => number,
): ValueError {
  const sum = new ErrorSum();
  if ((samples as unknown) === pixels) return sum.error;
  for (let i = 0; i < samples.length; i++) {
    const difference = written(pixels[i]) - valueOf(samples[i]);
    if (difference === difference) sum.add(difference);
  }
  return sum.error;
}

/** The share of voxels that have another label where each place has the label of the smaller volume's voxel around it. */
function countChanged(
  original: Block & { readonly valueOf: (sample: number) => number },
  smaller: Block,
  { valueOf }: Packed,
): number {
  const [nx, ny, nz] = original.dimensions;
  const [mx, my, mz] = smaller.dimensions;
  let [changed, at] = [0, 0];
  for (let k = 0; k < nz; k++) {
    for (let j = 0; j < ny; j++) {
      const row = mx * (Math.floor(((j + 0.5) * my) / ny) + my * Math.floor(((k + 0.5) * mz) / nz));
      for (let i = 0; i < nx; i++, at++) {
        if (
          valueOf(smaller.samples[row + Math.floor(((i + 0.5) * mx) / nx)]) !== original.valueOf(original.samples[at])
        )
          changed++;
      }
    }
  }
  return changed / original.samples.length;
}

function tile(
  pixels: Packed['pixels'],
  [nx, ny, nz]: Vector3,
  { columns, rows }: { readonly columns: number; readonly rows: number },
): GrayImage {
  const width = columns * nx;
  const data = new (pixels instanceof Uint8Array ? Uint8Array : Uint16Array)(width * rows * ny);
  for (let k = 0; k < nz; k++) {
    const first = Math.floor(k / columns) * ny * width + (k % columns) * nx;
    for (let j = 0; j < ny; j++) data.set(pixels.subarray((k * ny + j) * nx, (k * ny + j + 1) * nx), first + j * width);
  }
  return { width, height: rows * ny, data };
}
