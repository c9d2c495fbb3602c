// Every format that can be read: a line each, in any order. A new one is one more line here, and the file that it names,
// which says how its files are recognised and loads its reader when one is there. format.ts has the words for that.
export { jpeg, png, webp } from './image-formats.ts';
export { manifest } from './manifest-format.ts';
export { metaImage } from './metaimage/metaimage-format.ts';
export { nifti, niftiGzip } from './nifti-format.ts';
export { nrrd } from './nrrd/nrrd-format.ts';
export { hdf5, netcdf3, nexrad } from './radar/radar-formats.ts';
