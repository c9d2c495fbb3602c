import { VolumeViewError } from '../errors.ts';
import { chooseScan } from './choose-scan.ts';
import type { DecodedCartesianVolume, DecodedVolume, DecodeInput, DecodeSettings, ProgressListener } from './decoded-volume.ts';
import { gunzip, maxDeflateRatio } from './gunzip.ts';
import type { ScansListener } from './load-request.ts';
import type { Manifest } from './manifest.ts';
import { cartesianGrid } from '../volume/grid.ts';
import type { GrayImage } from '../volume/mosaic.ts';
import { isPolar } from '../volume/volume.ts';
import { NeedsMainThread } from './needs-main-thread.ts';
import { respace } from './respace.ts';
import { nameOf, sniffFile } from './sniff.ts';
import type { FileKind } from './sniff.ts';

export interface DecodeContext {
  readonly onProgress: ProgressListener;
  /** Fetch the file that a manifest names, by its absolute URL. */
  fetchImage(url: string): Promise<DecodeInput>;
  readonly onScans?: ScansListener;
}

/**
 * Turn a file's bytes into a volume. A format's reader is loaded when it is needed.
 * @throws {VolumeViewError} `format/…`, `mosaic/layout`, `manifest/invalid`, and what `fetchImage` throws
 * @throws {NeedsMainThread} in a worker that can not do it
 */
export async function decodeFile(input: DecodeInput, settings: DecodeSettings, context: DecodeContext): Promise<DecodedVolume> {
  try {
    const kind = await sniffFile(input);
    return kind === 'manifest'
      ? await decodeManifest(input, settings, context)
      : await decodeData(kind, input, settings, context.onProgress);
  } catch (cause) {
    throw explain(cause, input);
  }
}

async function decodeData(
  kind: Exclude<FileKind, 'manifest'>,
  input: DecodeInput,
  settings: DecodeSettings,
  onProgress: ProgressListener,
): Promise<DecodedVolume> {
  const { bytes } = input;
  onProgress(0, bytes.length);
  switch (kind) {
    case 'nifti':
    case 'nifti-gz': {
      const { readNifti } = await loadReader(() => import('./nifti.ts'));
      const isPacked = kind === 'nifti-gz';
      const pieces = isPacked ? gunzip(bytes) : yieldOnce(bytes);
      const volume = await readNifti({ pieces, atMost: isPacked ? bytes.length * maxDeflateRatio : bytes.length, onProgress });
      return placeVolume(volume, settings);
    }
    case 'png': {
      const { readPng } = await loadReader(() => import('./png.ts'));
      return readImage(readPng(bytes, settings.channels), 'PNG', settings);
    }
    case 'jpeg':
    case 'webp': {
      const { readImagePixels } = await loadReader(() => import('./image-pixels.ts'));
      return readImage(await readImagePixels(bytes, `image/${kind}`, settings.channels), kind === 'jpeg' ? 'JPEG' : 'WebP', settings);
    }
    case 'hdf5':
    case 'netcdf3':
    case 'nexrad': {
      const { readRadar } = await loadReader(() => import('./radar/read-radar.ts'));
      return readRadar(kind, bytes, settings);
    }
  }
}

/** A mosaic's tiles are slices, or a radar's sweeps. */
async function readImage(image: GrayImage, format: string, settings: DecodeSettings): Promise<DecodedVolume> {
  if (isRadar(settings)) {
    const { readRadarMosaic } = await loadReader(() => import('./radar/read-radar.ts'));
    return readRadarMosaic(image, format, settings);
  }
  const { readMosaic } = await loadReader(() => import('./mosaic.ts'));
  return readMosaic(image, format, settings);
}

function isRadar({ spherical, elevations }: DecodeSettings): boolean {
  return spherical ?? elevations !== undefined;
}

/** What a manifest says holds where the attributes, which are `settings`, say nothing. */
async function decodeManifest(input: DecodeInput, settings: DecodeSettings, context: DecodeContext): Promise<DecodedVolume> {
  const { readManifest } = await loadReader(() => import('./manifest.ts'));
  const { scans, ...single } = readManifest(input.bytes);
  if (scans) context.onScans?.(scans.map(({ time }) => time));
  const manifest = scans ? scans[chooseScan(scans.map(({ time }) => time), settings.scan ?? { index: 0 }).index] : single;
  const image = await context.fetchImage(resolveImage(manifest.image, input.url));
  const kind = await sniffFile(image);
  if (kind === 'manifest') {
    throw new VolumeViewError('manifest/invalid', `the manifest's "image" got another manifest, ${nameOf(image.url)}; expected an image or a NIfTI file`);
  }
  const merged: DecodeSettings = {
    ...settings,
    elevations: settings.elevations ?? manifest.elevations,
    range: settings.range ?? manifest.range,
    azimuth: settings.azimuth ?? manifest.azimuth,
    values: manifest,
    mosaic: settings.mosaic ?? manifest.mosaic,
    slices: settings.slices ?? manifest.slices,
    channels: manifest.channels,
    spacing: settings.spacing ?? (manifest.indexToWorld ? undefined : manifest.spacing),
    indexToWorld: manifest.indexToWorld,
  };
  const volume = await decodeData(kind, image, merged, context.onProgress);
  // The values of a radar's mosaic are what its reader made of them already.
  return describeVolume(volume, isPolar(volume) ? { ...manifest, slope: 1, intercept: 0 } : manifest);
}

function resolveImage(image: string, base: string): string {
  try {
    return new URL(image, base).href;
  } catch (cause) {
    throw new VolumeViewError('manifest/invalid', `the manifest's "image" got "${image}", which is no URL from ${nameOf(base)}; expected an absolute URL there`, { cause });
  }
}

/** Add to a volume what its manifest says of the values. */
function describeVolume(volume: DecodedVolume, manifest: Manifest): DecodedVolume {
  const { slope = 1, intercept = 0, unit, window, transferFunction, title, credit } = manifest;
  const isRescaled = slope !== 1 || intercept !== 0;
  return {
    ...volume,
    slope: slope * volume.slope,
    intercept: slope * volume.intercept + intercept,
    unit: unit ?? volume.unit,
    // A file's own window speaks of its own values.
    window: window ?? (isRescaled ? undefined : volume.window),
    transferFunction,
    title,
    credit,
  };
}

/** A file's own place in the world gives way to a manifest's, and its spacing to what an attribute or manifest says. */
function placeVolume(volume: DecodedCartesianVolume, settings: DecodeSettings): DecodedCartesianVolume {
  const { dimensions, indexToWorld } = volume.grid;
  const own = settings.indexToWorld ?? indexToWorld;
  return { ...volume, grid: cartesianGrid(dimensions, settings.spacing ? respace(own, dimensions, settings.spacing) : own) };
}

/** A worker whose page lets it load no further script leaves the work to the main thread. */
async function loadReader<T>(load: () => Promise<T>): Promise<T> {
  try {
    return await load();
  } catch (cause) {
    throw new NeedsMainThread({ cause });
  }
}

async function* yieldOnce(bytes: Uint8Array<ArrayBuffer>): AsyncGenerator<Uint8Array<ArrayBuffer>> {
  yield bytes;
}

/** Nothing but errors with a code leaves this room, and what stops or moves the work. */
function explain(cause: unknown, input: DecodeInput): unknown {
  if (cause instanceof VolumeViewError || cause instanceof NeedsMainThread) return cause;
  if (cause instanceof DOMException && cause.name === 'AbortError') return cause;
  const name = nameOf(input.url);
  if (cause instanceof RangeError) {
    return new VolumeViewError('format/too-large', `${name} needs more memory than the browser gives; use a smaller file`, { cause });
  }
  const why = cause instanceof Error ? cause.message : String(cause);
  return new VolumeViewError('format/corrupt', `${name} can not be decoded (${why}); the file may be damaged`, { cause });
}
