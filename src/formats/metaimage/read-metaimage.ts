import { cartesianGrid } from '../../volume/grid.ts';
import type { Matrix4, Vector3 } from '../../volume/matrix.ts';
import { countSampleBytes } from '../base/count-sample-bytes.ts';
import type { DecodeInput } from '../base/decoded-volume.ts';
import type { FormatReader, ReadContext } from '../base/format.ts';
import { completeAxes } from '../grid-files/complete-axes.ts';
import { checkLengths } from '../base/check-lengths.ts';
import { corruptFile, unsupportedFile } from '../base/file-problem.ts';
import { findDataFiles, shareBytes } from '../grid-files/find-data-files.ts';
import { listDataFiles } from '../grid-files/list-data-files.ts';
import { readSamples } from '../grid-files/read-samples.ts';
import type { SampleLayout } from '../grid-files/read-samples.ts';
import { mayKeepAll, openInArray } from '../grid-files/open-in-array.ts';
import { areScans } from '../series/open-volumes.ts';
import { hostIsLittleEndian } from '../base/number-types.ts';
import type { NumberType } from '../base/number-types.ts';
import { listLeft } from '../base/list-left.ts';
import { placeVolume } from '../base/place-volume.ts';
import { storeSamples, wholeNumbersOf } from '../base/store-samples.ts';
import { needField, readFlag, readMetaImageHeader, readNumbers, readType, what } from './metaimage-header.ts';
import type { MetaImageHeader } from './metaimage-header.ts';

/** Reads a MetaImage file, or its header and the files that it names. Volumes along further axes are scans. */
export const readMetaImage: FormatReader = async (input, settings, context) => {
  const header = readMetaImageHeader(input.bytes);
  const type = readType(header);
  const sizes = readSizes(header);
  const [nx, ny = 1, nz = 1, ...series] = sizes;
  const dimensions: Vector3 = [nx, ny, nz];
  const volumes = series.reduce((product, n) => product * n, 1);
  const indexToWorld = readAffine(header, sizes.length);
  const wanted = countSampleBytes(what, dimensions, type);
  const isText = !readFlag(header, 'BinaryData', true);
  const littleEndian = isText ? hostIsLittleEndian : !readFlag(header, 'BinaryDataByteOrderMSB', false);
  const grid = cartesianGrid(dimensions, indexToWorld);
  const bytesInAll = wanted * volumes;
  if (areScans(volumes, type, settings, context) && mayKeepAll(volumes, bytesInAll, context)) {
    const bytes = await readData(input, context, { header, type, wanted: bytesInAll, bytesInAll });
    const starts = Array.from({ length: volumes }, (_, i) => i * nx * ny * nz);
    const info = { grid, unit: '', format: 'MetaImage', anatomical: isAnatomical(header) };
    return openInArray(
      { bytes, dimensions, strides: [1, nx, nx * ny], starts },
      { info, type, littleEndian, left: listUnused(header) },
      settings,
      context,
    );
  }
  const bytes = await readData(input, context, { header, type, wanted, bytesInAll });
  const { samples, scale, offset, indexed, rounded, unkept } = storeSamples(bytes, type, littleEndian, {
    slope: 1,
    intercept: 0,
    budget: context.budget,
    chooseWhole: await wholeNumbersOf(type),
  });
  const format = `MetaImage${volumes > 1 ? `, volume 1 of ${volumes}` : ''}`;
  return placeVolume(
    {
      grid,
      samples,
      slope: scale,
      intercept: offset,
      indexed,
      rounded,
      unkept,
      unit: '',
      format,
      anatomical: isAnatomical(header),
      ...listLeft(volumes, ...listUnused(header)),
    },
    settings,
  );
};

function readSizes(header: MetaImageHeader): number[] {
  needField(header, 'NDims');
  const [axes] = readNumbers(header, 'NDims', 1) ?? [NaN];
  if (!(Number.isInteger(axes) && axes >= 1 && axes <= 10))
    throw corruptFile(what, `got ${axes} axes; expected 1 to 10`);
  needField(header, 'DimSize');
  const sizes = readNumbers(header, 'DimSize', axes) ?? [];
  checkLengths(what, 'DimSize', sizes);
  const [channels] = readNumbers(header, 'ElementNumberOfChannels', 1) ?? [1];
  if (channels !== 1)
    throw unsupportedFile(
      'the MetaImage file',
      `holds ${channels} numbers per voxel (ElementNumberOfChannels); a transfer function needs one: convert it first`,
    );
  return sizes;
}

/**
 * Voxel index to world (RAS, mm): ITK's world is LPS. A row of the file's matrix is the direction of an axis. The
 * centre of rotation is not used, and the letters of AnatomicalOrientation only repeat the matrix.
 */
function readAffine(header: MetaImageHeader, axes: number): Matrix4 {
  const used = Math.min(3, axes);
  const directions = readNumbers(header, 'TransformMatrix', axes * axes);
  const spacing = readNumbers(header, 'ElementSpacing', axes);
  const offset = readNumbers(header, 'Offset', axes);
  const toWorld = (at: (component: number) => number): Vector3 => {
    const [x, y, z] = [0, 1, 2].map((component) => (component < used ? at(component) : 0));
    return [-x, -y, z];
  };
  const steps = Array.from({ length: used }, (_, axis) =>
    toWorld(
      (component) => (spacing?.[axis] ?? 1) * (directions?.[axis * axes + component] ?? (axis === component ? 1 : 0)),
    ),
  );
  return completeAxes(
    what,
    steps,
    toWorld((component) => offset?.[component] ?? 0),
  );
}

/** Whether the header gives the patient's orientation; MetaIO writes "???" if it is unknown. */
function isAnatomical({ fields }: MetaImageHeader): boolean {
  const letters = fields.get('AnatomicalOrientation')?.trim();
  return letters
    ? /^[RLAPSI]{2,3}$/i.test(letters)
    : ['TransformMatrix', 'Rotation', 'Orientation'].some((name) => fields.get(name));
}

/** Fields about values and lengths that ITK ignores, and this reader too. */
function listUnused(header: MetaImageHeader): (string | null)[] {
  const [slope] = readNumbers(header, 'ElementToIntensityFunctionSlope', 1) ?? [1];
  const [intercept] = readNumbers(header, 'ElementToIntensityFunctionOffset', 1) ?? [0];
  const unit = header.fields.get('DistanceUnits')?.trim() ?? '';
  return [
    slope !== 1 || intercept !== 0
      ? `ElementToIntensityFunction: values are shown as they are stored, and not times ${slope} plus ${intercept}`
      : null,
    unit !== '' && !/^(mm|\?|unknown)$/i.test(unit)
      ? `DistanceUnits "${unit.slice(0, 40)}": lengths are taken for millimetres`
      : null,
  ];
}

interface Wanted {
  readonly header: MetaImageHeader;
  readonly type: NumberType;
  /** Bytes of the first volume, and of all. */
  readonly wanted: number;
  readonly bytesInAll: number;
}

async function readData(
  input: DecodeInput,
  context: ReadContext,
  { header, type, wanted, bytesInAll }: Wanted,
): Promise<Uint8Array<ArrayBuffer>> {
  const names = findDataFiles(what, header.dataFiles, input, context);
  const bytesPerFile = shareBytes(what, bytesInAll, type.bytesPerSample, names);
  const own = names ? input : trimToData(input, header);
  const files = listDataFiles(names, own, context, Math.ceil(wanted / bytesPerFile));
  return readSamples(files, describeSource(header, type, bytesPerFile), wanted, context);
}

/** For a header with packed data after it: only the bytes of these data; others may follow. */
function trimToData(input: DecodeInput, header: MetaImageHeader): DecodeInput {
  const [packed] = readNumbers(header, 'CompressedDataSize', 1) ?? [0];
  if (!readFlag(header, 'CompressedData', false) || !(packed > 0)) return input;
  const end = header.end + packed;
  if (end > input.bytes.length)
    throw corruptFile(
      'the MetaImage file',
      `ends early: got ${input.bytes.length - header.end} packed bytes; its header says ${packed}`,
    );
  return { ...input, bytes: input.bytes.subarray(0, end) };
}

function describeSource(header: MetaImageHeader, type: NumberType, bytesPerFile: number): SampleLayout {
  const isPacked = readFlag(header, 'CompressedData', false);
  const isText = !readFlag(header, 'BinaryData', true);
  const [headerSize] = readNumbers(header, 'HeaderSize', 1) ?? [0];
  if (!(Number.isSafeInteger(headerSize) && headerSize >= -1))
    throw corruptFile(what, `got HeaderSize ${headerSize}; expected a whole number from -1`);
  if (headerSize === -1 && (isPacked || isText))
    throw corruptFile(what, 'got HeaderSize -1 with data that are no plain numbers; expected CompressedData = False');
  const isLocal = header.dataFiles === null;
  return {
    what: 'the MetaImage file',
    type,
    encoding: isText ? 'text' : isPacked ? 'deflate' : 'raw',
    bytesPerFile,
    // In the header's own file MetaIO's HeaderSize counts from the file's start.
    start: isLocal && headerSize <= 0 ? header.end : 0,
    skipBytes: headerSize === -1 ? 'all before' : headerSize,
  };
}
