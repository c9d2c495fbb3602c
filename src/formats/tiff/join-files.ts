// Several files that are one volume: what each says of its numbers counts for its own.
import type { Budget } from '../base/budget.ts';
import { corruptFile } from '../base/file-problem.ts';
import { joinPieces } from '../base/join-pieces.ts';
import { numberTypes } from '../base/number-types.ts';
import type { NumberType } from '../base/number-types.ts';
import type { TiffLayout, ValueScale } from './layout.ts';
import type { TiffStack } from './open-tiff.ts';

/** Numbers that are values. */
export const plain: ValueScale = { slope: 1, intercept: 0, unit: '' };

const scaleOf = ({ layout }: TiffStack): ValueScale => layout.scale ?? plain;

/** @throws {VolumeViewError} `format/corrupt` */
export function checkLike(first: TiffStack, next: TiffStack, name: string): void {
  const describe = (stack: TiffStack): string => {
    const { columns, rows, type } = stack.page;
    const { unit } = scaleOf(stack);
    return `${columns} x ${rows} pixels of ${type.name}${unit && ` in ${unit}`}`;
  };
  const [expected, got] = [first, next].map(describe);
  if (expected !== got)
    throw corruptFile(
      'the stack',
      `got ${name} of ${got}; expected ${expected} as in the first file: the slices of a volume are alike`,
    );
  if (!hasSpacingOf(first, next))
    first.use.left.add('sizes of voxels of files that differ from those of the first one');
}

/** Files round lengths: less than this share is no difference. */
const nearly = 1e-3;

function hasSpacingOf({ layout: { spacing: own } }: TiffStack, { layout: { spacing: other } }: TiffStack): boolean {
  if (!own || !other) return own === other;
  return own.every((length, axis) => Math.abs(length - other[axis]) <= nearly * length);
}

/** What all files say of their numbers together. */
export interface JoinedScale extends Pick<TiffLayout, 'scale' | 'window'> {
  /** Of the numbers that are joined. */
  readonly type: NumberType;
  /** Numbers of a file, ready to be joined. */
  prepare(stack: TiffStack, bytes: Uint8Array<ArrayBuffer>): Uint8Array<ArrayBuffer>;
}

/**
 * Numbers of files with different scales become values, as floats of 32 bits: ImageJ has them so, too (ij/measure/Calibration, getCTable).
 * The window has those of all files.
 */
export function joinScales(stacks: readonly TiffStack[], budget: Budget): JoinedScale {
  const [first] = stacks;
  const { slope, intercept, unit } = scaleOf(first);
  const windows = stacks.flatMap(({ layout }) => (layout.window ? [layout.window] : []));
  const window =
    windows.length === stacks.length
      ? ([
          windows.reduce((low, one) => Math.min(low, one[0]), Infinity),
          windows.reduce((high, one) => Math.max(high, one[1]), -Infinity),
        ] as const)
      : undefined;
  const isOne = stacks.every((one) => scaleOf(one).slope === slope && scaleOf(one).intercept === intercept);
  if (isOne) return { type: first.page.type, scale: first.layout.scale, window, prepare: (_, bytes) => bytes };
  return {
    type: numberTypes.float32,
    scale: { ...plain, unit },
    window,
    prepare(stack, bytes) {
      const own = scaleOf(stack);
      budget.take((4 * bytes.length) / stack.page.type.bytesPerSample, 'the stack of TIFF files');
      const numbers = stack.page.type.read.view(bytes) as ArrayLike<number>;
      const values = Float32Array.from(numbers, (number) => own.slope * number + own.intercept);
      budget.giveBack(bytes.length);
      return new Uint8Array(values.buffer);
    },
  };
}

/** @param parts - whose bytes are taken from the budget; one part is returned as it is */
export function joinParts(parts: readonly Uint8Array<ArrayBuffer>[], budget: Budget): Uint8Array<ArrayBuffer> {
  if (parts.length === 1) return parts[0];
  const length = parts.reduce((sum, part) => sum + part.length, 0);
  budget.take(length, 'the stack of TIFF files');
  const all = joinPieces(parts);
  budget.giveBack(length);
  return all;
}
