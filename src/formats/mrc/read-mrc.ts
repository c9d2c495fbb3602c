import { cartesianGrid } from '../../volume/grid.ts';
import { invertAffine } from '../../volume/matrix.ts';
import type { Matrix4, Vector3 } from '../../volume/matrix.ts';
import { checkLengths } from '../base/check-lengths.ts';
import { corruptFile, unsupportedFile } from '../base/file-problem.ts';
import type { FormatReader } from '../base/format.ts';
import { millimetresOf } from '../base/length-units.ts';
import { float16 } from '../base/half-floats.ts';
import { numberTypes } from '../base/number-types.ts';
import type { NumberType } from '../base/number-types.ts';
import { readVolumes } from '../series/read-volumes.ts';
import type { VolumesBehindHeader } from '../series/read-volumes.ts';

/** Bytes of the header. An extended header, whose length it says, and the samples follow it. */
const mrcHeaderBytes = 1024;

const what = 'the MRC header';

/** Source: MRC2014, word 4 */
const types = new Map<number, NumberType>([
  [0, numberTypes.int8],
  [1, numberTypes.int16],
  [2, numberTypes.float32],
  [6, numberTypes.uint16],
  [12, float16],
]);

/** What an error says about other modes. Sources: MRC2014, word 4; IMOD, "The MRC file format used by IMOD" */
const refused = new Map([
  [3, 'a Fourier transform, complex numbers'],
  [4, 'a Fourier transform, complex numbers'],
  [16, 'colours (RGB)'],
  [101, 'numbers of 4 bits'],
]);

/**
 * Reads a map of electron microscopy or crystallography, packed with gzip or not; the volumes of a stack are scans.
 * The axes are x, y and z of the map, whatever their order in the file, and lengths are mm.
 * Sources: Cheng and others 2015, MRC2014: extensions to the MRC format header; IMOD, "The MRC file format used by IMOD"
 */
export const readMrc: FormatReader = (input, settings, context) =>
  readVolumes({ name: 'MRC', headerBytes: mrcHeaderBytes, readHeader }, input, settings, context);

function readHeader(bytes: Uint8Array): VolumesBehindHeader {
  if (bytes.length < mrcHeaderBytes)
    throw corruptFile(what, `got ${bytes.length} bytes; expected ${mrcHeaderBytes}: the file is cut short`);
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const littleEndian = isLittleEndian(view);
  const int = (word: number): number => view.getInt32(4 * word - 4, littleEndian);
  const [columns, rows, sections, mode] = [1, 2, 3, 4].map(int);
  checkLengths(what, 'dimensions', [columns, rows, sections]);
  const extended = int(24);
  if (extended < 0) throw corruptFile(what, `got an extended header of ${extended} bytes; expected 0 or more`);
  const volumes = countVolumes(sections, int(10), int(23));
  const dimensions: Vector3 = [columns, rows, sections / volumes];
  return {
    grid: cartesianGrid(
      dimensions,
      readAffine(int, (word) => view.getFloat32(4 * word - 4, littleEndian)),
    ),
    type: readType(mode, isUnsigned(int)),
    littleEndian,
    count: volumes,
    offset: mrcHeaderBytes + extended,
  };
}

/** By the machine stamp (word 54). Some programs write a wrong one, and then the mode or the dimensions make no sense. */
function isLittleEndian(view: DataView): boolean {
  const isSound = (littleEndian: boolean): boolean => {
    const [columns, rows, sections, mode] = [0, 4, 8, 12].map((at) => view.getInt32(at, littleEndian));
    return (types.has(mode) || refused.has(mode)) && [columns, rows, sections].every((n) => n > 0 && n < 2 ** 24);
  };
  const stamped = view.getUint8(212) !== 0x11;
  return isSound(stamped) || !isSound(!stamped) ? stamped : !stamped;
}

/** A stack of volumes has a space group of 401 to 630, and in `mz` the sections of one of them. Source: MRC2014, words 10 and 23 */
function countVolumes(sections: number, mz: number, spaceGroup: number): number {
  const isStack = spaceGroup > 400 && spaceGroup < 631 && mz > 0 && mz < sections && sections % mz === 0;
  return isStack ? sections / mz : 1;
}

/** Bytes are signed, but those of IMOD only with a flag. Source: IMOD, imodStamp at byte 152 and imodFlags after it */
function isUnsigned(int: (word: number) => number): boolean {
  return int(39) === 1_146_047_817 && (int(40) & 1) === 0;
}

function readType(mode: number, unsigned: boolean): NumberType {
  const type = mode === 0 && unsigned ? numberTypes.uint8 : types.get(mode);
  if (type) return type;
  const words = refused.get(mode);
  if (words)
    throw unsupportedFile(
      'the MRC file',
      `holds ${words}; expected a map of one number per voxel. Convert it, with IMOD: newstack -mode 2 in.mrc out.mrc`,
    );
  throw corruptFile(what, `got the mode ${mode}; expected one of ${[...types.keys()].join(', ')}`);
}

/**
 * Voxel index to world, mm. The header has the lengths and angles of a cell (in Angstrom), how many steps it has along each of its
 * axes, which of them columns, rows and sections run along, and where the first voxel is: in ORIGIN, or, where that is 0, as a number of
 * steps. Without any length a step is 1 Angstrom.
 */
function readAffine(int: (word: number) => number, float: (word: number) => number): Matrix4 {
  const order = [17, 18, 19].map(int);
  const axes = [1, 2, 3].every((axis) => order.includes(axis)) ? order : [1, 2, 3];
  const lengths = [11, 12, 13].map(float);
  const counts = [8, 9, 10].map(int);
  // Of one section there may be no length: its voxels are cubes.
  const known = lengths.map((length, i) => (length > 0 && counts[i] > 0 ? length / counts[i] : null));
  const cube = known.find((step) => step !== null) ?? 1;
  const steps = known.map((step) => step ?? cube);
  const directions = cellDirections([14, 15, 16].map(float));
  const angstrom = millimetresOf('\u00c5')!;
  // Of columns, rows and sections.
  const vectors = axes.map((axis) => directions[axis - 1].map((part) => part * steps[axis - 1] * angstrom));
  const starts = [5, 6, 7].map(int);
  const origin = [50, 51, 52].map(float);
  const isPlaced = origin.some((place) => place !== 0);
  const first = [0, 1, 2].map((row) =>
    isPlaced ? origin[row] * angstrom : vectors.reduce((sum, vector, i) => sum + starts[i] * vector[row], 0),
  );
  const affine = [...[0, 1, 2].flatMap((row) => [...vectors.map((vector) => vector[row]), first[row]]), 0, 0, 0, 1];
  if (affine.every(Number.isFinite) && invertAffine(affine)) return affine;
  throw corruptFile(
    what,
    `got a cell of ${lengths.join(' x ')} with ${counts.join(' x ')} steps, and the first voxel at ${origin.join(', ')}; expected finite lengths, and axes that do not lie in one plane`,
  );
}

/**
 * Unit vectors of the axes of a cell: a along x, b in the plane of x and y. Where all angles are 0, as programs for microscopes may write
 * them, they are right angles.
 * @param angles - alpha (between b and c), beta (a and c), gamma (a and b), degrees
 * Source: International Tables for Crystallography B, 3.3.1: the orthogonal frame of the Protein Data Bank
 */
function cellDirections(angles: readonly number[]): readonly Vector3[] {
  const known = angles.every((angle) => angle === 0) ? [90, 90, 90] : angles;
  // Of a right angle the cosine is 0, and not 6e-17.
  const [alpha, beta, gamma] = known.map((angle) => (angle === 90 ? 0 : Math.cos((angle / 180) * Math.PI)));
  const sine = Math.sqrt(1 - gamma * gamma);
  const y = (alpha - beta * gamma) / sine;
  return [
    [1, 0, 0],
    [gamma, sine, 0],
    [beta, y, Math.sqrt(1 - beta * beta - y * y)],
  ];
}
