import type { Matrix4, Vector3 } from '../../volume/matrix.ts';
import { corruptFile, unsupportedFile } from '../base/file-problem.ts';
import type { OmeAxes } from './ome-axes.ts';
import { isObject, listOf, numbersOf, shownWord } from './read-json.ts';
import type { Json } from './read-json.ts';
import type { ZarrArray } from './zarr-array.ts';

/** The place of numbers along each axis of an array: scale * index + translation. */
export interface AxisPlaces {
  readonly scale: readonly number[];
  readonly translation: readonly number[];
}

/** A level of a pyramid. */
export interface OmeLevel extends AxisPlaces {
  readonly array: ZarrArray;
  /** Voxels along i, j and k. */
  readonly dimensions: Vector3;
}

/**
 * The places that transforms say together, the first one first. Indices are the middles of voxels. Source: OME-Zarr 0.5,
 * "coordinateTransformations" metadata
 * @param lists - of a level, then of the whole multiscale; null where the level has none
 * @throws {VolumeViewError} `format/corrupt`, `format/unsupported`
 */
export function readPlaces(lists: readonly unknown[], count: number, what: string): AxisPlaces | null {
  if (listOf(lists[0]).length === 0) return null;
  let scale = Array.from({ length: count }, () => 1);
  let translation = scale.map(() => 0);
  for (const transform of lists.flatMap(listOf)) {
    const { type, ...rest } = isObject(transform) ? transform : ({} as Json);
    if (type === 'identity') continue;
    if (type !== 'scale' && type !== 'translation')
      throw unsupportedFile(what, `has a transform of the kind ${shownWord(type)}; expected "scale" and "translation"`);
    const numbers = numbersOf(rest[type]);
    if (numbers?.length !== count)
      throw corruptFile(what, `has a ${type} without a number for each of its ${count} axes`);
    if (type === 'scale') {
      scale = scale.map((one, axis) => one * numbers[axis]);
      translation = translation.map((one, axis) => one * numbers[axis]);
    } else translation = translation.map((one, axis) => one + numbers[axis]);
  }
  return { scale, translation };
}

/** Of files that say no places: the outer faces of all levels are at one place, and a voxel of the first one is 1 long. */
export function guessPlaces(shape: readonly number[], first: readonly number[]): AxisPlaces {
  const scale = shape.map((n, axis) => first[axis] / n);
  return { scale, translation: scale.map((one) => (one - 1) / 2) };
}

/** Voxels along i, j and k. */
export function dimensionsOf({ shape }: Pick<ZarrArray, 'shape'>, { space }: OmeAxes): Vector3 {
  return space.map((axis) => (axis === null ? 1 : shape[axis])) as unknown as Vector3;
}

/** Index of a voxel to world: mm, or the unit of the file where it is none of length. */
export function worldOf({ scale, translation }: AxisPlaces, { space, millimetres, signs }: OmeAxes): Matrix4 {
  const factors = space.map((_, i) => (millimetres?.[i] ?? 1) * signs[i]);
  // A single slice is as thick as its pixels are wide.
  const steps = space.map((axis, i) =>
    axis === null ? scale[space[0]] * Math.abs(factors[0]) : scale[axis] * factors[i],
  );
  const starts = space.map((axis, i) => (axis === null ? 0 : translation[axis] * factors[i]));
  return [steps[0], 0, 0, starts[0], 0, steps[1], 0, starts[1], 0, 0, steps[2], starts[2], 0, 0, 0, 1];
}

/**
 * Checks that all levels are of one image: as many times and channels, and the same place, within two voxels.
 * @throws {VolumeViewError} `format/corrupt`
 */
export function checkLevels(levels: readonly OmeLevel[], { space, count }: OmeAxes): void {
  const [finest] = levels;
  for (const [number, level] of levels.entries()) {
    const what = `level ${number} of the OME-Zarr`;
    const { shape, type } = level.array;
    if (shape.length !== count)
      throw corruptFile(what, `has ${shape.length} axes; expected ${count}, as the image says`);
    if (type !== finest.array.type)
      throw corruptFile(what, `holds ${type.name}; expected ${finest.array.type.name}, as level 0`);
    for (let axis = 0; axis < count; axis++) {
      if (!space.includes(axis)) {
        if (shape[axis] !== finest.array.shape[axis])
          throw corruptFile(
            what,
            `has ${shape[axis]} times or channels; expected ${finest.array.shape[axis]}, as level 0`,
          );
        continue;
      }
      const step = level.scale[axis];
      if (!(Number.isFinite(step) && step !== 0))
        throw corruptFile(what, `got the scale ${step}; expected lengths other than 0`);
      const [own, expected] = [level, finest].map(({ scale, translation, array }) => [
        translation[axis] - scale[axis] / 2,
        translation[axis] + scale[axis] * (array.shape[axis] - 0.5),
      ]);
      const isNear = own.every((end, i) => Math.abs(end - expected[i]) <= 2 * Math.abs(step));
      if (!isNear)
        throw corruptFile(
          what,
          `lies from ${shown(own[0])} to ${shown(own[1])} along an axis where level 0 lies from ${shown(expected[0])} to ${shown(expected[1])}: its shape or its scale is wrong`,
        );
    }
  }
}

const shown = (place: number): string => String(Number(place.toPrecision(4)));
