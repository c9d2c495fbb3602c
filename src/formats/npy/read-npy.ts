import { axialIndexToWorld, cartesianGrid } from '../../volume/grid.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import { countSampleBytes } from '../base/count-sample-bytes.ts';
import { unsupportedFile } from '../base/file-problem.ts';
import type { FormatReader } from '../base/format.ts';
import { listLeft } from '../base/list-left.ts';
import { PieceReader, readSpan, yieldOnce } from '../base/piece-reader.ts';
import { placeVolume } from '../base/place-volume.ts';
import { storeSamples, wholeNumbersOf } from '../base/store-samples.ts';
import { gunzip, isGzip, maxDeflateRatio } from '../codecs/gunzip.ts';
import { mayKeepAll, openInArray } from '../grid-files/open-in-array.ts';
import { pickVolume } from '../grid-files/pick-volume.ts';
import { areScans, openVolumes } from '../series/open-volumes.ts';
import type { VolumesOfFile } from '../series/open-volumes.ts';
import { readNpyHeader } from './npy-header.ts';
import type { NpyHeader } from './npy-header.ts';

/**
 * Reads an array of NumPy. Its axes are slices, rows, columns, whatever the order in memory: the last axis is i, the one
 * before it j, the third from the end k, as SimpleITK and scikit-image have them. Axes before these make scans.
 */
export const readNpy: FormatReader = async ({ bytes }, settings, context) => {
  const { onProgress, budget } = context;
  onProgress(0, bytes.length);
  const isPacked = isGzip(bytes);
  const atMost = isPacked ? bytes.length * maxDeflateRatio : bytes.length;
  const reader = new PieceReader(isPacked ? gunzip(bytes) : yieldOnce(bytes));
  try {
    const header = await readNpyHeader(reader);
    const { type, littleEndian, end } = header;
    const { dimensions, strides, volumes, further } = arrangeAxes(header);
    const picked = countSampleBytes('the NPY header', dimensions, type);
    const lost = type.complex ? 'the phase of complex numbers, whose magnitudes are shown' : null;
    const grid = cartesianGrid(dimensions, axialIndexToWorld(dimensions, [1, 1, 1]));
    const source = { atMost, onProgress, budget };
    const isSeries = areScans(volumes, type, settings, context);
    const series: VolumesOfFile = { info: { grid, unit: '', format: 'NPY' }, type, littleEndian, left: [lost] };
    if (isSeries && !header.isFortran) {
      const pieces = isPacked ? gunzip(bytes) : yieldOnce(bytes);
      const span = { what: 'the NPY file', offset: end, bytes: picked, count: volumes };
      return await openVolumes({ ...span, pieces, atMost }, () => series, settings, context);
    }
    // In Fortran's order the samples of all volumes lie among each other.
    if (isSeries && mayKeepAll(volumes, volumes * picked, context)) {
      const inAll = { what: 'NPY', offset: end, bytes: volumes * picked, isPart: false };
      const array = { bytes: await readSpan(reader, source, inAll), dimensions, strides, starts: listStarts(further) };
      return await openInArray(array, series, settings, context);
    }
    // The number of samples from the volume's first one to its last one; samples of other volumes may lie between.
    const span = 1 + dimensions.reduce((sum, n, axis) => sum + (n - 1) * strides[axis], 0);
    const spanBytes = countSampleBytes('the NPY header', [span], type);
    const all = await readSpan(reader, source, { what: 'NPY', offset: end, bytes: spanBytes, isPart: volumes > 1 });
    budget.take(picked, 'the NPY file');
    const samplesBytes = pickVolume(all, type.bytesPerSample, dimensions, strides);
    budget.giveBack(samplesBytes === all ? picked : spanBytes);
    if (type.name === 'float16') budget.take(2 * picked, 'the NPY file');
    const { samples, scale, offset, indexed, rounded, unkept } = storeSamples(samplesBytes, type, littleEndian, {
      slope: 1,
      intercept: 0,
      budget,
      chooseWhole: await wholeNumbersOf(type),
    });
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
        format: `NPY${volumes > 1 ? `, volume 1 of ${volumes}` : ''}`,
        ...listLeft(volumes, lost),
      },
      settings,
    );
  } finally {
    await reader.stop();
  }
};

interface NpyAxes {
  readonly dimensions: Vector3;
  /** Samples from one voxel to the next along i, j and k. */
  readonly strides: Vector3;
  readonly volumes: number;
  /** The axes along which volumes lie, the slowest first: their lengths, and samples from one to the next. */
  readonly further: readonly (readonly [length: number, stride: number])[];
}

function arrangeAxes({ shape, isFortran, type }: NpyHeader): NpyAxes {
  const last = shape.at(-1) ?? 1;
  if (type.name === 'uint8' && shape.length > 3 && (last === 3 || last === 4))
    throw unsupportedFile(
      'the NPY file',
      `has the shape (${shape.join(', ')}), whose last axis looks like colours; expected one number per voxel: save one channel, numpy.save(file, array[..., 0])`,
    );
  // Samples from one to the next along each axis of the array.
  const steps = shape.map((_, axis) =>
    (isFortran ? shape.slice(0, axis) : shape.slice(axis + 1)).reduce((product, n) => product * n, 1),
  );
  const fromEnd = (list: readonly number[]): Vector3 => [list.at(-1) ?? 1, list.at(-2) ?? 1, list.at(-3) ?? 1];
  return {
    dimensions: fromEnd(shape),
    strides: fromEnd(steps),
    volumes: shape.slice(0, -3).reduce((product, n) => product * n, 1),
    further: shape.slice(0, -3).map((n, axis) => [n, steps[axis]]),
  };
}

/** Where each volume begins, samples, in the order of C. */
function listStarts(further: NpyAxes['further']): number[] {
  return further.reduce(
    (starts, [n, stride]) => starts.flatMap((start) => Array.from({ length: n }, (_, i) => start + i * stride)),
    [0],
  );
}
