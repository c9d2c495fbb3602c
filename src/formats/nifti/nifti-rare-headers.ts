import { VolumeViewError } from '../../core/errors.ts';
import { loadReader } from '../base/load-reader.ts';
import { headerSizes, list, viewOf } from './nifti-header.ts';
import type { NiftiHeader, NiftiStart } from './nifti-header.ts';

// Rare headers: version 2, and those that are refused.

/**
 * @param found - the kind of header; null if it is none
 * @throws {VolumeViewError} `format/unknown`, `format/unsupported`, `format/corrupt`
 */
export async function readRareHeader(bytes: Uint8Array, found: NiftiStart | null): Promise<NiftiHeader> {
  if (!found) throw (await loadReader(() => import('#rare/formats/nifti/refuse-packed.ts'))).refusePacked(bytes);
  const { version, littleEndian, magic } = found;
  checkMark(magic);
  if (bytes.length < headerSizes[version]) {
    throw new VolumeViewError(
      'format/corrupt',
      `the NIfTI-${version} header got ${bytes.length} bytes; expected ${headerSizes[version]}`,
    );
  }
  return readVersion2(viewOf(bytes), littleEndian);
}

function checkMark(magic: string): void {
  if (!magic.startsWith('n+2')) throw new VolumeViewError('format/corrupt', 'the NIfTI-2 header lacks its mark "n+2"');
  if (magic.slice(3) !== '\0\r\n\x1a\n') {
    throw new VolumeViewError(
      'format/corrupt',
      'the NIfTI-2 mark has other line ends: the file was transferred as text; transfer it as binary data',
    );
  }
}

/** Source: CIFTI-2: numbers of points of a surface and of voxels, one after another, in the form of NIfTI-2 */
const isCifti = (intent: number): boolean => intent >= 3000 && intent < 3100;

/** Reads a header of version 2. @throws {VolumeViewError} `format/unsupported` */
export function readVersion2(view: DataView, little: boolean): NiftiHeader {
  const long = (at: number): number => Number(view.getBigInt64(at, little));
  const double = (at: number): number => view.getFloat64(at, little);
  const intent = view.getInt32(504, little);
  if (isCifti(intent))
    throw new VolumeViewError(
      'format/unsupported',
      'the NIfTI-2 file is CIFTI: a list of numbers, most of them of points of a surface, and no volume; take the voxels out of it: wb_command -cifti-separate in.nii COLUMN -volume-all out.nii.gz',
    );
  return {
    version: 2,
    littleEndian: little,
    dim: list(8, (i) => long(16 + 8 * i)),
    intent,
    datatype: view.getInt16(12, little),
    pixdim: list(8, (i) => double(104 + 8 * i)),
    offset: long(168),
    slope: double(176),
    intercept: double(184),
    calMax: double(192),
    calMin: double(200),
    units: view.getInt32(500, little),
    qformCode: view.getInt32(344, little),
    sformCode: view.getInt32(348, little),
    quaternion: [double(352), double(360), double(368)],
    qoffset: [double(376), double(384), double(392)],
    srow: list(12, (i) => double(400 + 8 * i)),
  };
}
