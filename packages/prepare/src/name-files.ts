import { basename } from 'node:path';

const word = (text: string): string =>
  text
    .replace(/[^\p{L}\p{N}._-]+/gu, '_')
    .replace(/^\.+/, '_')
    .slice(0, 100);

/**
 * The name, without an extension, of the files that are made from one file: the name of that file, and the quantity that is shown. Both
 * come from the file, so no character in them may lead to another folder or to a hidden file.
 * @param path - of the file that is read
 * @param quantity - of a radar file
 */
export function nameFiles(path: string, quantity?: string): string {
  const own = word(basename(path).replace(/(\.(gz|hdf5?|h5|nc4?|nii|nrrd|mha)){1,9}$/i, ''));
  return quantity === undefined ? own : `${own}-${word(quantity)}`;
}
