import type { Grammar } from './fuzz-case.ts';
import { attributes } from './grammars/attributes.ts';
import { dicom, dicomFolder } from './grammars/dicom.ts';
import { dicomWeb } from './grammars/dicomweb.ts';
import { metaImage, nrrd } from './grammars/grid-files.ts';
import { hdf5, minc } from './grammars/hdf5.ts';
import { jpeg, webp } from './grammars/image-headers.ts';
import { level3 } from './grammars/level3.ts';
import { dicomTimes, mixture, serverList } from './grammars/many-files.ts';
import { manifest } from './grammars/manifest.ts';
import { netcdf3 } from './grammars/netcdf3.ts';
import { nexrad } from './grammars/nexrad.ts';
import { nifti } from './grammars/nifti.ts';
import { png } from './grammars/png.ts';
import { rainbow } from './grammars/rainbow.ts';
import { afni, analyze, mgh, mrc, npy, vti } from './grammars/rare-formats.ts';
import { tiff } from './grammars/tiff.ts';
import { video } from './grammars/video.ts';
import { bricks, zarr } from './grammars/zarr.ts';
import { zstd } from './grammars/zstd.ts';

/** All that can be fuzzed, by the names that `npm run fuzz` takes. */
export const grammars: Readonly<Record<string, Grammar>> = {
  hdf5,
  netcdf3,
  nexrad,
  level3,
  rainbow,
  png,
  jpeg,
  webp,
  nifti,
  nrrd,
  metaimage: metaImage,
  mgh,
  mrc,
  analyze,
  npy,
  tiff,
  vti,
  afni,
  minc,
  zstd,
  zarr,
  bricks,
  dicom,
  'dicom-folder': dicomFolder,
  'dicom-times': dicomTimes,
  dicomweb: dicomWeb,
  'server-list': serverList,
  mixture,
  manifest,
  video,
  attributes,
};
