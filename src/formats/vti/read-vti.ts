import { cartesianGrid } from '../../volume/grid.ts';
import { invertAffine } from '../../volume/matrix.ts';
import type { Matrix4, Vector3 } from '../../volume/matrix.ts';
import { countSampleBytes } from '../base/count-sample-bytes.ts';
import { corruptFile, unsupportedFile } from '../base/file-problem.ts';
import type { FormatReader } from '../base/format.ts';
import { listLeft } from '../base/list-left.ts';
import { hostIsLittleEndian, numberTypes } from '../base/number-types.ts';
import type { NumberType } from '../base/number-types.ts';
import { placeVolume } from '../base/place-volume.ts';
import { storeSamples, wholeNumbersOf } from '../base/store-samples.ts';
import { isLittleEndian, readVtiNumbers } from './vti-data.ts';
import { readVtiDocument } from './vti-document.ts';
import type { VtiArray, VtiDocument } from './vti-document.ts';

const what = 'the VTI file';

/**
 * Reads VTK's image data: of several arrays the one that the file calls its scalars, else the first with one number for
 * each point or cell.
 */
export const readVti: FormatReader = async ({ bytes }, settings, { onProgress, budget }) => {
  onProgress(0, bytes.length);
  // The text of the XML, of one or two bytes for each character.
  budget.take(bytes.length, what);
  const document = readVtiDocument(bytes);
  const array = chooseArray(document);
  const { first, points } = readExtent(document);
  const isCells = array.at === 'cells';
  const dimensions = points.map((n) => (isCells ? n - 1 : n)) as unknown as Vector3;
  if (!dimensions.every((n) => n >= 1))
    throw corruptFile(what, `got ${points.join(' x ')} points; expected two or more along each axis for data of cells`);
  const type = readType(array);
  countSampleBytes(what, dimensions, type);
  const count = dimensions.reduce((product, n) => product * n, 1);
  const indexToWorld = readAffine(document, first, isCells ? 0.5 : 0);
  const numbers = await readVtiNumbers(array, document, { type, count, budget });
  const isText = (array.attributes.get('format') ?? 'ascii') === 'ascii';
  const littleEndian = isText ? hostIsLittleEndian : isLittleEndian(document.file);
  const { samples, scale, offset, indexed, rounded, unkept } = storeSamples(numbers, type, littleEndian, {
    slope: 1,
    intercept: 0,
    budget,
    chooseWhole: await wholeNumbersOf(type),
  });
  onProgress(bytes.length, bytes.length);
  const others = document.arrays.filter((one) => one !== array).map(({ name }) => `"${name.slice(0, 40)}"`);
  return placeVolume(
    {
      grid: cartesianGrid(dimensions, indexToWorld),
      samples,
      slope: scale,
      intercept: offset,
      indexed,
      rounded,
      unkept,
      unit: '',
      format: 'VTI',
      ...listLeft(
        1,
        others.length > 0
          ? `the array${others.length > 1 ? 's' : ''} ${others.slice(0, 10).join(', ')}${others.length > 10 ? ' …' : ''}; "${array.name.slice(0, 40)}" is shown`
          : null,
      ),
    },
    settings,
  );
};

function chooseArray({ arrays, scalars }: VtiDocument): VtiArray {
  const single = arrays.filter(({ components }) => components === 1);
  const chosen =
    single.find(({ name }) => scalars.includes(name)) ?? single.find(({ at }) => at === 'points') ?? single[0];
  if (chosen) return chosen;
  throw arrays.length > 0
    ? unsupportedFile(
        what,
        `has only arrays of several numbers for each point, such as "${arrays[0].name.slice(0, 40)}" of ${arrays[0].components}; expected one number. In ParaView, the filter Calculator makes one (such as mag(${arrays[0].name.slice(0, 40)}))`,
      )
    : corruptFile(what, 'has no array of point data or cell data; expected one');
}

function readNumbers(attributes: ReadonlyMap<string, string>, name: string, fallback: readonly number[]): number[] {
  const text = attributes.get(name)?.trim();
  if (!text) return [...fallback];
  const numbers = text.slice(0, 4096).split(/\s+/).map(Number);
  if (numbers.length === fallback.length && numbers.every(Number.isFinite)) return numbers;
  throw corruptFile(what, `got ${name} "${text.slice(0, 80)}"; expected ${fallback.length} numbers`);
}

/** The index of the first point, and the number of points along each axis. */
function readExtent({ image, piece }: VtiDocument): { first: Vector3; points: Vector3 } {
  const whole = readNumbers(image, 'WholeExtent', [0, -1, 0, -1, 0, -1]);
  const [x1, x2, y1, y2, z1, z2] = readNumbers(piece, 'Extent', whole);
  const points: Vector3 = [x2 - x1 + 1, y2 - y1 + 1, z2 - z1 + 1];
  if (points.every((n) => Number.isSafeInteger(n) && n >= 1)) return { first: [x1, y1, z1], points };
  throw corruptFile(
    what,
    `got the Extent ${[x1, x2, y1, y2, z1, z2].join(' ')}; expected whole numbers, the second of each pair not below the first`,
  );
}

const types = new Map<string, NumberType>(Object.values(numberTypes).map((type) => [type.name, type]));

function readType({ attributes, name }: VtiArray): NumberType {
  const said = attributes.get('type') ?? '';
  const type = types.get(said.toLowerCase());
  if (type) return type;
  throw unsupportedFile(
    what,
    `has the array "${name.slice(0, 40)}" of the type "${said.slice(0, 40)}"; expected one of ${[...types.values()].map((one) => one.name).join(', ')}`,
  );
}

/**
 * Index to world. The world is VTK's own: x, y and z are taken as they are. The index counts from the first point of the
 * extent; a cell's value lies in its middle.
 */
function readAffine({ image }: VtiDocument, first: Vector3, shift: number): Matrix4 {
  const origin = readNumbers(image, 'Origin', [0, 0, 0]);
  const spacing = readNumbers(image, 'Spacing', [1, 1, 1]);
  const direction = readNumbers(image, 'Direction', [1, 0, 0, 0, 1, 0, 0, 0, 1]);
  const rows = [0, 1, 2].flatMap((row) => {
    const steps = spacing.map((step, axis) => step * direction[3 * row + axis]);
    return [...steps, steps.reduce((sum, step, axis) => sum + step * (first[axis] + shift), origin[row])];
  });
  const affine = [...rows, 0, 0, 0, 1];
  if (affine.every(Number.isFinite) && invertAffine(affine)) return affine;
  throw corruptFile(
    what,
    `got the Spacing ${spacing.join(' ')} and the Direction ${direction.join(' ')}; expected lengths other than 0, and directions that do not lie in one plane`,
  );
}
