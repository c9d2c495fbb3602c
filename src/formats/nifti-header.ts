import { VolumeViewError } from '../errors.ts';

/**
 * The fields of a NIfTI-1 or -2 header that a picture depends on, as they stand in the file.
 * Sources: nifti1.h and nifti2.h, https://nifti.nimh.nih.gov.
 *
 * Why this is not nifti-reader-js 0.8: it takes the qform over the sform where its code is greater and then loses the
 * sform, ignores the qform in NIfTI-2, has no centred affine for files with neither, and throws TypeError and
 * RangeError on damaged extensions. nibabel, the reference here, does none of that.
 */
export interface NiftiHeader {
  readonly version: 1 | 2;
  readonly littleEndian: boolean;
  /** dim[0..7]: the number of axes, then the length of each. */
  readonly dim: readonly number[];
  readonly datatype: number;
  /** pixdim[0..7]: qfac, then the spacing along each axis. */
  readonly pixdim: readonly number[];
  /** Where the data begin, bytes. */
  readonly offset: number;
  readonly slope: number;
  readonly intercept: number;
  /** The range that the file wants to be shown in; both 0 where it does not say. */
  readonly calMin: number;
  readonly calMax: number;
  readonly units: number;
  readonly qformCode: number;
  readonly sformCode: number;
  /** quatern_b, c, d. */
  readonly quaternion: readonly [number, number, number];
  readonly qoffset: readonly [number, number, number];
  /** srow_x, y, z: twelve numbers. */
  readonly srow: readonly number[];
}

/** Bytes that hold either header. */
export const niftiHeaderBytes = 540;
const sizes = { 1: 348, 2: 540 } as const;

/**
 * Which NIfTI (or Analyze) header bytes begin with: its first number is its own length.
 * @returns null where it is none
 */
export function detectNifti(bytes: Uint8Array): { version: 1 | 2; littleEndian: boolean; magic: string } | null {
  if (bytes.length < 348) return null;
  const view = viewOf(bytes);
  for (const version of [1, 2] as const) {
    for (const littleEndian of [true, false]) {
      if (view.getInt32(0, littleEndian) !== sizes[version]) continue;
      const [from, to] = version === 1 ? [344, 348] : [4, 12];
      return { version, littleEndian, magic: String.fromCharCode(...bytes.subarray(from, to)) };
    }
  }
  return null;
}

/**
 * Read a header from the first bytes of a file.
 * @throws {VolumeViewError} `format/unknown`, `format/unsupported` (.hdr/.img pairs, Analyze 7.5), `format/corrupt`
 */
export function parseNiftiHeader(bytes: Uint8Array): NiftiHeader {
  const found = detectNifti(bytes);
  if (!found) throw new VolumeViewError('format/unknown', 'the data do not begin with a NIfTI header');
  const { version, littleEndian, magic } = found;
  checkMagic(version, magic);
  if (bytes.length < sizes[version]) {
    throw new VolumeViewError('format/corrupt', `the NIfTI-${version} header got ${bytes.length} bytes; expected ${sizes[version]}`);
  }
  const header = version === 1 ? readVersion1(viewOf(bytes), littleEndian) : readVersion2(viewOf(bytes), littleEndian);
  // The header is followed by four bytes that say whether extensions follow; some writers leave the offset 0.
  const least = sizes[version] + 4;
  return { ...header, offset: header.offset >= least ? Math.trunc(header.offset) : least };
}

function checkMagic(version: 1 | 2, magic: string): void {
  const [single, pair] = version === 1 ? ['n+1', 'ni1'] : ['n+2', 'ni2'];
  if (magic.startsWith(pair)) {
    throw new VolumeViewError(
      'format/unsupported',
      `this is the header of a NIfTI-${version} pair, whose data lie in an .img file; join the two into one .nii file`,
    );
  }
  if (!magic.startsWith(single)) {
    throw version === 1
      ? new VolumeViewError('format/unsupported', 'this is an Analyze 7.5 header, or a NIfTI one without its mark; convert the file to NIfTI (.nii)')
      : new VolumeViewError('format/corrupt', 'the NIfTI-2 header lacks its mark "n+2"');
  }
  if (version === 2 && magic.slice(3) !== '\0\r\n\x1a\n') {
    throw new VolumeViewError('format/corrupt', 'the NIfTI-2 mark has other line ends: the file was transferred as text; transfer it as binary data');
  }
}

function readVersion1(view: DataView, little: boolean): NiftiHeader {
  const short = (at: number): number => view.getInt16(at, little);
  const float = (at: number): number => view.getFloat32(at, little);
  return {
    version: 1,
    littleEndian: little,
    dim: list(8, (i) => short(40 + 2 * i)),
    datatype: short(70),
    pixdim: list(8, (i) => float(76 + 4 * i)),
    offset: float(108),
    slope: float(112),
    intercept: float(116),
    calMax: float(124),
    calMin: float(128),
    units: view.getUint8(123),
    qformCode: short(252),
    sformCode: short(254),
    quaternion: [float(256), float(260), float(264)],
    qoffset: [float(268), float(272), float(276)],
    srow: list(12, (i) => float(280 + 4 * i)),
  };
}

function readVersion2(view: DataView, little: boolean): NiftiHeader {
  const long = (at: number): number => Number(view.getBigInt64(at, little));
  const double = (at: number): number => view.getFloat64(at, little);
  return {
    version: 2,
    littleEndian: little,
    dim: list(8, (i) => long(16 + 8 * i)),
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

function list(length: number, read: (i: number) => number): number[] {
  return Array.from({ length }, (_, i) => read(i));
}

function viewOf(bytes: Uint8Array): DataView {
  return new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
}
