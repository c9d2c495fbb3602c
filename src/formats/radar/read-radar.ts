import type { DecodedVolume } from '../decoded-volume.ts';
import type { RadarKind } from '../sniff.ts';
import { buildPolarVolume } from './build-polar-volume.ts';
import type { PolarSettings } from './build-polar-volume.ts';
import type { RadarFile } from './radar-file.ts';

/** Read a radar file and bring the moment that is asked for to a volume on its polar grid. */
export async function readRadar(kind: RadarKind, bytes: Uint8Array<ArrayBuffer>, settings: PolarSettings): Promise<DecodedVolume> {
  return buildPolarVolume(await openRadar(kind, bytes), settings);
}

/** Each format's reader is loaded when such a file is opened. */
export async function openRadar(kind: RadarKind, bytes: Uint8Array<ArrayBuffer>): Promise<RadarFile> {
  switch (kind) {
    case 'hdf5':
      return (await import('./hdf5-radar.ts')).readHdf5Radar(bytes);
    case 'netcdf3':
      return (await import('./cfradial1.ts')).readCfradial1(bytes);
    case 'nexrad':
      return (await import('./nexrad.ts')).readNexrad(bytes);
  }
}
