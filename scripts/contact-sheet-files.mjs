import { existsSync, readdirSync } from 'node:fs';
import { basename } from 'node:path';

/** @typedef {{ src: string, name: string, attributes?: string, mayBeShown: boolean }} Subject - `src` is relative to the data's folder */

/** Names of the files in formats that we read. DICOM is not one of them. */
const readable = /(\.(nii|nii\.gz|nrrd|mhd|hdf|h5|nc)|_V06|\d{8}_?\d{6}\.gz|aorta\d+\.png)$/;

/** Folders whose licence allows pictures of their data in the docs; see the README of the data. */
const shown = ['mni152_nilearn', 'nibabel_4d', 'ch2_mricron', 'cfradial_pyart'];

/** An image does not describe its contents: for the aorta, the attributes are those on the page of the paper. */
const aorta = {
  'aorta1024.png': 'mosaic="10x10" slices="96" spacing="3.2 3.2 -3" reference-length="5.4"',
  'aorta4096.png': 'mosaic="10x10" slices="96" spacing="0.8 0.8 -3" reference-length="5.4"',
};

/**
 * Every readable file in a folder of real data, in an order that does not change. Where a file exists in many formats or times,
 * one of them is enough.
 * @param {string} folder
 * @returns {Subject[]}
 */
export function listSubjects(folder) {
  if (!existsSync(folder)) return [];
  const files = readdirSync(folder, { recursive: true })
    .map((path) => String(path).replaceAll('\\', '/'))
    .filter((path) => readable.test(path));
  const single = files.filter((path) => !/odim_behel_series\/\d{8}13(0[5-9]|[1-3])/.test(path));
  single.sort();
  return single.map((src) => ({
    src,
    name: shorten(basename(src)),
    attributes: Object.entries(aorta).find(([file]) => src.endsWith(file))?.[1],
    mayBeShown: shown.some((name) => src.includes(`/${name}/`)),
  }));
}

/** @param {string} name */
function shorten(name) {
  return name.replace(/^mni_icbm152_(\w+?)_tal_nlin_sym_09a_converted/, 'MNI152 $1');
}
