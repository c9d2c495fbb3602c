import type { Format } from './base/format.ts';
import { jpeg, png, webp } from './images/image-formats.ts';
import { manifest } from './manifest/manifest-format.ts';
import { metaImage } from './metaimage/metaimage-format.ts';
import { nifti, niftiGzip } from './nifti/nifti-format.ts';
import { nrrd } from './nrrd/nrrd-format.ts';
import { hdf5, netcdf3, nexrad } from './radar/radar-formats.ts';

/**
 * Every format that can be read, in any order. A new one comes from a file of its own, which says how its files are
 * recognised and loads its reader when one is there. format.ts has the words for that.
 */
export const allFormats: readonly Format[] = [nifti, niftiGzip, nrrd, metaImage, png, jpeg, webp, manifest, hdf5, netcdf3, nexrad];
