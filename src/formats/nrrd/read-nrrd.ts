import { cartesianGrid } from '../../volume/grid.ts';
import { corruptFile } from '../base/file-problem.ts';
import { findDataFiles, shareBytes } from '../grid-files/find-data-files.ts';
import { pickVolume } from '../grid-files/pick-volume.ts';
import { readSamples } from '../grid-files/read-samples.ts';
import type { SampleLayout } from '../grid-files/read-samples.ts';
import { listDataFiles } from '../grid-files/list-data-files.ts';
import { countSampleBytes } from '../base/count-sample-bytes.ts';
import type { DecodedCartesianVolume, DecodeInput } from '../base/decoded-volume.ts';
import type { FormatReader, ReadContext } from '../base/format.ts';
import { loadReader } from '../base/load-reader.ts';
import { hostIsLittleEndian } from '../base/number-types.ts';
import type { NumberType } from '../base/number-types.ts';
import { listLeft } from '../base/list-left.ts';
import { placeVolume } from '../base/place-volume.ts';
import { storeSamples, wholeNumbersOf } from '../base/store-samples.ts';
import { isAnatomical, readAffine } from './nrrd-affine.ts';
import { openNrrdScans } from './nrrd-scans.ts';
import { chooseAxes, listVolumes, quoted, readAxes } from './nrrd-axes.ts';
import type { NrrdAxis, NrrdLayout } from './nrrd-axes.ts';
import type * as segmentPart from './segments.ts';
import type { Layer, MergedSegments } from './segments.ts';
import { isLittleEndian, readCount, readEncoding, readNrrdHeader, readType, what } from './nrrd-header.ts';
import type { NrrdFields, NrrdHeader } from './nrrd-header.ts';

/**
 * Reads an NRRD file, or its header and the files that it names. Volumes of lists and series are scans; of 3D Slicer's segmentations all
 * layers are read.
 */
export const readNrrd: FormatReader = async (input, settings, context) => {
  const header = readNrrdHeader(input.bytes);
  const { fields } = header;
  const type = readType(fields);
  const all = readAxes(fields);
  const layout = chooseAxes(all);
  const indexToWorld = readAffine(fields, layout.axes);
  const wanted: Wanted = { header, type, all, layout };
  const { volumes } = layout;
  const grid = cartesianGrid(layout.dimensions, indexToWorld);
  const isLabels = header.segments.size > 0;
  const scans = isLabels
    ? null
    : await openNrrdScans(
        { all, layout, read: (samples) => readSpan(input, context, wanted, samples) },
        {
          info: { grid, unit: readSampleUnit(fields), anatomical: isAnatomical(fields), format: 'NRRD' },
          type,
          littleEndian: isStoredLittleEndian(fields),
          left: [describeOldRange(fields)],
        },
        settings,
        context,
      );
  if (scans) return scans;
  const segments = isLabels ? await loadReader(() => import('./segments.ts')) : null;
  const labels = segments && {
    isLabels: true,
    named: segments.nameSegments(segments.readSegments(header.segments, volumes)),
  };
  const merged =
    segments && (volumes > 1 || header.isFractional) ? await mergeLayers(input, context, wanted, segments) : null;
  const volume = {
    grid,
    ...(merged ?? (await store(await readFirst(input, context, wanted), wanted, context))),
    unit: readSampleUnit(fields),
    anatomical: isAnatomical(fields),
    format: `NRRD${volumes === 1 ? '' : merged ? `, ${volumes} layers` : `, volume 1 of ${volumes}`}`,
    ...labels,
    ...merged,
    left: undefined,
    ...listLeft(merged ? 1 : volumes, ...(merged?.left ?? []), describeOldRange(fields)),
  };
  return placeVolume(volume, settings);
};

interface Wanted {
  readonly header: NrrdHeader;
  readonly type: NumberType;
  readonly all: readonly NrrdAxis[];
  readonly layout: NrrdLayout;
}

type Stored = Pick<DecodedCartesianVolume, 'samples' | 'slope' | 'intercept' | 'indexed' | 'rounded' | 'unkept'>;

async function store(
  bytes: Uint8Array<ArrayBuffer>,
  { header: { fields }, type }: Wanted,
  { budget }: ReadContext,
): Promise<Stored> {
  const { samples, scale, offset, indexed, rounded, unkept } = storeSamples(bytes, type, isStoredLittleEndian(fields), {
    slope: 1,
    intercept: 0,
    budget,
    chooseWhole: await wholeNumbersOf(type),
  });
  return { samples, slope: scale, intercept: offset, indexed, rounded, unkept };
}

const isStoredLittleEndian = (fields: NrrdFields): boolean =>
  readEncoding(fields) === 'text' ? hostIsLittleEndian : isLittleEndian(fields);

type SegmentPart = typeof segmentPart;

/** Merges all layers of a segmentation. */
async function mergeLayers(
  input: DecodeInput,
  context: ReadContext,
  wanted: Wanted,
  { SegmentMerger, readSegments }: SegmentPart,
): Promise<MergedSegments & Pick<Stored, 'slope' | 'intercept'>> {
  const {
    header,
    type,
    all,
    layout: { dimensions, strides, volumes },
    layout,
  } = wanted;
  const { bytesPerSample } = type;
  const voxels = dimensions.reduce((product, n) => product * n, 1);
  const bytes = await readSpan(input, context, wanted, voxels * volumes);
  // A copy of each layer, and the merged labels.
  context.budget.take(countSampleBytes(what, dimensions, type) + 3 * voxels, what);
  const readLayer = async (start: number): Promise<Layer> => {
    const picked = pickVolume(bytes.subarray(start * bytesPerSample), bytesPerSample, dimensions, strides);
    const { slope, intercept, samples, indexed } = await store(picked.slice(), wanted, context);
    return indexed ? { slope: 1, intercept: 0, ...indexed } : { samples, slope, intercept };
  };
  const starts = listVolumes(all, layout);
  const merger = new SegmentMerger(readSegments(header.segments, volumes), voxels);
  if (header.isFractional) for (const start of starts) merger.countFractions(await readLayer(start));
  for (const [layer, start] of starts.entries()) merger.add(layer, await readLayer(start));
  return { ...merger.finish(), slope: 1, intercept: 0 };
}

/** The first volume's samples, i fastest, as they lie in the file. */
async function readFirst(input: DecodeInput, context: ReadContext, wanted: Wanted): Promise<Uint8Array<ArrayBuffer>> {
  const {
    type,
    layout: { dimensions, strides },
  } = wanted;
  // The number of samples from the volume's first one to its last one; samples of other volumes may lie between.
  const span = 1 + dimensions.reduce((sum, n, axis) => sum + (n - 1) * strides[axis], 0);
  const picked = countSampleBytes(what, dimensions, type);
  const bytes = await readSpan(input, context, wanted, span);
  if (picked === bytes.length) return bytes;
  context.budget.take(picked, what);
  context.budget.giveBack(bytes.length);
  return pickVolume(bytes, type.bytesPerSample, dimensions, strides);
}

/** The array's first samples, as they lie in the file. */
async function readSpan(
  input: DecodeInput,
  context: ReadContext,
  { header, type, all }: Wanted,
  span: number,
): Promise<Uint8Array<ArrayBuffer>> {
  const wanted = countSampleBytes(what, [span], type);
  const bytesInAll = all.reduce((product, { size }) => product * size, 1) * type.bytesPerSample;
  const names = findDataFiles(what, header.dataFiles, input, context);
  const source = describeSource(header, type, shareBytes(what, bytesInAll, type.bytesPerSample, names));
  const files = listDataFiles(names, input, context, Math.ceil(wanted / source.bytesPerFile));
  return readSamples(files, source, wanted, context);
}

function describeSource({ fields, dataFiles, end }: NrrdHeader, type: NumberType, bytesPerFile: number): SampleLayout {
  const encoding = readEncoding(fields);
  const skip = readCount(fields, 'byteskip', -1);
  if (skip < 0 && encoding !== 'raw')
    throw corruptFile(what, 'got byte skip -1 with data that are packed; expected encoding raw');
  const isPacked = encoding === 'deflate' || encoding === 'bzip2';
  return {
    what: 'the NRRD file',
    type,
    encoding,
    bytesPerFile,
    start: dataFiles ? 0 : end,
    skipLines: readCount(fields, 'lineskip', 0),
    // In packed data, lines are skipped before and bytes after unpacking.
    skipBytes: skip < 0 ? 'all before' : isPacked ? 0 : skip,
    skipUnpacked: isPacked ? skip : 0,
  };
}

function readSampleUnit(fields: NrrdFields): string {
  const text = fields.get('sampleunits') ?? '';
  return quoted(text)[0] ?? text;
}

/** Values that were converted to whole numbers may have an `old min` and `old max`: no reader applies them. */
function describeOldRange(fields: NrrdFields): string | null {
  const [low, high] = ['oldmin', 'oldmax'].map((name) => Number(fields.get(name) ?? NaN));
  return Number.isFinite(high - low)
    ? `old min and old max: values are shown as they are stored, and not from ${low} to ${high}`
    : null;
}
