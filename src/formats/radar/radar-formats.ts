import type { VolumeFormat } from '../base/format.ts';
import { findHdf5 } from '../base/hdf-signature.ts';
import { startsWith } from '../base/starts-with.ts';
import type { RadarKind } from './read-radar.ts';

const words = 'a radar scan (ODIM_H5, CfRadial, NEXRAD Level II)';

const load =
  (kind: RadarKind): VolumeFormat['load'] =>
  async () =>
    (await import('#rare/formats/radar/read-radar.ts')).radarReader(kind);

/** ODIM_H5, and CfRadial in NetCDF-4. */
export const hdf5: VolumeFormat = {
  name: 'HDF5',
  words,
  endings: ['h5', 'hdf', 'hdf5', 'nc', 'nc4'],
  beginning: 'the signature of HDF5 or NetCDF',
  matches: ({ bytes }) => findHdf5(bytes) >= 0,
  load: load('hdf5'),
};

/** CfRadial. */
export const netcdf3: VolumeFormat = {
  name: 'NetCDF-3',
  words,
  endings: [],
  beginning: null,
  matches: ({ bytes }) => ['\x01', '\x02', '\x05'].some((version) => startsWith(bytes, `CDF${version}`)),
  load: load('netcdf3'),
};

/** Plain, or packed with gzip as a whole. */
export const nexrad: VolumeFormat = {
  name: 'NEXRAD Level II',
  words,
  endings: [],
  beginning: null,
  matches: ({ bytes, unpacked }) => isNexrad(unpacked ?? bytes),
  load: load('nexrad'),
};

/** The volume header of an Archive II file; older ones say ARCHIVE2. */
function isNexrad(bytes: Uint8Array): boolean {
  return startsWith(bytes, 'AR2V') || startsWith(bytes, 'ARCHIVE2.');
}
