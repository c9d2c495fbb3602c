import { VolumeViewError } from '../../core/errors.ts';
import type { DecodedVolume, DecodeSettings } from '../base/decoded-volume.ts';
import { nameOf } from '../base/name-of.ts';
import type { Manifest } from './manifest.ts';

/**
 * The URL of a file that a manifest names.
 * @param base - URL of the manifest
 * @throws {VolumeViewError} `manifest/invalid`
 */
export function resolveFile(field: 'image' | 'files' | 'video', file: string, base: string): string {
  try {
    const { protocol, href } = new URL(file, base);
    if (/^(https?|data):$/.test(protocol)) return href;
  } catch (cause) {
    throw new VolumeViewError(
      'manifest/invalid',
      `the manifest's "${field}" got "${file}", which is no URL from ${nameOf(base)}; expected an absolute URL there`,
      { cause },
    );
  }
  throw new VolumeViewError(
    'manifest/invalid',
    `the manifest's "${field}" got "${file.slice(0, 100)}"; expected a URL that begins with http:, https: or data:, or one relative to the manifest's`,
  );
}

/** What the attributes say, and where they say nothing what the manifest says. */
export function mergeSettings(settings: DecodeSettings, manifest: Manifest): DecodeSettings {
  return {
    ...settings,
    elevations: settings.elevations ?? manifest.elevations,
    range: settings.range ?? manifest.range,
    azimuth: settings.azimuth ?? manifest.azimuth,
    moment: settings.moment ?? manifest.moment,
    values: manifest,
    mosaic: settings.mosaic ?? manifest.mosaic,
    slices: settings.slices ?? manifest.slices,
    channels: manifest.channels,
    spacing: settings.spacing ?? (manifest.indexToWorld ? undefined : manifest.spacing),
    indexToWorld: manifest.indexToWorld,
  };
}

/** Adds to a volume what its manifest says about the values. */
export function describeVolume<T extends DecodedVolume>(volume: T, manifest: Manifest): T {
  const { slope = 1, intercept = 0, unit, window, transferFunction, title, credit, lossy } = manifest;
  const isRescaled = slope !== 1 || intercept !== 0;
  return {
    ...volume,
    slope: slope * volume.slope,
    intercept: slope * volume.intercept + intercept,
    unit: unit ?? volume.unit,
    // A file's own windows are in its own values.
    window: window ?? (isRescaled ? undefined : volume.window),
    windows: isRescaled ? undefined : volume.windows,
    transferFunction,
    title,
    credit,
    ...(lossy ? { lossy } : {}),
  };
}
