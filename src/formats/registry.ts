import type { Format } from './base/format.ts';
import { jpeg, png, webp } from './images/image-formats.ts';
import { manifest } from './manifest/manifest-format.ts';
import { metaImage } from './metaimage/metaimage-format.ts';
import { nifti, niftiGzip } from './nifti/nifti-format.ts';
import { nrrd } from './nrrd/nrrd-format.ts';
import { hdf5, netcdf3, nexrad } from './radar/radar-formats.ts';

/**
 * Every format that can be read, in any order. A new format has its own file, which says how to recognize its files and
 * loads its reader when it is needed. format.ts explains the terms.
 */
export const allFormats: readonly Format[] = [
  nifti,
  niftiGzip,
  nrrd,
  metaImage,
  png,
  jpeg,
  webp,
  manifest,
  hdf5,
  netcdf3,
  nexrad,
];
