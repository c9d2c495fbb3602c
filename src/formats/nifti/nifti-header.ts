import type { Vector3 } from '../../volume/matrix.ts';

/**
 * The fields of a NIfTI-1 or -2 header that a picture depends on, as they stand in the file.
 * Sources: nifti1.h and nifti2.h, https://nifti.nimh.nih.gov.
 * Why not nifti-reader-js 0.8: it prefers the qform to the sform if its code is greater and then loses the sform,
 * ignores the qform in NIfTI-2, has no centred affine for files with neither, and throws TypeError and RangeError on
 * damaged extensions. nibabel, the reference here, does none of that.
 */
export interface NiftiHeader {
  readonly version: 1 | 2;
  readonly littleEndian: boolean;
  /** dim[0..7]: the number of axes, then the length of each. */
  readonly dim: readonly number[];
  /** What the values are: 1002 for labels. */
  readonly intent: number;
  readonly datatype: number;
  /** pixdim[0..7]: qfac, then the spacing along each axis. */
  readonly pixdim: readonly number[];
  /** Where the data begin, bytes. */
  readonly offset: number;
  readonly slope: number;
  readonly intercept: number;
  /** The range in which the file should be shown; both 0 if it does not say. */
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
export const headerSizes = { 1: 348, 2: 540 } as const;

/** The kind of header that a file begins with, from its first number and its magic string. */
export interface NiftiStart {
  readonly version: 1 | 2;
  readonly littleEndian: boolean;
  readonly magic: string;
}

/**
 * Which NIfTI (or Analyze) header a file begins with: its first number is its own length.
 * @returns null if it is none of them
 */
export function detectNifti(bytes: Uint8Array): NiftiStart | null {
  if (bytes.length < 348) return null;
  const view = viewOf(bytes);
  for (const version of [1, 2] as const) {
    for (const littleEndian of [true, false]) {
      if (view.getInt32(0, littleEndian) !== headerSizes[version]) continue;
      const [from, to] = version === 1 ? [344, 348] : [4, 12];
      return { version, littleEndian, magic: String.fromCharCode(...bytes.subarray(from, to)) };
    }
  }
  return null;
}

/**
 * Whether a file of version 1 in little-endian begins here that has several volumes, of one of the usual types. Other files are fetched
 * as a whole, which is right too.
 */
export function startsSeries(bytes: Uint8Array): boolean {
  return bytes[0] === 92 && bytes[345] === 43 && bytes[40] > 3 && bytes[71] < 5 && bytes[48] + bytes[49] > 1;
}

/** Reads a header of version 1. */
export function readVersion1(bytes: Uint8Array, little: boolean): NiftiHeader {
  const view = viewOf(bytes);
  const short = (at: number): number => view.getInt16(at, little);
  const float = (at: number): number => view.getFloat32(at, little);
  return {
    version: 1,
    littleEndian: little,
    dim: list(8, (i) => short(40 + 2 * i)),
    intent: short(68),
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

export function list(length: number, read: (i: number) => number): number[] {
  return Array.from({ length }, (_, i) => read(i));
}

export function viewOf(bytes: Uint8Array): DataView {
  return new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
}

/**
 * Lengths along i, j, k; missing axes have length 1, and so have those of 0 or less, as niftilib takes them (FSL, ITK). The fourth axis,
 * time, makes a series, and so do those from the sixth on; along the fifth lie the numbers of a voxel (nifti1.h).
 */
export function readDimensions({ dim }: NiftiHeader): { dimensions: Vector3; volumes: number; numbers: number } {
  const [nx, ny = 1, nz = 1, time = 1, numbers = 1, ...series] = dim.slice(1, 1 + dim[0]);
  return {
    dimensions: [nx, Math.max(1, ny), Math.max(1, nz)],
    volumes: [time, ...series].reduce((product, n) => product * Math.max(1, n), 1),
    numbers: Math.max(1, numbers),
  };
}

/** The range of values that the file wants to be shown, if it says one. */
export function readWindow({ calMin, calMax }: NiftiHeader): { window?: [number, number] } {
  return calMax > calMin && Number.isFinite(calMax - calMin) ? { window: [calMin, calMax] } : {};
}
