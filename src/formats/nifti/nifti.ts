import { cartesianGrid } from '../../volume/grid.ts';
import { countSampleBytes } from '../base/count-sample-bytes.ts';
import type { DecodedCartesianVolume } from '../base/decoded-volume.ts';
import type { FormatReader } from '../base/format.ts';
import { gunzip, isGzip, maxDeflateRatio } from '../codecs/gunzip.ts';
import { loadReader } from '../base/load-reader.ts';
import { resolveAffine } from './nifti-affine.ts';
import {
  detectNifti,
  headerSizes,
  niftiHeaderBytes,
  readDimensions,
  readVersion1,
  readWindow,
} from './nifti-header.ts';
import type { NiftiHeader } from './nifti-header.ts';
import type { NiftiSource } from './nifti-source.ts';
import { niftiTypes } from '../base/number-types.ts';
import type { NumberType } from '../base/number-types.ts';
import { PieceReader, readSpan, yieldOnce } from '../base/piece-reader.ts';
import { placeVolume } from '../base/place-volume.ts';
import { storeSamples, wholeNumbersOf } from '../base/store-samples.ts';

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
      scans: [input, settings, context],
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
  const { slope: scale, intercept: shift } = header;
  const isScaled = scale !== 0 && Number.isFinite(scale);
  const [axes, nx] = header.dim;
  if (!(axes >= 1 && axes <= 7 && nx >= 1) || (isScaled && !Number.isFinite(shift)))
    throw (await loadReader(() => import('#rare/formats/nifti/nifti-problems.ts'))).refuseHeader(header);
  const { dimensions, volumes, numbers } = readDimensions(header);
  const type = await readType(header);
  // Slope 0, or none, means that the stored numbers are the data (nifti1.h).
  const rescale = isScaled ? { slope: scale, intercept: shift } : { slope: 1, intercept: 0 };
  const bytes = countSampleBytes('the NIfTI header', dimensions, type);
  const isPart = volumes * numbers > 1;
  const several =
    isPart || type.complex ? await loadReader(() => import('#rare/formats/nifti/nifti-several.ts')) : null;
  const more = await several?.openScans(source, header, { type, rescale, bytes });
  if (more && 'samples' in more) return more;
  const content = await readSpan(reader, source, {
    what: 'NIfTI',
    offset: header.offset,
    bytes,
    isPart,
  });
  const stored = storeSamples(content, type, header.littleEndian, {
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
    ...readWindow(header),
    ...more,
    colors: type.colors?.(),
  };
}

/** Anything except a single file of version 1 is read, or refused, by a part of the code that is loaded then. */
async function readHeader(bytes: Uint8Array): Promise<NiftiHeader> {
  const found = detectNifti(bytes);
  const header =
    found?.version === 1
      ? readVersion1(bytes, found.littleEndian)
      : await (
          await loadReader(() => import('#rare/formats/nifti/nifti-rare-headers.ts'))
        ).readRareHeader(bytes, found);
  // The header is followed by four bytes that say whether extensions follow; some writers leave the offset 0.
  const minOffset = headerSizes[header.version] + 4;
  return { ...header, offset: header.offset >= minOffset ? Math.trunc(header.offset) : minOffset };
}

async function readType({ datatype }: NiftiHeader): Promise<NumberType> {
  const type = niftiTypes.get(datatype);
  if (type) return type;
  const { readRareType } = await loadReader(() => import('#rare/formats/nifti/nifti-rare-types.ts'));
  return readRareType(datatype);
}
