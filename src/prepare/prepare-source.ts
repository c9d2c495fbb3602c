import { VolumeViewError } from '../core/errors.ts';
import type { ByteStore } from '../sources/byte-store.ts';
import { isPolar } from '../volume/volume.ts';
import type { PolarGrid } from '../volume/polar-grid.ts';
import type { Volume } from '../volume/volume.ts';
import { decodeSource } from './decode-source.ts';
import type { DecodeOptions, SourceVolume } from './decode-source.ts';
import type { Source } from './find-sources.ts';
import { drawPoster } from './draw-poster.ts';
import { encodePoster } from './encode-poster.ts';
import { encodePng } from './radar-mosaic.ts';
import { layOut } from './mosaic-layout.ts';
import { maxMosaicEdge, phoneMosaicEdge, writeMosaic } from './write-mosaic.ts';
import { makeOmeZarr } from './write-ome-zarr.ts';
import { writeRadar } from './write-radar.ts';
import type { StoreFile } from './zarr-arrays.ts';

/** How volumes are written. */
export interface PrepareOptions extends DecodeOptions {
  /** For which devices a volume is made smaller. */
  readonly fit: 'desktop' | 'phone';
  /** Pixels across and down of the picture of a volume; 0 for none. */
  readonly poster: number;
}

/** Which volumes become pyramids: all, or those that are larger than a mosaic. */
export interface PyramidOptions {
  readonly of: 'all' | 'large';
  /** gzip. */
  pack(bytes: Uint8Array): Uint8Array;
}

/** What is said of a volume that was written: numbers and words of the program, nothing else of the file. */
export interface VolumeReport {
  readonly format: string;
  readonly unit: string;
  /** Voxels along i, j and k; of a radar the gates, rays and sweeps of its largest sweep. */
  readonly dimensions: readonly number[];
  /** The same before it was made smaller; absent if it was not. */
  readonly from?: readonly number[];
  /** Of a pixel, or of a number of a pyramid. */
  readonly bits: number;
  /** Of the image, or of all files of a pyramid; of a video its part of them. */
  readonly bytes: number;
  /** In data values. Of labels that were made smaller it has the share of voxels that changed. */
  readonly error: { readonly max: number; readonly rms: number; readonly changedLabels?: number };
  /** A number with its unit, or ISO 8601 of a radar's scan or a manifest. */
  readonly time?: string;
  /** What of the file is not in the volume, in words. */
  readonly left?: readonly string[];
}

/** A volume in the form in which a web server has it. */
export interface PreparedVolume {
  readonly number: number;
  /** See `SourceVolume`. */
  readonly series: number;
  readonly png: Uint8Array;
  /** A picture of it, as PNG; null if there is none. */
  readonly poster: Uint8Array | null;
  /** Without the name of the image. */
  readonly manifest: object;
  readonly report: VolumeReport;
}

/** A volume as an OME-Zarr. */
export interface PreparedPyramid extends Pick<PreparedVolume, 'number' | 'series' | 'poster'> {
  /** Read once, while they are written. */
  readonly files: Iterable<StoreFile>;
  readonly report: Omit<VolumeReport, 'bytes'>;
}

/** A volume that could not be written. */
export interface PrepareFailure {
  readonly number: number;
  readonly code: string;
  readonly message: string;
}

/**
 * Makes all volumes of a source ready, one after another: as mosaics where nothing is said of pyramids.
 * @throws {VolumeViewError} where the first one can't be read
 */
export function prepareSource(
  store: ByteStore,
  source: Source,
  options: PrepareOptions,
): AsyncGenerator<PreparedVolume | PrepareFailure>;
export function prepareSource(
  store: ByteStore,
  source: Source,
  options: PrepareOptions,
  pyramids: PyramidOptions | undefined,
): AsyncGenerator<PreparedVolume | PreparedPyramid | PrepareFailure>;
export async function* prepareSource(
  store: ByteStore,
  source: Source,
  options: PrepareOptions,
  pyramids?: PyramidOptions,
): AsyncGenerator<PreparedVolume | PreparedPyramid | PrepareFailure> {
  for await (const one of decodeSource(store, source, options)) {
    try {
      if ('error' in one) throw one.error;
      yield (
        (pyramids && (await preparePyramid(one, options, pyramids))) ??
        (await prepareMosaic(store, source, one, options))
      );
    } catch (error) {
      yield { number: one.number, ...describeFailure(error) };
    }
  }
}

/** The code and the words of an error. Of an error that is none of ours only its kind is said: its words may have parts of a file. */
export function describeFailure(error: unknown): { readonly code: string; readonly message: string } {
  if (error instanceof VolumeViewError) return { code: error.code, message: error.message };
  const kind = error instanceof Error ? error.constructor.name : typeof error;
  return { code: 'internal', message: `this file makes volume-view-prepare fail (${kind}); please report it` };
}

/** @returns null where a volume becomes a mosaic: it is not large, or OME-Zarr can't say where its voxels are */
async function preparePyramid(
  { number, series, volume, time }: SourceVolume,
  { poster: posterSize }: PrepareOptions,
  pyramids: PyramidOptions,
): Promise<PreparedPyramid | null> {
  const { dimensions } = volume.grid;
  if (pyramids.of === 'large' && (isPolar(volume) || layOut(dimensions, maxMosaicEdge))) return null;
  try {
    const { bits, error, files } = makeOmeZarr(volume, (bytes) => pyramids.pack(bytes));
    const report = { ...describeVolume({ volume, time }, []), dimensions, bits, error };
    return { number, series, poster: await posterOf(volume, posterSize), files, report };
  } catch (error) {
    if (pyramids.of === 'large' && error instanceof VolumeViewError) return null;
    throw error;
  }
}

/** What is said of a volume in each form. @param more - what the form leaves out */
export function describeVolume(
  { volume: { format, unit, left, radar }, time }: Pick<SourceVolume, 'volume' | 'time'>,
  more: readonly string[],
): Pick<VolumeReport, 'format' | 'unit' | 'time' | 'left'> {
  const all = [...more, ...(left ?? []), ...(radar?.left ?? []), ...(radar?.partial ? [radar.partial] : [])];
  return { format, unit, ...(time === null ? {} : { time }), ...(all.length > 0 ? { left: all } : {}) };
}

/** Gates, rays and sweeps, of the largest sweep. */
export const sizeOfRadar = ({ sweeps }: PolarGrid): number[] => [
  Math.max(...sweeps.map(({ gates }) => gates)),
  Math.max(...sweeps.map(({ azimuths }) => azimuths.length)),
  sweeps.length,
];

export const posterOf = async (volume: Volume, size: number): Promise<Uint8Array | null> =>
  size > 0 ? encodePoster(await drawPoster(volume, size)) : null;

async function prepareMosaic(
  store: ByteStore,
  { first }: Source,
  { number, series, volume: { channels, ...volume }, time }: SourceVolume,
  { fit, moment, poster: posterSize }: PrepareOptions,
): Promise<PreparedVolume> {
  const colors = channels ? ['the colours: a mosaic holds one number for each voxel, which is their brightness'] : [];
  const said = describeVolume({ volume, time }, colors);
  const poster = await posterOf(volume, posterSize);
  if (isPolar(volume)) {
    const { image, manifest, rounding, rms } = await writeRadar(store, first, number - 1, moment);
    const png = encodePng(image);
    const dimensions = sizeOfRadar(volume.grid);
    return {
      number,
      series,
      png,
      poster,
      manifest,
      report: { ...said, dimensions, bits: bitsOf(image), bytes: png.length, error: { max: rounding, rms } },
    };
  }
  const { image, manifest, error, dimensions, from } = writeMosaic(
    volume,
    fit === 'phone' ? phoneMosaicEdge : maxMosaicEdge,
  );
  const png = encodePng(image);
  const isReduced = String(from) !== String(dimensions);
  return {
    number,
    series,
    png,
    poster,
    manifest,
    report: {
      ...said,
      dimensions,
      ...(isReduced ? { from } : {}),
      bits: bitsOf(image),
      bytes: png.length,
      error,
    },
  };
}

const bitsOf = ({ data }: { readonly data: Uint8Array | Uint16Array }): number => 8 * data.BYTES_PER_ELEMENT;
