import { cartesianGrid } from '../../volume/grid.ts';
import { invertAffine } from '../../volume/matrix.ts';
import type { Matrix4, Vector3 } from '../../volume/matrix.ts';
import { countSampleBytes } from '../base/count-sample-bytes.ts';
import type { DecodeInput } from '../base/decoded-volume.ts';
import { checkLengths } from '../base/check-lengths.ts';
import { corruptFile, unsupportedFile } from '../base/file-problem.ts';
import type { FormatReader, ReadContext } from '../base/format.ts';
import { listLeft } from '../base/list-left.ts';
import { floats, numberTypes, viewAs } from '../base/number-types.ts';
import type { NumberType } from '../base/number-types.ts';
import { PieceReader, readSpan, yieldOnce } from '../base/piece-reader.ts';
import { placeVolume } from '../base/place-volume.ts';
import { storeSamples, wholeNumbersOf } from '../base/store-samples.ts';
import { gunzip, isGzip, maxDeflateRatio } from '../codecs/gunzip.ts';
import { areScans, openVolumes } from '../series/open-volumes.ts';
import { shortest, timeAt } from '../series/scan-times.ts';
import type { TimeSteps } from '../series/scan-times.ts';
import { fetchPartner } from '../grid-files/fetch-partner.ts';
import { numbersOf, readAfniHeader, what } from './afni-header.ts';
import type { AfniHeader } from './afni-header.ts';
import { isAfniHeader } from './is-afni-header.ts';

/** Source: AFNI, 3ddata.h and mrilib.h, MRI_byte and so on. */
const types = new Map<number, NumberType>([
  [0, numberTypes.uint8],
  [1, numberTypes.int16],
  [2, numberTypes.int32],
  [3, numberTypes.float32],
  [4, numberTypes.float64],
  [5, floats('complex64', 4, viewAs(Float32Array), true)],
]);

/**
 * Reads an AFNI volume; either of its two files may be given. Several sub-bricks of one type are scans, in time where the file says so.
 * Sources: AFNI, README.attributes; nibabel 5.4, `brikhead.py`
 */
export const readAfni: FormatReader = async (input, settings, context) => {
  const { header, samples: packed } = await findPair(input, context);
  const [nx, ny, nz] = numbersOf(header, 'DATASET_DIMENSIONS', 3) ?? [];
  const dimensions: Vector3 = [nx, ny, nz];
  checkLengths(what, 'DATASET_DIMENSIONS', dimensions);
  const volumes = numbersOf(header, 'DATASET_RANK', 2)?.[1] ?? 1;
  const type = readType(header);
  const slope = numbersOf(header, 'BRICK_FLOAT_FACS', 1)?.[0] || 1;
  const isPacked = isGzip(packed);
  const reader = new PieceReader(isPacked ? gunzip(packed) : yieldOnce(packed));
  const { onProgress, budget } = context;
  const littleEndian = header.get('BYTEORDER_STRING') !== 'MSB_FIRST';
  const atMost = isPacked ? packed.length * maxDeflateRatio : packed.length;
  const lost = type.complex ? 'the phase of complex numbers, whose magnitudes are shown' : null;
  const hasOneType = (numbersOf(header, 'BRICK_TYPES', 1) ?? [])
    .slice(0, volumes)
    .every((code, _, [first]) => code === first);
  if (hasOneType && areScans(volumes, type, settings, context)) {
    const [pieces, bytes] = [isPacked ? gunzip(packed) : yieldOnce(packed), countSampleBytes(what, dimensions, type)];
    const factors = numbersOf(header, 'BRICK_FLOAT_FACS', 1) ?? [];
    const steps = readSteps(header);
    return await openVolumes(
      { what: 'the AFNI file', pieces, atMost, offset: 0, bytes, count: volumes },
      () => ({
        info: { grid: cartesianGrid(dimensions, readAffine(header)), anatomical: true, unit: '', format: 'AFNI' },
        type,
        littleEndian,
        scaleOf: (index) => ({ slope: factors[index] || 1, intercept: 0 }),
        timeOf: (index) => timeAt(index, steps),
        left: [lost],
      }),
      settings,
      context,
    );
  }
  try {
    await reader.readStart(1);
    const bytes = await readSpan(
      reader,
      { atMost, onProgress, budget },
      { what: 'AFNI', offset: 0, bytes: countSampleBytes(what, dimensions, type), isPart: volumes > 1 },
    );
    const stored = storeSamples(bytes, type, littleEndian, {
      slope,
      intercept: 0,
      budget,
      chooseWhole: await wholeNumbersOf(type),
    });
    const factor = type.complex ? 1 : slope;
    return placeVolume(
      {
        grid: cartesianGrid(dimensions, readAffine(header)),
        anatomical: true,
        samples: stored.samples,
        slope: factor * stored.scale,
        intercept: factor * stored.offset,
        ...(factor === 1 ? { indexed: stored.indexed, rounded: stored.rounded } : {}),
        unkept: stored.unkept,
        unit: '',
        format: `AFNI${volumes > 1 ? `, volume 1 of ${volumes}` : ''}`,
        ...listLeft(volumes, lost),
      },
      settings,
    );
  } finally {
    await reader.stop();
  }
};

async function findPair(
  input: DecodeInput,
  context: ReadContext,
): Promise<{ header: AfniHeader; samples: Uint8Array<ArrayBuffer> }> {
  const isHeader = (bytes: Uint8Array): boolean =>
    isAfniHeader(new TextDecoder().decode(bytes.subarray(0, 512)).trimStart());
  if (isHeader(input.bytes)) {
    const { bytes } = await fetchPartner('an AFNI volume', input, ['head', 'brik'], context);
    return { header: readAfniHeader(input.bytes), samples: bytes };
  }
  const { bytes } = await fetchPartner('an AFNI volume', input, ['brik', 'head'], context);
  if (!isHeader(bytes))
    throw corruptFile(
      what,
      'does not begin with the type of an attribute; expected "type = string-attribute" or similar',
    );
  return { header: readAfniHeader(bytes), samples: input.bytes };
}

/** Units of AFNI's time axis, and how many of them are one of ours. Source: README.attributes, TAXIS_NUMS */
const timeUnits: ReadonlyMap<number, readonly [name: string, per: number]> = new Map([
  [77001, ['s', 1e3]],
  [77002, ['s', 1]],
  [77003, ['Hz', 1]],
]);

/** Times of the sub-bricks; null where they are none, as those of statistics. Source: README.attributes, TAXIS_FLOATS */
function readSteps(header: AfniHeader): TimeSteps | null {
  const [, , code] = numbersOf(header, 'TAXIS_NUMS', 3) ?? [];
  const [first, step] = numbersOf(header, 'TAXIS_FLOATS', 2) ?? [];
  const unit = timeUnits.get(code);
  if (!unit || !(step > 0)) return null;
  const [name, per] = unit;
  return { first: shortest(first) / per, step: shortest(step) / per, unit: name };
}

function readType(header: AfniHeader): NumberType {
  const [code = 1] = numbersOf(header, 'BRICK_TYPES', 1) ?? [];
  const type = types.get(code);
  if (type) return type;
  if (code === 6 || code === 7)
    throw unsupportedFile(
      'the AFNI file',
      'holds colours (RGB); expected one number per voxel. Convert it: 3dcalc -a in+orig -expr a -prefix out.nii.gz',
    );
  throw corruptFile(what, `got the type ${code} in BRICK_TYPES; expected one of ${[...types.keys()].join(', ')}`);
}

/**
 * Voxel index to world (RAS, mm). AFNI's world is LPS. Newer files have the matrix itself; older ones have the direction,
 * the first place and the step of each axis.
 */
function readAffine(header: AfniHeader): Matrix4 {
  const matrix = numbersOf(header, 'IJK_TO_DICOM_REAL', 12)?.slice(0, 12) ?? readOrientation(header);
  const affine = [...matrix.map((value, i) => (i < 8 ? 0 - value : value)), 0, 0, 0, 1];
  if (invertAffine(affine)) return affine;
  throw corruptFile(
    what,
    `got the axes ${matrix.join(' ')}; expected lengths other than 0, and directions that do not lie in one plane`,
  );
}

function readOrientation(header: AfniHeader): number[] {
  const [codes, origin, delta] = ['ORIENT_SPECIFIC', 'ORIGIN', 'DELTA'].map((name) => numbersOf(header, name, 3));
  // 0 and 1 lie along x, 2 and 3 along y, 4 and 5 along z; the step has the sign.
  const rows = codes?.slice(0, 3).map((code) => Math.floor(code / 2)) ?? [];
  if (!origin || !delta || ![0, 1, 2].every((row) => rows.includes(row)))
    throw corruptFile(
      what,
      'lacks the place of its voxels; expected IJK_TO_DICOM_REAL, or ORIENT_SPECIFIC, ORIGIN and DELTA',
    );
  const matrix = Array.from({ length: 12 }, () => 0);
  rows.forEach((row, axis) => {
    matrix[4 * row + axis] = delta[axis];
    matrix[4 * row + 3] = origin[axis];
  });
  return matrix;
}
