import type { VolumeFormat } from '../base/format.ts';
import { findLevel3 } from './level3-message.ts';
import { hdf5, netcdf3, nexrad } from './radar-formats.ts';
import type { RadarKind } from './read-radar.ts';

// Radar files that few pages have; those of most are in radar-formats.ts.

/** A product of one sweep, plain or packed with gzip as a whole. Several of one scan are its sweeps. */
export const level3: VolumeFormat = {
  name: 'NEXRAD Level III',
  words: 'a product of NEXRAD Level III',
  endings: ['nids'],
  beginning: null,
  matches: ({ bytes, unpacked }) => findLevel3(unpacked ?? bytes) >= 0,
  takesFiles: true,
  isSlice: true,
  load: async () => (await import('#rare/formats/radar/read-radar.ts')).radarReader('level3'),
};

/** A volume or a sweep of Rainbow 5, plain or packed with gzip as a whole. */
export const rainbow: VolumeFormat = {
  name: 'Rainbow',
  words: 'a volume of Rainbow 5 (.vol)',
  endings: ['azi'],
  beginning: '<volume version=',
  matches: ({ bytes, unpacked }) => {
    const start = String.fromCharCode(...(unpacked ?? bytes).subarray(0, 200));
    return /^\s*(<\?xml[^>]{0,100}>\s*)?<volume version=/.test(start);
  },
  load: async () => (await import('#rare/formats/radar/read-radar.ts')).radarReader('rainbow'),
};

/** All radar files, with the reader's name for each. */
export const radarKinds = new Map<VolumeFormat, RadarKind>([
  [hdf5, 'hdf5'],
  [netcdf3, 'netcdf3'],
  [nexrad, 'nexrad'],
  [level3, 'level3'],
  [rainbow, 'rainbow'],
]);
