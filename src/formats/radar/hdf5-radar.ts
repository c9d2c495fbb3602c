import { VolumeViewError } from '../../core/errors.ts';
import { Budget } from '../base/budget.ts';
import { openHdf5 } from '../hdf5/hdf5.ts';
import { isCfradial1, readCfradial1Tree } from './cfradial1.ts';
import { isCfradial2, readCfradial2Tree } from './cfradial2.ts';
import { isOdim, readOdimTree } from './odim.ts';
import type { RadarFile } from './radar-file.ts';

/**
 * Reads a radar file that is HDF5: ODIM_H5, or CfRadial 1 or 2 in NetCDF-4. The file has to be opened to find out
 * which.
 * @throws {VolumeViewError} as the readers do; `format/unsupported` if it is none of them
 */
export async function readHdf5Radar(
  bytes: Uint8Array<ArrayBuffer>,
  budget = Budget.ofFile(bytes.length),
): Promise<RadarFile> {
  const root = openHdf5(bytes, budget);
  if (isOdim(root)) return readOdimTree(root, budget);
  if (isCfradial1(root)) return readCfradial1Tree(root, budget);
  if (isCfradial2(root)) return readCfradial2Tree(root, budget);
  // Source: xradar 0.12, `gamic.py`; ODIM_H5 counts its groups from 1.
  if (root.names.includes('scan0'))
    throw new VolumeViewError(
      'format/unsupported',
      'the HDF5 file is a radar scan as GAMIC writes it, which volume-view does not read; convert it to CfRadial, with xradar',
    );
  const held = root.names
    .slice(0, 6)
    .map((name) => name.slice(0, 40))
    .join(', ');
  throw new VolumeViewError(
    'format/unsupported',
    `the HDF5 file is no radar scan that is known here: it holds ${held || 'nothing'}; expected ODIM_H5, CfRadial 1 or CfRadial 2. Other HDF5 files (Imaris .ims, ilastik .h5, MATLAB .mat, models .nc) are not read: convert a volume to OME-Zarr or TIFF, as bioformats2raw, Fiji and tifffile write them`,
  );
}
