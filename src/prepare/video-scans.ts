import { VolumeViewError } from '../core/errors.ts';
import type { ByteStore } from '../sources/byte-store.ts';
import { isPolar } from '../volume/volume.ts';
import type { Volume } from '../volume/volume.ts';
import { decodeSource } from './decode-source.ts';
import type { DecodeOptions } from './decode-source.ts';
import type { Source } from './find-sources.ts';
import { describeVolume, sizeOfRadar } from './prepare-source.ts';
import type { VolumeReport } from './prepare-source.ts';
import { unused } from './video-codes.ts';
import { writeMosaic } from './write-mosaic.ts';
import { writeRadar } from './write-radar.ts';

/** Edge of the largest picture: what decoders of videos take. */
const maxEdge = 4096;

/** One scan as a mosaic. */
export interface VideoScan {
  readonly volume: Volume;
  readonly isRadar: boolean;
  readonly time: string | null;
  readonly width: number;
  readonly height: number;
  /** Data values of the pixels, NaN for no data, `unused` in tiles without a slice. */
  readonly values: Float64Array;
  /** Between two pixels' values. */
  readonly step: number;
  /** What is said of it, but how its pixels are numbers. */
  readonly manifest: Readonly<Record<string, unknown>>;
  readonly report: Pick<VolumeReport, 'format' | 'unit' | 'dimensions' | 'from' | 'time' | 'left'>;
}

/**
 * All scans of a source, one after another.
 * @throws {VolumeViewError} where one can't be read, or holds labels, or where there are several series
 */
export async function* readVideoScans(
  store: ByteStore,
  source: Source,
  options: DecodeOptions,
): AsyncGenerator<VideoScan> {
  for await (const one of decodeSource(store, source, options)) {
    if ('error' in one) throw one.error;
    const { volume, time, number, series } = one;
    if (series > 0) throw new VolumeViewError('format/unsupported', 'got several series; expected one for a video');
    if (volume.isDiscrete)
      throw new VolumeViewError(
        'format/unsupported',
        'got labels or kinds of echo, which a video would mix; expected values, or no video',
      );
    const isRadar = isPolar(volume);
    const written = isPolar(volume)
      ? {
          ...(await writeRadar(store, source.first, number - 1, options.moment)),
          dimensions: sizeOfRadar(volume.grid),
          from: [],
        }
      : writeMosaic(volume, maxEdge);
    const { dimensions, from } = written;
    const { width, height, data } = written.image;
    const { slope = 1, intercept = 0, noData, prepared: _, time: _own, ...manifest } = written.manifest;
    const empty = isRadar ? 0 : noData;
    const values = Float64Array.from(data, (pixel) => (pixel === empty ? NaN : slope * pixel + intercept));
    if (!isRadar) leaveOutTiles(values, written.manifest, { width, height });
    const report = {
      ...describeVolume({ volume, time }, []),
      dimensions,
      ...(isRadar || String(from) === String(dimensions) ? {} : { from }),
    };
    yield { volume, isRadar, time, width, height, values, step: slope, manifest, report };
  }
}

/** Marks the pixels of tiles that hold no slice. */
function leaveOutTiles(
  values: Float64Array,
  { mosaic, slices = 0 }: { readonly mosaic: string; readonly slices?: number },
  { width, height }: Pick<VideoScan, 'width' | 'height'>,
): void {
  const [columns, rows] = mosaic.split('x').map(Number);
  const [tileWidth, tileHeight] = [width / columns, height / rows];
  for (let tile = slices; tile < columns * rows; tile++) {
    const left = (tile % columns) * tileWidth;
    for (let y = 0; y < tileHeight; y++) {
      const start = (Math.floor(tile / columns) * tileHeight + y) * width + left;
      values.fill(unused, start, start + tileWidth);
    }
  }
}
