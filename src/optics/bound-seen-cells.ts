import { unitToWorld } from '../volume/grid.ts';
import type { GridFrame } from '../volume/grid.ts';
import { cellSize } from '../volume/cell-size.ts';
import type { Macrocells } from '../volume/macrocells.ts';
import { multiply } from '../volume/matrix.ts';
import type { Matrix4, Vector3 } from '../volume/matrix.ts';

/** Left, bottom, right and top, in device coordinates. */
export type DeviceRectangle = readonly [number, number, number, number];

/** What is nearer to the eye than this share of the farthest corner's distance is cut off: there is nothing in between that counts. */
const minDepth = 1e-6;

/** A corner in clip coordinates. */
type Corner = readonly [x: number, y: number, w: number];

/**
 * The part of a picture in which the seen cells lie: those behind the eye, and beside the picture, are out of sight.
 * @param view - row-major, world to eye; projection - row-major
 * @returns null where none is in sight
 */
export function boundSeenCells(
  { grid, macrocells: { dimensions: cells } }: { readonly grid: GridFrame; readonly macrocells: Pick<Macrocells, 'dimensions'> },
  seen: Uint8Array,
  { view, projection }: { readonly view: Matrix4; readonly projection: Matrix4 },
): DeviceRectangle | null {
  const toClip = multiply(projection, multiply(view, unitToWorld(grid)));
  const least = minDepth * Math.max(...cornersOf([0, 0, 0], [1, 1, 1], toClip).map(([, , w]) => Math.abs(w)));
  const edge = (cell: number, axis: number): number => Math.min(1, (cell * cellSize) / grid.dimensions[axis]);
  const bounds: [number, number, number, number] = [1, 1, -1, -1];
  /** @returns whether only some of a row's cells, from one to another, are in sight and could tell more: then it may be those in between, of which nothing is seen */
  const include = (from: number, to: number, j: number, k: number): boolean => {
    const corners = cornersOf([edge(from, 0), edge(j, 1), edge(k, 2)], [edge(to, 0), edge(j + 1, 1), edge(k + 1, 2)], toClip);
    const isAhead = corners.every(([, , w]) => w >= least);
    const [left, bottom, right, top] = boundPlaces(isAhead ? corners : cutCorners(corners, least));
    if (!(left < 1 && bottom < 1 && right > -1 && top > -1)) return false;
    const known = Math.max(-1, left) >= bounds[0] && Math.max(-1, bottom) >= bounds[1] && Math.min(1, right) <= bounds[2] && Math.min(1, top) <= bounds[3];
    if (known) return false;
    if (to > from + 1 && !(isAhead && left >= -1 && bottom >= -1 && right <= 1 && top <= 1)) return true;
    bounds[0] = Math.max(-1, Math.min(bounds[0], left));
    bounds[1] = Math.max(-1, Math.min(bounds[1], bottom));
    bounds[2] = Math.min(1, Math.max(bounds[2], right));
    bounds[3] = Math.min(1, Math.max(bounds[3], top));
    return false;
  };
  for (let k = 0; k < cells[2]; k++) {
    for (let j = 0; j < cells[1]; j++) {
      const row = cells[0] * (j + cells[1] * k);
      const run = seen.subarray(row, row + cells[0]);
      const [first, last] = [run.indexOf(1), run.lastIndexOf(1)];
      if (first < 0 || !include(first, last + 1, j, k)) continue;
      for (let i = first; i <= last; i++) if (run[i] === 1) include(i, i + 1, j, k);
      if (bounds[0] <= -1 && bounds[1] <= -1 && bounds[2] >= 1 && bounds[3] >= 1) return bounds;
    }
  }
  return bounds[0] < bounds[2] && bounds[1] < bounds[3] ? bounds : null;
}

/** What is ahead of the eye: corners, and where edges and diagonals between them meet a plane just in front of it. */
function cutCorners(corners: readonly Corner[], least: number): Corner[] {
  const ahead = corners.filter(([, , w]) => w >= least);
  const behind = corners.filter(([, , w]) => w < least);
  return [...ahead, ...ahead.flatMap((a) => behind.map((b): Corner => {
    const share = (a[2] - least) / (a[2] - b[2]);
    return [a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1]), least];
  }))];
}

function boundPlaces(corners: readonly Corner[]): DeviceRectangle {
  let [left, bottom, right, top] = [Infinity, Infinity, -Infinity, -Infinity];
  for (const [x, y, w] of corners) {
    left = Math.min(left, x / w);
    bottom = Math.min(bottom, y / w);
    right = Math.max(right, x / w);
    top = Math.max(top, y / w);
  }
  return [left, bottom, right, top];
}

/** Of a box in the unit cube. @param m - row-major, to clip coordinates */
function cornersOf(low: Vector3, high: Vector3, m: Matrix4): Corner[] {
  const corners: Corner[] = [];
  for (let corner = 0; corner < 8; corner++) {
    const [x, y, z] = [(corner & 1 ? high : low)[0], (corner & 2 ? high : low)[1], (corner & 4 ? high : low)[2]];
    corners.push([m[0] * x + m[1] * y + m[2] * z + m[3], m[4] * x + m[5] * y + m[6] * z + m[7], m[12] * x + m[13] * y + m[14] * z + m[15]]);
  }
  return corners;
}
