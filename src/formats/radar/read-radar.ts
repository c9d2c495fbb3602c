import { VolumeViewError } from '../../core/errors.ts';
import type { GrayImage } from '../../volume/mosaic.ts';
import type { Budget } from '../base/budget.ts';
import type { DecodedVolume, DecodeSettings } from '../base/decoded-volume.ts';
import type { FormatReader } from '../base/format.ts';
import { isMinc } from '../minc/is-minc.ts';
import { buildPolarVolume } from './build-polar-volume.ts';
import type { readScanOfSweeps } from './level3-scans.ts';
import type { RadarFile } from './radar-file.ts';

/** Radar files; HDF5 may hold ODIM_H5 or CfRadial. */
export type RadarKind = 'hdf5' | 'netcdf3' | 'nexrad' | 'level3' | 'rainbow';

/**
 * Reads a radar file and converts the chosen moment to a volume on its polar grid. An HDF5 file may also be MINC 2, which
 * is read as such.
 */
export function radarReader(kind: RadarKind): FormatReader {
  return async (input, settings, context) => {
    const { bytes } = input;
    const { onProgress, onRadar, budget } = context;
    if (kind === 'hdf5' && isMinc(bytes))
      return (await import('../minc/read-minc.ts')).readMinc(input, settings, context);
    onRadar?.();
    if (kind === 'level3' && context.further.length > 0)
      return (await import('./level3-scans.ts')).readLevel3Scans(input, settings, context);
    onProgress(0, bytes.length);
    return buildPolarVolume(await openRadar(kind, bytes, budget), settings, budget);
  };
}

/** Reads a scan of several files again, see ScanOfSweeps. */
export const readSweepsAgain: typeof readScanOfSweeps = async (...args) =>
  (await import('./level3-scans.ts')).readScanOfSweeps(...args);

/** Each format's reader is loaded when such a file is opened. */
export async function openRadar(kind: RadarKind, bytes: Uint8Array<ArrayBuffer>, budget?: Budget): Promise<RadarFile> {
  switch (kind) {
    case 'hdf5':
      return (await import('./hdf5-radar.ts')).readHdf5Radar(bytes, budget);
    case 'netcdf3':
      return (await import('./cfradial1.ts')).readCfradial1(bytes, budget);
    case 'nexrad':
      return (await import('./nexrad.ts')).readNexrad(bytes, budget);
    case 'level3':
      return (await import('./level3-scans.ts')).readLevel3(bytes, budget);
    case 'rainbow':
      return (await import('./rainbow.ts')).readRainbow(bytes, budget);
  }
}

/**
 * Makes a volume of a radar's mosaic.
 * @param format - the image's format
 * @param budget - of the load
 * @throws {VolumeViewError} `mosaic/layout`
 */
export async function readRadarMosaic(
  image: GrayImage,
  format: string,
  settings: DecodeSettings,
  budget: Budget,
): Promise<DecodedVolume> {
  const { elevations, values = {} } = settings;
  if (!elevations) {
    throw new VolumeViewError(
      'mosaic/layout',
      'coordinates="spherical" got a mosaic without elevations; expected elevations="0.5 1.2 …", degrees, one for each tile',
    );
  }
  const { readPolarMosaic } = await import('./polar-mosaic.ts');
  const { mosaic, slices, range, azimuth } = settings; // From attributes, else from the manifest.
  const { slope = 1, intercept = 0, unit = '', moment = settings.moment } = values;
  const file = readPolarMosaic(image, format, {
    ...values,
    mosaic,
    slices,
    elevations,
    range,
    azimuth,
    slope,
    intercept,
    unit,
    moment,
  });
  return buildPolarVolume(file, settings, budget);
}
