import { invertAffine, multiply, scaleAndTranslate } from '../../volume/matrix.ts';
import type { Matrix4, Vector3 } from '../../volume/matrix.ts';
import type { NiftiHeader } from './nifti-header.ts';

/** Where voxels lie. */
export interface VoxelPlace {
  readonly indexToWorld: Matrix4;
  /** Whether the header says that the world is a patient's; the spacing alone does not say it. */
  readonly anatomical: boolean;
}

/**
 * Voxel index to world (RAS, mm), row-major, chosen as nibabel does: the sform if its code is one that nifti1.h
 * defines, else the qform, else the spacing alone with x flipped, centred on the volume. A matrix that is singular or
 * not finite is skipped; nibabel leaves that to its caller.
 * Source: nibabel 5.4 `Nifti1Header.get_best_affine` and `_chk_xform_code`, which treats other codes as 0; the formulas
 * are methods 1 to 3 of nifti1.h.
 */
export function resolveAffine(header: NiftiHeader, dimensions: Vector3): VoxelPlace {
  const candidates = [
    isKnown(header.sformCode) ? readSform(header) : null,
    isKnown(header.qformCode) ? readQform(header) : null,
    readSpacing(header, dimensions),
  ];
  const chosen = candidates.findIndex((m) => m?.every(Number.isFinite) && invertAffine(m) !== null);
  const affine = candidates[chosen];
  const mm = millimetresPer(header.units);
  const inUnits = affine ?? scaleAndTranslate([-1, 1, 1], [0, 0, 0]);
  return {
    indexToWorld: mm === 1 ? inUnits : multiply(scaleAndTranslate([mm, mm, mm], [0, 0, 0]), inUnits),
    anatomical: chosen === 0 || chosen === 1,
  };
}

/** 1 scanner, 2 aligned, 3 Talairach, 4 MNI, 5 another template. */
const isKnown = (code: number): boolean => code >= 1 && code <= 5;

/** Bits 0 to 2 of xyzt_units: 1 metre, 2 millimetre, 3 micrometre, 0 unknown, which means millimetre in practice. */
function millimetresPer(units: number): number {
  const code = units & 7;
  return code === 1 ? 1000 : code === 3 ? 0.001 : 1;
}

function readSform(header: NiftiHeader): Matrix4 {
  return [...header.srow, 0, 0, 0, 1];
}

function readQform(header: NiftiHeader): Matrix4 {
  const [b, c, d] = header.quaternion;
  // Stored numbers are rounded, so near 0 the square of a is noise: nibabel's threshold, in the precision of the file.
  const square = 1 - (b * b + c * c + d * d);
  const threshold = header.version === 1 ? 3 * 2 ** -23 : 3 * 2 ** -52;
  const a = square < threshold ? 0 : Math.sqrt(square);
  const [x, y, z] = readZooms(header);
  const qfac = header.pixdim[0] === -1 ? -1 : 1;
  const rotation = rotationOf(a, b, c, d);
  return multiply(
    [...withOffset(rotation, header.qoffset), 0, 0, 0, 1],
    scaleAndTranslate([x, y, qfac * z], [0, 0, 0]),
  );
}

/** Rotation matrix, nine numbers, of a quaternion that need not have unit length. */
function rotationOf(a: number, b: number, c: number, d: number): number[] {
  const s = 2 / (a * a + b * b + c * c + d * d);
  return [
    1 - s * (c * c + d * d),
    s * (b * c - a * d),
    s * (b * d + a * c),
    s * (b * c + a * d),
    1 - s * (b * b + d * d),
    s * (c * d - a * b),
    s * (b * d - a * c),
    s * (c * d + a * b),
    1 - s * (b * b + c * c),
  ];
}

function withOffset(r: readonly number[], offset: Vector3): number[] {
  return [r[0], r[1], r[2], offset[0], r[3], r[4], r[5], offset[1], r[6], r[7], r[8], offset[2]];
}

function readSpacing(header: NiftiHeader, dimensions: Vector3): Matrix4 {
  const [x, y, z] = readZooms(header);
  const signed: Vector3 = [-x, y, z];
  const offset = signed.map((s, axis) => (-s * (dimensions[axis] - 1)) / 2);
  return scaleAndTranslate(signed, offset as unknown as Vector3);
}

/** Spacings, positive; 1 if the header has none. */
function readZooms(header: NiftiHeader): Vector3 {
  return [1, 2, 3].map((axis) => {
    const zoom = Math.abs(header.pixdim[axis]);
    return zoom > 0 && Number.isFinite(zoom) ? zoom : 1;
  }) as unknown as Vector3;
}
