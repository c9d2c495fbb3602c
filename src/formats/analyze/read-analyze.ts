import { cartesianGrid } from '../../volume/grid.ts';
import { multiply, scaleAndTranslate } from '../../volume/matrix.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import type { DecodeInput } from '../base/decoded-volume.ts';
import { corruptFile, unsupportedFile } from '../base/file-problem.ts';
import type { FormatReader, ReadContext } from '../base/format.ts';
import { nameOf } from '../base/name-of.ts';
import { PieceReader, yieldOnce } from '../base/piece-reader.ts';
import { placeVolume } from '../base/place-volume.ts';
import { gunzip, isGzip, maxDeflateRatio } from '../codecs/gunzip.ts';
import { fetchPartner } from '../grid-files/fetch-partner.ts';
import { readNifti } from '../nifti/nifti.ts';
import type { NiftiSource } from '../nifti/nifti-source.ts';
import { detectNifti, headerSizes, niftiHeaderBytes, readVersion1, viewOf } from '../nifti/nifti-header.ts';
import type { NiftiHeader, NiftiStart } from '../nifti/nifti-header.ts';
import { readVersion2 } from '../nifti/nifti-rare-headers.ts';

/** What messages call such a file. */
const what = 'an Analyze or NIfTI volume';

/**
 * Reads a header and the file of its samples; either of them may be given. Several volumes are scans; those of Analyze have no times, as
 * programs write the unit of its fourth axis (`pixdim[4]`) in seconds or milliseconds.
 * Sources: nifti1.h; nibabel 5.4, `analyze.py` and `spm2analyze.py`
 */
export const readAnalyze: FormatReader = async (input, settings, context) => {
  const { header: headerBytes, found, samples } = await findPair(input, context);
  const isNifti = found.magic.startsWith('ni');
  const header = isNifti ? readPairHeader(headerBytes, found) : readAnalyzeHeader(headerBytes, found);
  const { onProgress, budget } = context;
  const isPacked = isGzip(samples);
  const describe = isNifti ? undefined : describeAnalyze(headerBytes, found);
  const volume = await readNifti(
    {
      pieces: isPacked ? gunzip(samples) : yieldOnce(samples),
      atMost: isPacked ? samples.length * maxDeflateRatio : samples.length,
      onProgress,
      budget,
      scans: [{ ...input, bytes: samples }, settings, context],
      head: headerBytes.slice(),
      ...(describe && { describe }),
    },
    header,
  );
  // Of scans, all that they have in common was described before.
  const isDescribed = !describe || !volume.format.startsWith('NIfTI');
  return placeVolume(isDescribed ? volume : { ...volume, ...describe(volume) }, settings);
};

/** What an Analyze file says of a volume, or of all its volumes, where a NIfTI file would say something else. */
function describeAnalyze(headerBytes: Uint8Array, found: NiftiStart): NonNullable<NiftiSource['describe']> {
  const orient = headerBytes[252];
  const more =
    orient >= 1 && orient <= 5
      ? [`the header's orientation (orient ${orient}): slices are taken as transverse, as SPM and nibabel take them`]
      : [];
  return ({ grid, format, left = [] }) => {
    const all = [...left, ...more];
    return {
      grid: placeOrigin(grid, headerBytes, found),
      format: format.replace(/^NIfTI-1/, 'Analyze 7.5'),
      ...(all.length > 0 && { left: all }),
    };
  };
}

interface Pair {
  readonly header: Uint8Array;
  readonly found: NiftiStart;
  readonly samples: Uint8Array<ArrayBuffer>;
}

async function findPair(input: DecodeInput, context: ReadContext): Promise<Pair> {
  const own = await readStart(input.bytes);
  const ownStart = detectNifti(own);
  if (ownStart) {
    checkLength(own, ownStart);
    const { bytes } = await fetchPartner(what, input, ['hdr', 'img'], context);
    return { header: own, found: ownStart, samples: bytes };
  }
  const other = await fetchPartner(what, input, ['img', 'hdr'], context);
  const header = await readStart(other.bytes);
  const found = detectNifti(header);
  if (!found)
    throw corruptFile(
      nameOf(other.url),
      `is no Analyze or NIfTI header, which ${nameOf(input.url)} needs; expected 348 bytes or more that begin with their own number`,
    );
  checkLength(header, found);
  return { header, found, samples: input.bytes };
}

/** The bytes of a header, unpacked. */
async function readStart(bytes: Uint8Array<ArrayBuffer>): Promise<Uint8Array> {
  if (!isGzip(bytes)) return bytes.subarray(0, niftiHeaderBytes);
  const reader = new PieceReader(gunzip(bytes));
  try {
    return (await reader.readStart(niftiHeaderBytes)).slice();
  } finally {
    await reader.stop();
  }
}

function checkLength(bytes: Uint8Array, { version, magic }: NiftiStart): void {
  if (bytes.length < headerSizes[version])
    throw corruptFile(
      `the NIfTI-${version} header`,
      `got ${bytes.length} bytes; expected ${headerSizes[version]}: the file is cut short`,
    );
  if (version === 2 && !magic.startsWith('ni2'))
    throw corruptFile('the NIfTI-2 header', 'lacks its mark, "n+2" or "ni2"; the file is damaged');
}

/** In a pair, the samples begin at the offset in their own file. */
function readPairHeader(bytes: Uint8Array, { version, littleEndian }: NiftiStart): NiftiHeader {
  const header = version === 1 ? readVersion1(bytes, littleEndian) : readVersion2(viewOf(bytes), littleEndian);
  return { ...header, offset: startOf(header) };
}

const startOf = ({ offset }: NiftiHeader): number => (offset > 0 ? Math.trunc(offset) : 0);

/** Colours. Source: Mayo's dbh.h, DT_RGB */
const rgb = 128;

/** SPM's codes of types that Analyze itself lacks: 128 and the code of the other sign. Source: SPM2's spm_type.m. */
const spmTypes = new Map([
  [130, 256],
  [132, 512],
  [136, 768],
]);

/**
 * The fields of an Analyze header lie where those of NIfTI do, but several have another meaning. As SPM and nibabel do,
 * the values are scaled by SPM's factor, else by the calibration if there is one. The file does not say which side is
 * the patient's left: as they do, x is taken to run from right to left.
 */
function readAnalyzeHeader(bytes: Uint8Array, { littleEndian }: NiftiStart): NiftiHeader {
  const header = readVersion1(bytes, littleEndian);
  if (header.datatype === rgb)
    throw unsupportedFile(
      'the Analyze file',
      'holds colours (RGB24), which programs write in two orders; convert it to NIfTI, or to numbers',
    );
  return {
    ...header,
    datatype: spmTypes.get(header.datatype) ?? header.datatype,
    ...readScale(header, bytes, littleEndian),
    offset: startOf(header),
    calMin: 0,
    calMax: 0,
    intent: 0,
    units: 0,
    qformCode: 0,
    sformCode: 0,
  };
}

/** Source: nibabel's `Spm2AnalyzeHeader.get_slope_inter`. */
function readScale(
  { slope, intercept, calMin, calMax }: NiftiHeader,
  bytes: Uint8Array,
  littleEndian: boolean,
): Pick<NiftiHeader, 'slope' | 'intercept'> {
  if (slope !== 0 && Number.isFinite(slope)) return { slope, intercept: Number.isFinite(intercept) ? intercept : 0 };
  const view = viewOf(bytes);
  const [max, min] = [140, 144].map((at) => view.getInt32(at, littleEndian));
  const factor = (calMax - calMin) / (max - min);
  return calMax !== calMin && max !== min && Number.isFinite(factor)
    ? { slope: factor, intercept: calMax - factor * max }
    : { slope: 1, intercept: 0 };
}

/**
 * The world's origin, which SPM writes as the number of a voxel, from 1. Without it, or far outside of the volume, the
 * origin is the volume's centre. Source: nibabel's `SpmAnalyzeHeader.get_origin_affine`
 */
function placeOrigin(
  grid: ReturnType<typeof cartesianGrid>,
  bytes: Uint8Array,
  { littleEndian }: NiftiStart,
): ReturnType<typeof cartesianGrid> {
  const { dimensions, indexToWorld } = grid;
  const view = viewOf(bytes);
  const origin = [253, 255, 257].map((at) => view.getInt16(at, littleEndian));
  const isUsed =
    origin.some((n) => n !== 0) && origin.every((n, axis) => n > -dimensions[axis] && n < 2 * dimensions[axis]);
  if (!isUsed) return grid;
  const back = origin.map((n, axis) => (dimensions[axis] - 1) / 2 - (n - 1)) as unknown as Vector3;
  return cartesianGrid(dimensions, multiply(indexToWorld, scaleAndTranslate([1, 1, 1], back)));
}
