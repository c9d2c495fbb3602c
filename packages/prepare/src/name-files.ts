import { basename } from 'node:path';

const word = (text: string): string => text.replace(/[^\p{L}\p{N}._-]+/gu, '_').replace(/^\.+/, '_').slice(0, 100);

/**
 * The name, without an ending, of the files that are made of one: the file's own name, and what is shown of it. The file itself
 * says what that is, so nothing in it may lead to another folder or to a hidden file.
 * @param path - of the file that is read
 * @param quantity - of a radar file
 */
export function nameFiles(path: string, quantity?: string): string {
  const own = word(basename(path).replace(/(\.(gz|hdf5?|h5|nc4?|nii|nrrd|mha)){1,9}$/i, ''));
  return quantity === undefined ? own : `${own}-${word(quantity)}`;
}
