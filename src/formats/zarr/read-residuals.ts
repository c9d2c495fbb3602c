// What volume-view-prepare writes next to a pyramid: how far its levels are from the finest one. See docs/guide/prepare.md
import type { LevelResiduals, ResidualTable } from '../../bricks/residuals.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import { Budget } from '../base/budget.ts';
import { corruptFile } from '../base/file-problem.ts';
import type { ZarrBrickLevel } from './brick-levels.ts';
import type { Scaling } from './brick-numbers.ts';
import type { FileTree } from './file-tree.ts';
import type { OmeImage } from './open-image.ts';
import { readBoxes } from './read-box.ts';
import { numbersOf, objectOf, readJson } from './read-json.ts';
import { readArray } from './zarr-array.ts';

const what = 'what the OME-Zarr says of the detail in its levels';

/** The group, next to the levels. */
const group = 'volume-view';

/** Bytes of the whole table. */
const maxBytes = 2 ** 26;

/** Voxels of a block along each axis. */
const [shortest, longest] = [4, 1024];

/** How much larger than the largest difference the root of the mean square may be, as both are rounded. */
const rounding = 1 + 1e-5;

interface ResidualReading {
  readonly image: OmeImage;
  /** Those of the store. */
  readonly levels: readonly ZarrBrickLevel[];
  /** Of the store's samples. */
  readonly numbers: Scaling;
  readonly deviceBytes?: number;
  readonly signal: AbortSignal;
}

/**
 * Reads the table of a pyramid.
 * @returns in stored values of the store, with its levels; null where the pyramid has none, or more than 64 MiB
 * @throws {VolumeViewError} `format/corrupt` for what can not be true, `format/unsupported`, `source/…`
 */
export async function readResiduals(
  tree: Pick<FileTree, 'read'>,
  { image, levels, numbers: { slope, intercept }, deviceBytes, signal }: ResidualReading,
): Promise<ResidualTable | null> {
  const opening = { budget: new Budget(deviceBytes), signal };
  const { axes, levels: all } = image;
  if (String(axes.space) !== '2,1,0' || axes.count !== 3) return null;
  const { attributes } = (await readJson(tree, `${group}/zarr.json`, opening)) ?? {};
  const { version, block, levels: count, along } = objectOf(objectOf(attributes)[group]);
  if (version !== 1) return null;
  const side = numbersOf(block)?.[0] ?? NaN;
  const isBlock =
    Number.isInteger(side) && side >= shortest && side <= longest && String(block) === `${side},${side},${side}`;
  if (!isBlock || count !== all.length)
    throw corruptFile(
      what,
      `is of other blocks or of other levels; expected the same number along each axis, ${shortest} to ${longest}, and ${all.length} levels`,
    );
  const blocks = all[0].dimensions.map((n) => Math.ceil(n / side)) as unknown as Vector3;
  const total = blocks[0] * blocks[1] * blocks[2];
  // Views of such a pyramid learn from the bricks that come, as of one without a table.
  if (4 * total * 2 * levels.length > maxBytes) return null;
  const read = (name: string): Promise<Float32Array<ArrayBuffer>> => readNumbers(tree, name, blocks, opening);
  const low = await read('min');
  const high = await read('max');
  for (const [n, value] of low.entries()) {
    const hasNone = Number.isNaN(value) && Number.isNaN(high[n]);
    if (!hasNone && !(value <= high[n] && Number.isFinite(high[n] - value))) throw refuseNumber('min', value);
    low[n] = hasNone ? Infinity : (value - intercept) / slope;
    high[n] = hasNone ? -Infinity : (high[n] - intercept) / slope;
  }
  const none: LevelResiduals = { max: new Float32Array(total), rms: new Float32Array(total) };
  const found: LevelResiduals[] = [];
  for (const { number } of levels) {
    if (number === 0) {
      found.push(none);
      continue;
    }
    const [max, rms] = [await read(`residual-max-${number}`), await read(`residual-rms-${number}`)];
    for (const [n, value] of max.entries()) {
      if (!(value >= 0 && value < Infinity)) throw refuseNumber(`residual-max-${number}`, value);
      if (!(rms[n] >= 0 && rms[n] <= value * rounding)) throw refuseNumber(`residual-rms-${number}`, rms[n]);
      max[n] /= slope;
      rms[n] /= slope;
    }
    found.push({ max, rms });
  }
  return { side, blocks, low, high, levels: found, along: readAlong(along, all.length, levels) };
}

/** By level of the store: how far residuals go together. Undefined where the writer did not measure it. */
function readAlong(along: unknown, count: number, levels: readonly ZarrBrickLevel[]): readonly number[] | undefined {
  if (along === undefined) return undefined;
  const numbers = numbersOf(along);
  if (numbers?.length !== count || !numbers.every((one) => one >= 0 && one <= 1))
    throw corruptFile(what, `has other numbers in "along"; expected ${count} from 0 to 1`);
  return levels.map(({ number }) => numbers[number]);
}

/** An array of one number a block, i fastest. */
async function readNumbers(
  tree: Pick<FileTree, 'read'>,
  name: string,
  blocks: Vector3,
  opening: { readonly budget: Budget; readonly signal: AbortSignal },
): Promise<Float32Array<ArrayBuffer>> {
  const path = `${group}/${name}/`;
  const metadata = await readJson(tree, `${path}zarr.json`, opening);
  if (!metadata) throw corruptFile(what, `lacks the array ${name}`);
  const array = readArray(metadata, path, `${what} (${name})`);
  const shape = [blocks[2], blocks[1], blocks[0]];
  if (array.type.name !== 'float32' || !array.littleEndian || String(array.shape) !== String(shape))
    throw corruptFile(
      what,
      `has an array ${name} of ${array.shape.join(' x ')} ${array.type.name}; expected ${shape.join(' x ')} float32`,
    );
  const box = { axes: [2, 1, 0], first: [0, 0, 0], dimensions: blocks, at: [0, 0, 0] } as const;
  const [bytes] = await readBoxes(tree, array, [box], { ...opening, onProgress: () => undefined });
  return new Float32Array(bytes.buffer);
}

function refuseNumber(name: string, value: number): Error {
  return corruptFile(
    what,
    `has the number ${value} in ${name}; expected differences from 0, no mean of which is above the largest, and no smallest value above a largest one`,
  );
}
