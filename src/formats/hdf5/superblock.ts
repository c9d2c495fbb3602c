import { VolumeViewError } from '../../core/errors.ts';
import type { Budget } from '../base/budget.ts';
import { findHdf5 } from '../base/hdf-signature.ts';
import { corruptHdf5, Cursor, Hdf5Bytes, noAddress, unsupportedHdf5 } from './hdf5-bytes.ts';

/**
 * Reads the superblock, versions 0 to 3.
 * @returns the file, ready to be read, and the address of the root group's header
 * @throws {VolumeViewError} `format/unknown`, `format/corrupt`, `format/unsupported`
 * Source: HDF5 File Format Specification 3.0, II.A
 */
export function openBytes(bytes: Uint8Array<ArrayBuffer>, budget?: Budget): { file: Hdf5Bytes; root: number } {
  const start = findHdf5(bytes);
  if (start < 0)
    throw new VolumeViewError('format/unknown', 'the file has no HDF5 signature; expected an HDF5 or NetCDF-4 file');
  const file = new Hdf5Bytes(bytes, budget);
  const cursor = new Cursor(file, start + 8);
  const version = cursor.expectVersion('a superblock', 0, 1, 2, 3);
  if (version < 2) cursor.skip(4);
  file.addressBytes = readSize(cursor);
  file.lengthBytes = readSize(cursor);
  cursor.skip([9, 13, 1, 1][version]);
  file.base = cursor.address();
  cursor.address();
  const end = cursor.address();
  // In old files the driver's block follows, and then the root's position among the names.
  cursor.skip(version < 2 ? 2 * file.addressBytes : 0);
  const root = cursor.address();
  if (file.base === noAddress || end === noAddress) throw corruptHdf5('does not say where it begins and ends');
  if (end > bytes.length) {
    throw new VolumeViewError(
      'format/corrupt',
      `the HDF5 file ends early: got ${bytes.length} bytes; its header asks for ${end}; fetch it again`,
    );
  }
  return { file, root };
}

function readSize(cursor: Cursor): number {
  const size = cursor.u8();
  if (![2, 4, 8].includes(size)) throw unsupportedHdf5(`addresses or lengths of ${size} bytes; expected 2, 4 or 8`);
  return size;
}
