import { VolumeViewError } from '../../core/errors.ts';
import { cartesianGrid } from '../../volume/grid.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import { countSampleBytes } from '../base/count-sample-bytes.ts';
import type { DecodedCartesianVolume, DecodeInput, DecodeSettings } from '../base/decoded-volume.ts';
import type { FormatReader, ReadContext } from '../base/format.ts';
import { gunzip, isGzip, maxDeflateRatio } from '../codecs/gunzip.ts';
import { loadReader } from '../base/load-reader.ts';
import { resolveAffine } from './nifti-affine.ts';
import { detectNifti, headerSizes, niftiHeaderBytes, readVersion1 } from './nifti-header.ts';
import type { NiftiHeader } from './nifti-header.ts';
import { niftiTypes } from '../base/number-types.ts';
import type { NumberType } from '../base/number-types.ts';
import { PieceReader, readSpan, yieldOnce } from '../base/piece-reader.ts';
import type { StreamSource } from '../base/piece-reader.ts';
import { placeVolume } from '../base/place-volume.ts';
import { storeSamples, wholeNumbersOf } from '../base/store-samples.ts';

export interface NiftiSource extends StreamSource {
  /** The file's bytes, unpacked, in pieces. */
  readonly pieces: AsyncIterable<Uint8Array<ArrayBuffer>>;
  /** Set where several volumes are opened as scans. */
  readonly scans?: {
    readonly input: DecodeInput;
    readonly settings: DecodeSettings;
    readonly context: ReadContext;
  };
}

/** What a header says of the numbers. */
export interface NiftiParts {
  readonly header: NiftiHeader;
  readonly dimensions: Vector3;
  readonly volumes: number;
  /** Of each voxel. */
  readonly numbers: number;
  readonly type: NumberType;
  readonly rescale: { readonly slope: number; readonly intercept: number };
  readonly window?: readonly [number, number];
  /** Of one volume. */
  readonly bytes: number;
}

/** Reads a NIfTI file, packed with gzip or not. */
export const readNiftiFile: FormatReader = async (input, settings, context) => {
  const { bytes } = input;
  const { onProgress, budget } = context;
  onProgress(0, bytes.length);
  const isPacked = isGzip(bytes);
  const pieces = isPacked ? gunzip(bytes) : yieldOnce(bytes);
  return placeVolume(
    await readNifti({
      pieces,
      atMost: isPacked ? bytes.length * maxDeflateRatio : bytes.length,
      onProgress,
      budget,
      scans: settings.scan && !context.isPart ? { input, settings, context } : undefined,
    }),
    settings,
  );
};

/**
 * Reads a NIfTI-1 or -2 file: of a series, its first volume, or the one that is wanted of its scans.
 * @param header - of another file, if the source has only the samples
 * @throws {VolumeViewError} `format/unsupported`, `format/corrupt`, `format/too-large`
 */
export async function readNifti(source: NiftiSource, header?: NiftiHeader): Promise<DecodedCartesianVolume> {
  const reader = new PieceReader(source.pieces);
  try {
    const start = await reader.readStart(niftiHeaderBytes);
    return await readVolume(reader, source, header ?? (await readHeader(start)));
  } finally {
    await reader.stop();
  }
}

async function readVolume(
  reader: PieceReader,
  source: NiftiSource,
  header: NiftiHeader,
): Promise<DecodedCartesianVolume> {
  const { dimensions, volumes, numbers } = readDimensions(header);
  const type = await readType(header);
  const rescale = readRescale(header);
  const parts: NiftiParts = {
    header,
    dimensions,
    volumes,
    numbers,
    type,
    rescale,
    bytes: countSampleBytes('the NIfTI header', dimensions, type),
    ...readWindow(header),
  };
  const isPart = volumes * numbers > 1;
  const several =
    isPart || type.complex ? await loadReader(() => import('#rare/formats/nifti/nifti-several.ts')) : null;
  const opened = await several?.openNiftiScans(source, parts);
  if (opened) return opened;
  const bytes = await readSpan(reader, source, {
    what: 'NIfTI',
    offset: header.offset,
    bytes: parts.bytes,
    isPart,
  });
  const stored = storeSamples(bytes, type, header.littleEndian, {
    ...rescale,
    budget: source.budget,
    chooseWhole: await wholeNumbersOf(type),
  });
  const { slope, intercept } = type.complex ? { slope: 1, intercept: 0 } : rescale;
  const { indexToWorld, anatomical } = resolveAffine(header, dimensions);
  return {
    grid: cartesianGrid(dimensions, indexToWorld),
    anatomical,
    samples: stored.samples,
    slope: slope * stored.scale,
    intercept: slope * stored.offset + intercept,
    // Nobody expects all digits of scaled numbers.
    ...(slope === 1 && intercept === 0 ? { indexed: stored.indexed, rounded: stored.rounded } : {}),
    unkept: stored.unkept,
    unit: '',
    format: `NIfTI-${header.version}`,
    isLabels: header.intent === 1002,
    intent: header.intent,
    window: parts.window,
    ...several?.describeFirst(parts),
  };
}

/** Anything except a single file of version 1 is read, or refused, by a part of the code that is loaded then. */
async function readHeader(bytes: Uint8Array): Promise<NiftiHeader> {
  const found = detectNifti(bytes);
  const header =
    found?.version === 1
      ? readVersion1(bytes, found.littleEndian)
      : (await loadReader(() => import('./nifti-rare-headers.ts'))).readRareHeader(bytes, found);
  // The header is followed by four bytes that say whether extensions follow; some writers leave the offset 0.
  const minOffset = headerSizes[header.version] + 4;
  return { ...header, offset: header.offset >= minOffset ? Math.trunc(header.offset) : minOffset };
}

/**
 * Lengths along i, j, k; missing axes have length 1. The fourth axis, time, makes a series, and so do those from the
 * sixth on; along the fifth lie the numbers of a voxel (nifti1.h).
 */
function readDimensions(header: NiftiHeader): { dimensions: Vector3; volumes: number; numbers: number } {
  const axes = header.dim[0];
  if (!(axes >= 1 && axes <= 7)) {
    throw new VolumeViewError('format/corrupt', `the NIfTI header got ${axes} axes; expected 1 to 7`);
  }
  const lengths = header.dim.slice(1, 1 + axes);
  if (lengths.slice(0, 3).some((n) => !(n >= 1))) {
    throw new VolumeViewError(
      'format/corrupt',
      `the NIfTI header got dimensions ${lengths.join(' x ')}; expected whole numbers from 1`,
    );
  }
  const [nx, ny = 1, nz = 1, time = 1, numbers = 1, ...series] = lengths;
  return {
    dimensions: [nx, ny, nz],
    volumes: [time, ...series].reduce((product, n) => product * Math.max(1, n), 1),
    numbers: Math.max(1, numbers),
  };
}

async function readType({ datatype }: NiftiHeader): Promise<NumberType> {
  const type = niftiTypes.get(datatype);
  if (type) return type;
  const { readRareType } = await loadReader(() => import('#rare/formats/nifti/nifti-rare-types.ts'));
  return readRareType(datatype);
}

/** Slope 0, or none, means that the stored numbers are the data (nifti1.h). */
function readRescale(header: NiftiHeader): { slope: number; intercept: number } {
  const { slope, intercept } = header;
  if (slope === 0 || !Number.isFinite(slope)) return { slope: 1, intercept: 0 };
  if (!Number.isFinite(intercept)) {
    throw new VolumeViewError(
      'format/corrupt',
      `the NIfTI header got scl_slope ${slope} with scl_inter ${intercept}; expected a finite number`,
    );
  }
  return { slope, intercept };
}

function readWindow({ calMin, calMax }: NiftiHeader): { window?: [number, number] } {
  return calMax > calMin && Number.isFinite(calMax - calMin) ? { window: [calMin, calMax] } : {};
}
