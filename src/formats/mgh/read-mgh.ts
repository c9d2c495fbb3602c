import { cartesianGrid } from '../../volume/grid.ts';
import { invertAffine } from '../../volume/matrix.ts';
import type { Matrix4, Vector3 } from '../../volume/matrix.ts';
import { checkLengths } from '../base/check-lengths.ts';
import { corruptFile, unsupportedFile } from '../base/file-problem.ts';
import type { FormatReader } from '../base/format.ts';
import { numberTypes } from '../base/number-types.ts';
import type { NumberType } from '../base/number-types.ts';
import { readVolumes } from '../series/read-volumes.ts';
import type { VolumesBehindHeader } from '../series/read-volumes.ts';
import { shortest, timeAt } from '../series/scan-times.ts';
import type { TimeSteps } from '../series/scan-times.ts';

/** Bytes of the header; the samples follow it. */
const mghHeaderBytes = 284;

/** Of the time between two frames, which follows the samples. */
const stepBytes = 4;

const what = 'the MGH header';

/** Source: FreeSurfer's mri.h, MRI_UCHAR and so on. */
const types = new Map<number, NumberType>([
  [0, numberTypes.uint8],
  [1, numberTypes.int32],
  [3, numberTypes.float32],
  [4, numberTypes.int16],
  [10, numberTypes.uint16],
]);

/** What an error says about the other types of mri.h. */
const refused = new Map([
  [2, 'long integers, which have another size on each machine'],
  [5, 'one bit per voxel'],
  [6, 'tensors'],
  [7, 'complex numbers'],
  [8, 'complex numbers'],
  [9, 'colours (RGB)'],
]);

/**
 * Reads an MGH file, packed with gzip (MGZ) or not; several frames are scans in time. Of what follows the samples only the time between
 * two frames is used.
 * Sources: FreeSurfer wiki, FsTutorial/MghFormat; nibabel 5.4, `freesurfer/mghformat.py`
 */
export const readMgh: FormatReader = (input, settings, context) =>
  readVolumes({ name: 'MGH', headerBytes: mghHeaderBytes, readHeader }, input, settings, context);

/** The time between two frames (TR) follows the samples, in milliseconds; null where it is absent or 0. Source: nibabel, `mghformat.py` */
async function readSteps(file: Blob, at: number): Promise<TimeSteps | null> {
  const bytes = await file.slice(at, at + stepBytes).arrayBuffer();
  const step = bytes.byteLength < stepBytes ? 0 : shortest(new DataView(bytes).getFloat32(0)) / 1e3;
  return step > 0 && Number.isFinite(step) ? { first: 0, step, unit: 's' } : null;
}

/** All numbers are big-endian, on every machine. */
function readHeader(bytes: Uint8Array): VolumesBehindHeader {
  if (bytes.length < mghHeaderBytes)
    throw corruptFile(what, `got ${bytes.length} bytes; expected ${mghHeaderBytes}: the file is cut short`);
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const [nx, ny, nz, frames, code] = [4, 8, 12, 16, 20].map((at) => view.getInt32(at));
  const dimensions: Vector3 = [nx, ny, nz];
  checkLengths(what, 'dimensions', dimensions);
  checkLengths(what, 'frames', [frames]);
  const anatomical = view.getInt16(28) > 0;
  return {
    grid: cartesianGrid(
      dimensions,
      readAffine((at) => view.getFloat32(at), dimensions, anatomical),
    ),
    anatomical,
    type: readType(code),
    littleEndian: false,
    count: frames,
    offset: mghHeaderBytes,
    tail: stepBytes,
    readTimes: async (file, end) => {
      const steps = await readSteps(file, end);
      return (index) => timeAt(index, steps);
    },
  };
}

function readType(code: number): NumberType {
  const type = types.get(code);
  if (type) return type;
  const words = refused.get(code);
  if (words)
    throw unsupportedFile(
      'the MGH file',
      `holds ${words}; expected one number per voxel. Convert it: mri_convert --out_data_type float in.mgz out.mgz`,
    );
  throw corruptFile(what, `got the type ${code}; expected one of ${[...types.keys()].join(', ')}`);
}

/**
 * Voxel index to world (RAS, mm). The header has the spacing, the direction of each axis, and the world position of the
 * volume's centre (c_ras), which is the index n / 2 along each axis, and not (n - 1) / 2. Without good_ras_flag
 * FreeSurfer takes a coronal scan with voxels of 1 mm, its centre at the origin.
 */
function readAffine(float: (at: number) => number, dimensions: Vector3, isPlaced: boolean): Matrix4 {
  const numbers = Array.from({ length: 15 }, (_, i) => float(30 + 4 * i));
  const [dx, dy, dz, xr, xa, xs, yr, ya, ys, zr, za, zs, cr, ca, cs] = isPlaced
    ? numbers
    : [1, 1, 1, -1, 0, 0, 0, 0, -1, 0, 1, 0, 0, 0, 0];
  const rows = [
    [xr * dx, yr * dy, zr * dz, cr],
    [xa * dx, ya * dy, za * dz, ca],
    [xs * dx, ys * dy, zs * dz, cs],
  ];
  const [nx, ny, nz] = dimensions;
  const affine = [...rows.flatMap(([x, y, z, c]) => [x, y, z, c - (x * nx + y * ny + z * nz) / 2]), 0, 0, 0, 1];
  if (affine.every(Number.isFinite) && invertAffine(affine)) return affine;
  throw corruptFile(
    what,
    `got the spacing ${dx} x ${dy} x ${dz} and the axes (${xr}, ${xa}, ${xs}) (${yr}, ${ya}, ${ys}) (${zr}, ${za}, ${zs}); expected finite lengths above 0, and directions that do not lie in one plane`,
  );
}
