import { VolumeViewError } from '../core/errors.ts';
import type { ByteStore } from '../sources/byte-store.ts';
import { isPolar } from '../volume/volume.ts';
import { decodeSource } from './decode-source.ts';
import type { DecodeOptions, SourceVolume } from './decode-source.ts';
import type { Source } from './find-sources.ts';
import { drawPoster } from './draw-poster.ts';
import { encodePoster } from './encode-poster.ts';
import { encodePng } from './radar-mosaic.ts';
import { maxMosaicEdge, phoneMosaicEdge, writeMosaic } from './write-mosaic.ts';
import { writeRadar } from './write-radar.ts';

/** How volumes are written. */
export interface PrepareOptions extends DecodeOptions {
  /** For which devices a volume is made smaller. */
  readonly fit: 'desktop' | 'phone';
  /** Pixels across and down of the picture of a volume; 0 for none. */
  readonly poster: number;
}

/** What is said of a volume that was written: numbers and words of the program, nothing else of the file. */
export interface VolumeReport {
  readonly format: string;
  readonly unit: string;
  /** Voxels along i, j and k; of a radar the gates, rays and sweeps of its largest sweep. */
  readonly dimensions: readonly number[];
  /** The same before it was made smaller; absent if it was not. */
  readonly from?: readonly number[];
  /** Of a pixel. */
  readonly bits: number;
  /** Of the image. */
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

/** A volume that could not be written. */
export interface PrepareFailure {
  readonly number: number;
  readonly code: string;
  readonly message: string;
}

/**
 * Makes all volumes of a source ready, one after another.
 * @throws {VolumeViewError} where the first one can't be read
 */
export async function* prepareSource(
  store: ByteStore,
  source: Source,
  options: PrepareOptions,
): AsyncGenerator<PreparedVolume | PrepareFailure> {
  for await (const one of decodeSource(store, source, options)) {
    try {
      if ('error' in one) throw one.error;
      yield await prepareVolume(store, source, one, options);
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

async function prepareVolume(
  store: ByteStore,
  { first }: Source,
  { number, series, volume: { channels, ...volume }, time }: SourceVolume,
  { fit, moment, poster: posterSize }: PrepareOptions,
): Promise<PreparedVolume> {
  const { format, unit } = volume;
  const left = [
    ...(channels ? ['the colours: a mosaic holds one number for each voxel, which is their brightness'] : []),
    ...(volume.left ?? []),
    ...(volume.radar?.left ?? []),
    ...(volume.radar?.partial ? [volume.radar.partial] : []),
  ];
  const said = { format, unit, ...(time === null ? {} : { time }), ...(left.length > 0 ? { left } : {}) };
  const poster = posterSize > 0 ? encodePoster(await drawPoster(volume, posterSize)) : null;
  if (isPolar(volume)) {
    const { image, manifest, rounding, rms } = await writeRadar(store, first, number - 1, moment);
    const png = encodePng(image);
    const sweeps = volume.grid.sweeps;
    const dimensions = [
      Math.max(...sweeps.map(({ gates }) => gates)),
      Math.max(...sweeps.map(({ azimuths }) => azimuths.length)),
      sweeps.length,
    ];
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
