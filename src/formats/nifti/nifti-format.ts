import type { VolumeFormat } from '../base/format.ts';
import { detectNifti } from './nifti-header.ts';

const words = 'NIfTI (.nii, .nii.gz)';
const load: VolumeFormat['load'] = async () => (await import('./nifti.ts')).readNiftiFile;

export const nifti: VolumeFormat = {
  name: 'NIfTI',
  words,
  endings: ['nii'],
  beginning: 'a NIfTI header',
  // Others are in two files: the mark "ni1", or none.
  matches: ({ bytes, unpacked }) => detectNifti(unpacked ?? bytes)?.magic[1] === '+',
  load,
};

/** Any gzip file that no other format claims: the reader explains what is wrong with a damaged one. */
export const niftiGzip: VolumeFormat = {
  name: 'NIfTI, gzip',
  words,
  endings: ['gz'],
  beginning: 'a gzip header',
  matches: ({ unpacked }) => unpacked !== null,
  last: true,
  load,
};
