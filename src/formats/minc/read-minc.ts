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

const what = 'the MINC file';

/** Numbers that are read at once: the reader of HDF5 unpacks a chunk for each part that needs it. */
const partElements = 2 ** 24;

/**
 * Reads a MINC 2 file at its full resolution: of a series, the first volume. The axis that is fastest in the file is i.
 * Sources: "MINC 2.0 File Format Reference", en.wikibooks.org; nibabel 5.4, `minc1.py` and `minc2.py`
 */
export const readMinc: FormatReader = async ({ bytes }, settings, { onProgress, budget }) => {
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
  countSampleBytes(what, dimensions, type);
  const indexToWorld = readAffine(axes, names);
  const numbers = readNumbers(image, { volumes, type, budget, count: nx * ny * nz });
  const scales = type.read.kind === 'floats' ? [] : readScales(folder, image, volumes);
  const scaled = scaleNumbers(numbers, scales, { image, budget });
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
      grid: cartesianGrid(dimensions, indexToWorld),
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

/** Scales of equal parts of the first volume, in their order: of the whole, of each slice, or of each row. */
function readScales(folder: DataGroup, image: DataArray, volumes: number): Scale[] {
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
  const count = countElements(shape) / (image.shape.length > 3 && shape.length > 0 ? volumes : 1);
  return Array.from({ length: count }, (_, i) => {
    const slope = (high[i] - low[i]) / (to - from);
    const intercept = low[i] - from * slope;
    if (!Number.isFinite(slope) || !Number.isFinite(intercept))
      throw corruptFile(what, `got image-max ${high[i]} and image-min ${low[i]}; expected finite numbers`);
    return { slope, intercept };
  });
}

/** Scales numbers in place of storing them where the parts differ. Numbers outside of the valid range are moved to its ends, as nibabel does. */
function scaleNumbers(
  numbers: Numbers,
  scales: readonly Scale[],
  { image, budget }: { image: DataArray; budget: Budget },
): Scale & { readonly numbers: Numbers } {
  if (scales.length === 0) return { numbers, slope: 1, intercept: 0 };
  const [from, to] = readValidRange(image);
  const [{ slope, intercept }] = scales;
  const isOne = scales.every((scale) => scale.slope === slope && scale.intercept === intercept) && slope !== 0;
  if (isOne) {
    for (let i = 0; i < numbers.length; i++) numbers[i] = Math.min(to, Math.max(from, numbers[i]));
    return { numbers, slope, intercept };
  }
  budget.take(4 * numbers.length, what);
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
