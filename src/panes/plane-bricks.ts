// Which bricks of a pyramid a plane or a slab needs.
import { brickSide } from '../bricks/brick-data.ts';
import type { Brick } from '../bricks/pyramid.ts';
import type { FinerLevel, ViewedPlane } from '../volume/finer-voxels.ts';
import type { GridFrame } from '../volume/grid.ts';
import { add, cross, invertAffine, length, scale, transformDirection, transformPoint } from '../volume/matrix.ts';
import type { Matrix4, Vector3 } from '../volume/matrix.ts';

/** A level as a plane reads it. */
export interface LevelOfPlane {
  readonly level: number;
  readonly worldToIndex: Matrix4;
  /** Those that the plane goes through, and perhaps a few next to them: the nearest to its middle first. */
  readonly bricks: readonly Brick[];
}

/** A pixel may be so many voxels wide, and one voxel is still fine enough for it. */
const enough = 1 - 1e-6;

/**
 * The coarsest level whose voxels are no larger than the pixels; or, where that needs more bricks than there is room for, the finest one that does not.
 * @param levels - finest first @param coarse - the volume, which is always there @param most - bricks
 * @returns null where the volume itself is fine enough, or no level has room
 */
export function chooseLevelOfPlane(
  levels: readonly FinerLevel[],
  coarse: GridFrame,
  plane: ViewedPlane,
  most: number,
): LevelOfPlane | null {
  if (isFine(coarse, plane)) return null;
  let wanted = levels.length - 1;
  while (wanted > 0 && !isFine(levels[wanted], plane)) wanted--;
  for (let level = wanted; level < levels.length; level++) {
    const worldToIndex = invertAffine(levels[level].indexToWorld)!; // It exists: the bricks lie over the volume by it.
    const bricks = listBricksOfPlane(levels[level], worldToIndex, plane, most);
    if (bricks) return { level, worldToIndex, bricks: bricks.map((at) => ({ level, at })) };
  }
  return null;
}

/** Whether a level has a voxel for each pixel. */
function isFine({ indexToWorld }: GridFrame, { across, down }: ViewedPlane): boolean {
  const worldToIndex = invertAffine(indexToWorld)!;
  return [across, down].every((step) => length(transformDirection(worldToIndex, step)) >= enough);
}

/** @returns null for more than `most` */
function listBricksOfPlane(
  { bricks }: FinerLevel,
  worldToIndex: Matrix4,
  { first, across, down, way, width, height }: ViewedPlane,
  most: number,
): Vector3[] | null {
  // Places in voxels from the outer face of the first one. A pixel is one from its middle to the next; nothing is painted beyond the middles of the outermost.
  const start = add(transformPoint(worldToIndex, first), [0.5, 0.5, 0.5]);
  const sides = [scale(across, width - 1), scale(down, height - 1), way].map((side) =>
    transformDirection(worldToIndex, side),
  );
  const origin = add(start, scale(sides[2], -0.5));
  const middle = sides.reduce((sum, side) => add(sum, scale(side, 0.5)), origin);
  // A side without a length gets a direction, so that the three span space: places are 0 along it.
  const spans = spanSpace(sides);
  const toShares = invertAffine([
    ...[0, 1, 2].flatMap((axis) => [...spans.map((span) => span[axis]), origin[axis]]),
    ...[0, 0, 0, 1],
  ]);
  if (!toShares) return [];
  const ends = spans.map((_, n) => (length(sides[n]) > 0 ? 1 : 0));
  const [low, high] = [Math.min, Math.max].map((pick) =>
    origin.map((x, axis) => x + sides.reduce((sum, side) => sum + pick(0, side[axis]), 0)),
  );
  const from = low.map((x, axis) => Math.min(bricks[axis], Math.max(0, Math.floor(x / brickSide))));
  const to = high.map((x, axis) => Math.min(bricks[axis] - 1, Math.max(-1, Math.floor(x / brickSide))));
  const half = brickSide / 2;
  const found: Vector3[] = [];
  for (let k = from[2]; k <= to[2]; k++)
    for (let j = from[1]; j <= to[1]; j++)
      for (let i = from[0]; i <= to[0]; i++) {
        const center: Vector3 = [(i + 0.5) * brickSide, (j + 0.5) * brickSide, (k + 0.5) * brickSide];
        const shares = transformPoint(toShares, center);
        const isMet = shares.every((share, n) => {
          const reach =
            half * (Math.abs(toShares[4 * n]) + Math.abs(toShares[4 * n + 1]) + Math.abs(toShares[4 * n + 2]));
          return share + reach >= 0 && share - reach <= ends[n];
        });
        if (!isMet) continue;
        if (found.length >= most) return null;
        found.push([i, j, k]);
      }
  const away = ([i, j, k]: Vector3): number =>
    Math.hypot((i + 0.5) * brickSide - middle[0], (j + 0.5) * brickSide - middle[1], (k + 0.5) * brickSide - middle[2]);
  found.sort((a, b) => away(a) - away(b));
  return found;
}

/** The same directions, where those without a length are orthogonal to the others. */
function spanSpace(sides: readonly Vector3[]): readonly Vector3[] {
  const spans = [...sides];
  const has = (n: number): boolean => length(spans[n]) > 0;
  const axes: readonly Vector3[] = [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ];
  for (const n of [0, 1, 2]) {
    if (has(n)) continue;
    const others = [0, 1, 2].filter((other) => other !== n && has(other));
    const [a, b] = others.map((other) => spans[other]);
    const along = a && b ? [cross(a, b)] : axes.map((axis) => (a ? cross(a, axis) : axis));
    spans[n] = along.reduce((best, one) => (length(one) > length(best) ? one : best));
  }
  return spans;
}
