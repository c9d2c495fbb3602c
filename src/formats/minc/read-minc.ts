import { cartesianGrid } from '../../volume/grid.ts';
import { invertAffine } from '../../volume/matrix.ts';
import type { Matrix4, Vector3 } from '../../volume/matrix.ts';
import type { Budget } from '../base/budget.ts';
import { countSampleBytes } from '../base/count-sample-bytes.ts';
import { countElements, numberOf, readAll, textOf } from '../base/data-tree.ts';
import type { DataArray, DataGroup, Numbers } from '../base/data-tree.ts';
import { checkLengths } from '../base/check-lengths.ts';
import { corruptFile, unsupportedFile } from '../base/file-problem.ts';
import type { FormatReader } from '../base/format.ts';
import { listLeft } from '../base/list-left.ts';
import { hostIsLittleEndian, numberTypes } from '../base/number-types.ts';
import type { NumberType } from '../base/number-types.ts';
import { placeVolume } from '../base/place-volume.ts';
import { storeSamples, wholeNumbersOf } from '../base/store-samples.ts';
import { openHdf5 } from '../hdf5/hdf5.ts';
import { countKept } from '../series/keep-volumes.ts';
import { openSeries } from '../series/open-series.ts';
import type { Series } from '../series/open-series.ts';
import { areScans } from '../series/open-volumes.ts';
import { timeAt } from '../series/scan-times.ts';
import type { TimeSteps } from '../series/scan-times.ts';

const what = 'the MINC file';

/** Numbers that are read at once: the reader of HDF5 unpacks a chunk for each part that needs it. */
const partElements = 2 ** 24;

/**
 * Reads a MINC 2 file at its full resolution; several times are scans. The axis that is fastest in the file is i.
 * Sources: "MINC 2.0 File Format Reference", en.wikibooks.org; nibabel 5.4, `minc1.py` and `minc2.py`
 */
export const readMinc: FormatReader = async ({ bytes }, settings, context) => {
  const { onProgress, budget } = context;
  onProgress(0, bytes.length);
  const minc = openHdf5(bytes, budget).group('minc-2.0');
  const folder = minc?.group('image')?.group('0');
  const image = folder?.array('image');
  const axes = minc?.group('dimensions');
  if (!folder || !image || !axes) throw corruptFile(what, 'lacks minc-2.0/image/0/image or its dimensions');
  const { names, volumes } = readAxes(image);
  const [nz, ny, nx] = image.shape.slice(-3);
  const dimensions: Vector3 = [nx, ny, nz];
  const type = readType(image);
  const volumeBytes = countSampleBytes(what, dimensions, type);
  const grid = cartesianGrid(dimensions, readAffine(axes, names));
  const scales = type.read.kind === 'floats' ? [] : readScales(folder, image, volumes);
  const isKept = countKept({ bytes: Math.max(volumeBytes, 4 * nx * ny * nz), count: volumes }, budget) === volumes;
  if (areScans(volumes, type, settings, context) && isKept) {
    const times = readSteps(axes);
    const scans = keepTimes(image, { scales, volumes, type, budget });
    onProgress(bytes.length, bytes.length);
    return placeVolume(
      await openSeries(
        {
          info: { grid, anatomical: true, unit: '', format: 'MINC 2' },
          ...scans,
          count: volumes,
          littleEndian: hostIsLittleEndian,
          timeOf: (index) => timeAt(index, times),
        },
        settings,
        context,
      ),
      settings,
    );
  }
  const numbers = readNumbers(image, { volumes, type, budget, count: nx * ny * nz });
  const scaled = scaleNumbers(numbers, scales[0], { image, budget });
  const { slope, intercept } = scaled;
  const stored = storeSamples(
    new Uint8Array(scaled.numbers.buffer, scaled.numbers.byteOffset, scaled.numbers.byteLength),
    scaled.numbers === numbers ? type : numberTypes.float32,
    hostIsLittleEndian,
    { slope, intercept, budget, chooseWhole: await wholeNumbersOf(type) },
  );
  onProgress(bytes.length, bytes.length);
  return placeVolume(
    {
      grid,
      anatomical: true,
      samples: stored.samples,
      slope: slope * stored.scale,
      intercept: slope * stored.offset + intercept,
      ...(slope === 1 && intercept === 0 ? { indexed: stored.indexed, rounded: stored.rounded } : {}),
      unkept: stored.unkept,
      unit: '',
      format: `MINC 2${volumes > 1 ? `, volume 1 of ${volumes}` : ''}`,
      ...listLeft(volumes),
    },
    settings,
  );
};

/** Names of the last three axes, slowest first, which have to be those of space; before them may be time. */
function readAxes({ shape, attributes }: DataArray): { names: readonly string[]; volumes: number } {
  const order = (textOf(attributes.get('dimorder')) ?? '').split(',').slice(0, shape.length);
  const names = order.slice(-3);
  const isSpace = names.length === 3 && ['xspace', 'yspace', 'zspace'].every((name) => names.includes(name));
  if (!isSpace || shape.length > 4 || order.length !== shape.length)
    throw unsupportedFile(
      what,
      `has the axes "${order.join(',').slice(0, 80)}"; expected xspace, yspace and zspace in any order, with time before them: mincreshape and mincconvert make such a file`,
    );
  checkLengths(what, 'dimensions', shape);
  return { names, volumes: shape.length > 3 ? shape[0] : 1 };
}

function readType({ type }: DataArray): NumberType {
  const found = Object.values(numberTypes).find(({ name }) => name === type);
  if (found && found.read.kind !== 'bigints') return found;
  throw unsupportedFile(
    what,
    `holds values of the type ${type}; expected whole numbers of 8 to 32 bits or floats: mincreshape -float in.mnc out.mnc`,
  );
}

/** The numbers of the first volume. */
function readNumbers(
  image: DataArray,
  { volumes, type, budget, count }: { volumes: number; type: NumberType; budget: Budget; count: number },
): Numbers {
  if (volumes > 1 || image.shape.length > 3 || count <= partElements) {
    const numbers = image.readRows(0, image.shape.length > 3 ? 1 : image.shape[0]);
    budget.take(numbers.byteLength, what);
    return numbers;
  }
  budget.take(count * type.bytesPerSample, what);
  const all = type.read.view(new Uint8Array(count * type.bytesPerSample)) as Numbers;
  const row = count / image.shape[0];
  const rows = Math.max(1, Math.floor(partElements / row));
  for (let k = 0; k < image.shape[0]; k += rows)
    all.set(image.readRows(k, Math.min(rows, image.shape[0] - k)), k * row);
  return all;
}

/** Value = slope * number + intercept. */
interface Scale {
  readonly slope: number;
  readonly intercept: number;
}

/** The range of numbers that the scales refer to. */
function readValidRange(image: DataArray): [number, number] {
  const range = image.attributes.get('valid_range');
  const bits = Number(/\d+$/.exec(image.type)?.[0] ?? 8);
  const isSigned = image.type.startsWith('int');
  const all: [number, number] = isSigned ? [-(2 ** (bits - 1)), 2 ** (bits - 1) - 1] : [0, 2 ** bits - 1];
  if (!(range instanceof Float64Array) || range.length < 2) return all;
  const [low, high] = range;
  return low < high && low >= all[0] && high <= all[1] ? [low, high] : all;
}

/** Of each volume the scales of its equal parts, in their order: of the whole, of each slice, or of each row. */
function readScales(folder: DataGroup, image: DataArray, volumes: number): Scale[][] {
  const [maxima, minima] = ['image-max', 'image-min'].map((name) => folder.array(name));
  if (!maxima || !minima) return [];
  const { shape } = maxima;
  const isPart = shape.length < image.shape.length && shape.every((n, axis) => n === image.shape[axis]);
  if (!isPart || String(shape) !== String(minima.shape))
    throw corruptFile(
      what,
      `has image-max of ${shape.join(' x ') || 'one'} and image-min of ${minima.shape.join(' x ') || 'one'} numbers; expected the first lengths of ${image.shape.join(' x ')}`,
    );
  const [high, low] = [readAll(maxima), readAll(minima)];
  const [from, to] = readValidRange(image);
  const isEach = image.shape.length > 3 && shape.length > 0;
  const count = countElements(shape) / (isEach ? volumes : 1);
  const scaleAt = (i: number): Scale => {
    const slope = (high[i] - low[i]) / (to - from);
    const intercept = low[i] - from * slope;
    if (!Number.isFinite(slope) || !Number.isFinite(intercept))
      throw corruptFile(what, `got image-max ${high[i]} and image-min ${low[i]}; expected finite numbers`);
    return { slope, intercept };
  };
  return Array.from({ length: volumes }, (_, volume) =>
    Array.from({ length: count }, (_, i) => scaleAt((isEach ? volume * count : 0) + i)),
  );
}

/** Whether all parts have one scale; a slope of 0 makes one value of all numbers. */
const areOne = ([first, ...others]: readonly Scale[]): boolean =>
  first.slope !== 0 && others.every(({ slope, intercept }) => slope === first.slope && intercept === first.intercept);

interface TimesOfImage {
  readonly scales: readonly (readonly Scale[])[];
  readonly volumes: number;
  readonly type: NumberType;
  readonly budget: Budget;
}

/** The numbers of all volumes, kept by the browser: where the parts of one have several scales, all are floats. */
function keepTimes(
  image: DataArray,
  { scales, volumes, type, budget }: TimesOfImage,
): Pick<Series, 'volumes' | 'type' | 'scaleOf'> {
  const isFloat = scales.some((parts) => !areOne(parts));
  const kept = Array.from({ length: volumes }, (_, volume) => {
    const numbers = image.readRows(volume, 1);
    budget.take((isFloat ? 4 : type.bytesPerSample) * numbers.length, what);
    const scaled = scaleNumbers(numbers, scales[volume], { image, budget: null, isFloat });
    const { buffer, byteOffset, byteLength } = scaled.numbers;
    return { ...scaled, blob: new Blob([new Uint8Array(buffer, byteOffset, byteLength)]) };
  });
  return {
    volumes: kept.map(({ blob }) => blob),
    type: isFloat ? 'float32' : type.name,
    scaleOf: (index) => ({ slope: kept[index].slope, intercept: kept[index].intercept }),
  };
}

/** Times of the volumes; null where the file does not say them, or they are uneven. */
function readSteps(axes: DataGroup): TimeSteps | null {
  const attributes = axes.array('time')?.attributes ?? axes.group('time')?.attributes;
  if (!attributes || textOf(attributes.get('spacing')) === 'irregular') return null;
  const step = numberOf(attributes.get('step')) ?? NaN;
  const first = numberOf(attributes.get('start')) ?? 0;
  const unit = textOf(attributes.get('units'))?.trim() || 's';
  const per = /^(ms|msec|milliseconds?)$/i.test(unit) ? 1e3 : /^s(ec(onds?)?)?$/i.test(unit) ? 1 : 0;
  return per && step > 0 && Number.isFinite(first) ? { first: first / per, step: step / per, unit: 's' } : null;
}

/**
 * Scales numbers in place of storing them where the parts differ. Numbers outside of the valid range are moved to its ends, as nibabel does.
 * @param budget - null where the memory is taken already @param isFloat - whether the result has to be floats
 */
function scaleNumbers(
  numbers: Numbers,
  scales: readonly Scale[] | undefined,
  { image, budget, isFloat = false }: { image: DataArray; budget: Budget | null; isFloat?: boolean },
): Scale & { readonly numbers: Numbers } {
  if (!scales) return { numbers, slope: 1, intercept: 0 };
  const [from, to] = readValidRange(image);
  const [{ slope, intercept }] = scales;
  if (areOne(scales) && !isFloat) {
    for (let i = 0; i < numbers.length; i++) numbers[i] = Math.min(to, Math.max(from, numbers[i]));
    return { numbers, slope, intercept };
  }
  budget?.take(4 * numbers.length, what);
  const values = new Float32Array(numbers.length);
  const part = numbers.length / scales.length;
  scales.forEach((scale, index) => {
    for (let i = index * part; i < (index + 1) * part; i++)
      values[i] = scale.slope * Math.min(to, Math.max(from, numbers[i])) + scale.intercept;
  });
  return { numbers: values, slope: 1, intercept: 0 };
}

/**
 * Index to world: MINC's world is x to the right, y to the front, z to the head. Each axis has a direction, a step and a
 * start along its direction.
 */
function readAffine(axes: DataGroup, names: readonly string[]): Matrix4 {
  const usual: Readonly<Record<string, Vector3>> = { xspace: [1, 0, 0], yspace: [0, 1, 0], zspace: [0, 0, 1] };
  // i is the fastest axis, the last one in the file.
  const read = names.map((name) => {
    const attributes = axes.array(name)?.attributes ?? axes.group(name)?.attributes ?? new Map<string, never>();
    if (textOf(attributes.get('spacing')) === 'irregular')
      throw unsupportedFile(
        what,
        `has slices at uneven distances along ${name}; expected even ones: mincresample makes such a file`,
      );
    const cosines = attributes.get('direction_cosines');
    const direction = cosines instanceof Float64Array && cosines.length === 3 ? cosines : usual[name];
    return {
      direction,
      step: numberOf(attributes.get('step')) ?? 1,
      start: numberOf(attributes.get('start')) ?? 0,
    };
  });
  const [k, j, i] = read;
  const rows = [0, 1, 2].flatMap((row) => [
    ...[i, j, k].map(({ direction, step }) => direction[row] * step),
    read.reduce((sum, { direction, start }) => sum + direction[row] * start, 0),
  ]);
  const affine = [...rows, 0, 0, 0, 1];
  if (affine.every(Number.isFinite) && invertAffine(affine)) return affine;
  throw corruptFile(
    what,
    `got the steps ${read.map(({ step }) => step).join(', ')}; expected lengths other than 0, and directions that do not lie in one plane`,
  );
}
