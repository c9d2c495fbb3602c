import { unitToWorld } from '../../volume/grid.ts';
import type { GridFrame } from '../../volume/grid.ts';
import type { Macrocells } from '../../volume/macrocells.ts';
import { multiply } from '../../volume/matrix.ts';
import type { Matrix4, Vector3 } from '../../volume/matrix.ts';

/** Left, bottom, right and top, in device coordinates. */
export type DeviceRectangle = readonly [number, number, number, number];

/** Places nearer to the eye than this share of the farthest corner's distance are cut off: nothing that matters is so near. */
const minDepth = 1e-6;

/** A corner in clip coordinates. */
type Corner = readonly [x: number, y: number, w: number];

/**
 * The part of a picture in which the visible cells lie. Cells behind the eye or outside the picture do not count.
 * @param view - row-major, world to eye; projection - row-major
 * @returns null if no cell is in the picture
 */
export function boundSeenCells(
  {
    grid,
    macrocells: { dimensions: cells, size },
  }: { readonly grid: GridFrame; readonly macrocells: Pick<Macrocells, 'dimensions' | 'size'> },
  seen: Uint8Array,
  { view, projection }: { readonly view: Matrix4; readonly projection: Matrix4 },
): DeviceRectangle | null {
  const toClip = multiply(projection, multiply(view, unitToWorld(grid)));
  const min = minDepth * Math.max(...cornersOf([0, 0, 0], [1, 1, 1], toClip).map(([, , w]) => Math.abs(w)));
  const edge = (cell: number, axis: number): number => Math.min(1, (cell * size) / grid.dimensions[axis]);
  let bounds: DeviceRectangle = nowhere;
  /** Where the cells of a row, from one index to another, appear in the picture. */
  const appear = (from: number, to: number, j: number, k: number): Appearance => {
    const corners = cornersOf(
      [edge(from, 0), edge(j, 1), edge(k, 2)],
      [edge(to, 0), edge(j + 1, 1), edge(k + 1, 2)],
      toClip,
    );
    const isAhead = corners.every(([, , w]) => w >= min);
    const whole = boundPlaces(isAhead ? corners : cutCorners(corners, min));
    const part = clampToPicture(whole);
    return {
      part,
      isWhole: isAhead && whole.every((at, side) => at === part[side]),
      saysMore: part[0] < part[2] && part[1] < part[3] && join(bounds, part).some((at, side) => at !== bounds[side]),
    };
  };
  for (let k = 0; k < cells[2]; k++) {
    for (let j = 0; j < cells[1]; j++) {
      if (bounds.every((at, side) => at === everywhere[side])) return bounds;
      const row = cells[0] * (j + cells[1] * k);
      const run = seen.subarray(row, row + cells[0]);
      const [first, last] = [run.indexOf(1), run.lastIndexOf(1)];
      if (first < 0) continue;
      const all = appear(first, last + 1, j, k);
      if (!all.saysMore) continue;
      if (all.isWhole) {
        bounds = join(bounds, all.part);
        continue;
      }
      // The row is partly outside the picture. The part inside may have only cells in which nothing is visible, so test each cell.
      for (let i = first; i <= last; i++) {
        const one = run[i] === 1 ? appear(i, i + 1, j, k) : null;
        if (one?.saysMore) bounds = join(bounds, one.part);
      }
    }
  }
  return bounds === nowhere ? null : bounds;
}

/** What is in the picture of some cells. */
interface Appearance {
  /** The part of the picture that shows them. */
  readonly part: DeviceRectangle;
  /** Whether they are wholly in the picture. */
  readonly isWhole: boolean;
  /** Whether this part extends the bounds found so far. */
  readonly saysMore: boolean;
}

const nowhere: DeviceRectangle = [1, 1, -1, -1];
const everywhere: DeviceRectangle = [-1, -1, 1, 1];

function clampToPicture([left, bottom, right, top]: DeviceRectangle): DeviceRectangle {
  return [Math.max(-1, left), Math.max(-1, bottom), Math.min(1, right), Math.min(1, top)];
}

function join(a: DeviceRectangle, b: DeviceRectangle): DeviceRectangle {
  return [Math.min(a[0], b[0]), Math.min(a[1], b[1]), Math.max(a[2], b[2]), Math.max(a[3], b[3])];
}

/** What lies in front of the eye: corners, and the points where edges and diagonals between corners meet a plane just in front of it. */
function cutCorners(corners: readonly Corner[], min: number): Corner[] {
  const ahead = corners.filter(([, , w]) => w >= min);
  const behind = corners.filter(([, , w]) => w < min);
  return [
    ...ahead,
    ...ahead.flatMap((a) =>
      behind.map((b): Corner => {
        const share = (a[2] - min) / (a[2] - b[2]);
        return [a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1]), min];
      }),
    ),
  ];
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

/** The corners of a box in the unit cube. @param m - row-major, to clip coordinates */
function cornersOf(low: Vector3, high: Vector3, m: Matrix4): Corner[] {
  const corners: Corner[] = [];
  for (let corner = 0; corner < 8; corner++) {
    const [x, y, z] = [(corner & 1 ? high : low)[0], (corner & 2 ? high : low)[1], (corner & 4 ? high : low)[2]];
    corners.push([
      m[0] * x + m[1] * y + m[2] * z + m[3],
      m[4] * x + m[5] * y + m[6] * z + m[7],
      m[12] * x + m[13] * y + m[14] * z + m[15],
    ]);
  }
  return corners;
}
