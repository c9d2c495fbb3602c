import { unitToWorld } from '../volume/grid.ts';
import type { GridFrame } from '../volume/grid.ts';
import { cellSize } from '../volume/cell-size.ts';
import type { Macrocells } from '../volume/macrocells.ts';
import { multiply } from '../volume/matrix.ts';
import type { Matrix4, Vector3 } from '../volume/matrix.ts';

/** Left, bottom, right and top, in device coordinates. */
export type DeviceRectangle = readonly [number, number, number, number];

/** Nearer to the eye than this share of the farthest corner's distance, a cell may be anywhere in the picture. */
const minDepth = 1e-3;

/**
 * The part of a picture in which the seen cells lie.
 * @param view - row-major, world to eye; projection - row-major
 * @returns null where none is seen
 */
export function boundSeenCells(
  { grid, macrocells: { dimensions: cells } }: { readonly grid: GridFrame; readonly macrocells: Pick<Macrocells, 'dimensions'> },
  seen: Uint8Array,
  { view, projection }: { readonly view: Matrix4; readonly projection: Matrix4 },
): DeviceRectangle | null {
  const toClip = multiply(projection, multiply(view, unitToWorld(grid)));
  const bounds: [number, number, number, number] = [Infinity, Infinity, -Infinity, -Infinity];
  const edge = (cell: number, axis: number): number => Math.min(1, (cell * cellSize) / grid.dimensions[axis]);
  let [nearest, farthest] = [Infinity, 0];
  const include = (x: number, y: number, z: number): void => {
    const [cx, cy, , cw] = apply(toClip, [x, y, z]);
    nearest = Math.min(nearest, cw);
    farthest = Math.max(farthest, Math.abs(cw));
    bounds[0] = Math.min(bounds[0], cx / cw);
    bounds[1] = Math.min(bounds[1], cy / cw);
    bounds[2] = Math.max(bounds[2], cx / cw);
    bounds[3] = Math.max(bounds[3], cy / cw);
  };
  for (let k = 0; k < cells[2]; k++) {
    for (let j = 0; j < cells[1]; j++) {
      const row = cells[0] * (j + cells[1] * k);
      const run = seen.subarray(row, row + cells[0]);
      const first = run.indexOf(1);
      if (first < 0) continue;
      const ends = [edge(first, 0), edge(run.lastIndexOf(1) + 1, 0)];
      for (let corner = 0; corner < 8; corner++) include(ends[corner & 1], edge(j + ((corner >> 1) & 1), 1), edge(k + (corner >> 2), 2));
    }
  }
  if (farthest === 0 && nearest === Infinity) return null;
  if (!(nearest > minDepth * farthest)) return [-1, -1, 1, 1];
  const clamped = bounds.map((x) => Math.min(1, Math.max(-1, x))) as unknown as DeviceRectangle;
  return clamped[0] < clamped[2] && clamped[1] < clamped[3] ? clamped : null;
}

function apply(m: Matrix4, [x, y, z]: Vector3): number[] {
  return [0, 4, 8, 12].map((r) => m[r] * x + m[r + 1] * y + m[r + 2] * z + m[r + 3]);
}
