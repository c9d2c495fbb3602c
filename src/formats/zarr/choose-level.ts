import { spacingOf } from '../../volume/grid.ts';
import { chooseReduction } from '../../volume/reduce.ts';
import type { DeviceLimits } from '../../volume/reduce.ts';
import type { Matrix4, Vector3 } from '../../volume/matrix.ts';
import { isSingleSlice } from '../../volume/volume.ts';
import type { NumberType } from '../base/number-types.ts';
import { countChunks } from './list-chunks.ts';
import type { ArrayBox } from './list-chunks.ts';
import type { OmeAxes } from './ome-axes.ts';
import { worldOf } from './ome-levels.ts';
import type { OmeLevel } from './ome-levels.ts';

export type { ArrayBox } from './list-chunks.ts';

/** Chunks that are asked for of one level, and bytes that are unpacked for it. */
const [maxChunks, maxUnpacked] = [2 ** 16, 2 ** 33];

/** Lengths that differ by less than this factor are the same. */
const nearly = 1.01;

/** The voxels of a level that a region needs. */
export interface LevelBox {
  readonly level: OmeLevel;
  readonly first: Vector3;
  readonly dimensions: Vector3;
}

/**
 * The voxels of a level inside a region, and one more at each side, between which values are.
 * @param region - x, y and z of two opposite corners, world; null for all @returns null where the region holds nothing of it
 */
export function cutLevel(level: OmeLevel, axes: OmeAxes, region: readonly number[] | null): LevelBox | null {
  if (!region) return { level, first: [0, 0, 0], dimensions: level.dimensions };
  const world = worldOf(level, axes);
  const spans = [0, 1, 2].map((i) => {
    const n = level.dimensions[i];
    const places = [region[i], region[i + 3]].map((end) => (end - world[4 * i + 3]) / world[4 * i + i]);
    return [Math.max(0, Math.floor(Math.min(...places))), Math.min(n, Math.ceil(Math.max(...places)) + 1)];
  });
  if (!spans.every(([from, to]) => to > from)) return null;
  return {
    level,
    first: spans.map(([from]) => from) as unknown as Vector3,
    dimensions: spans.map(([from, to]) => to - from) as unknown as Vector3,
  };
}

/** The world of a box of a level. */
export function worldOfBox({ level, first }: LevelBox, axes: OmeAxes): Matrix4 {
  const world = worldOf(level, axes);
  return world.map((one, at) =>
    at % 4 === 3 && at < 12 ? one + first[(at - 3) / 4] * world[5 * ((at - 3) / 4)] : one,
  );
}

/**
 * The finest level that a device holds, which is not so many chunks that it would take forever.
 * @param boxes - of the levels, the finest first @param arrayBox - what is read of a level's array
 * @returns the coarsest one where none fits: it will be made smaller
 */
export function chooseLevel(
  boxes: readonly LevelBox[],
  arrayBox: (box: LevelBox) => ArrayBox,
  limits: DeviceLimits,
  axes: OmeAxes,
): LevelBox {
  const fits = (box: LevelBox): boolean =>
    isReadable(box, arrayBox(box)) &&
    Math.max(...box.dimensions) <= limits.maxVoxelsPerAxis &&
    countVoxels(box) * storedBytes(box.level.array.type) <= limits.maxBytes &&
    (limits.maxAtlasSize === null ||
      chooseReduction(
        { dimensions: box.dimensions, indexToWorld: worldOfBox(box, axes), samples: new Uint8Array(0) },
        limits,
      ).every((factor) => factor === 1));
  return boxes.find(fits) ?? boxes[boxes.length - 1];
}

/** The shortest side of a level's voxels, world units. */
export const detailOf = ({ level }: LevelBox, axes: OmeAxes): number => Math.min(...spacingOf(worldOf(level, axes)));

/** The levels from the coarsest one on whose voxels are no longer than wanted; all of them where none is so fine. */
export function coarseEnough(boxes: readonly LevelBox[], detail: number, axes: OmeAxes): readonly LevelBox[] {
  const isFine = boxes.map((box) => detailOf(box, axes) <= nearly * detail);
  return boxes.slice(Math.max(0, isFine.lastIndexOf(true)));
}

export const countVoxels = ({ dimensions: [nx, ny, nz] }: { readonly dimensions: Vector3 }): number => nx * ny * nz;

/** Bytes of a voxel once it is read: floats of any size become floats of 32 bits. */
export const storedBytes = ({ bytesPerSample, read }: NumberType): number =>
  read.kind === 'floats' ? 4 : Math.min(4, bytesPerSample);

/** Whether the chunks of a box are few enough. */
export function isReadable({ level }: LevelBox, box: ArrayBox): boolean {
  const { array } = level;
  const chunks = countChunks(array, box);
  return (
    chunks <= maxChunks &&
    chunks * array.chunk.reduce((product, n) => product * n, array.type.bytesPerSample) <= maxUnpacked
  );
}

export const isOneSlice = ({ dimensions }: LevelBox): boolean => isSingleSlice({ kind: 'cartesian', dimensions });
