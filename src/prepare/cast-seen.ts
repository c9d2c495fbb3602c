import { castRay } from '../optics/rays/cast-ray.ts';
import type { IntervalStage, RayStages } from '../optics/rays/ray-stages.ts';
import { rayThrough } from '../optics/rays/rays.ts';
import type { RaySetup } from '../optics/rays/rays.ts';
import { composite } from '../optics/rays/segment.ts';
import { evaluate } from '../optics/transfer/transfer-function.ts';
import type { Premultiplied, TransferFunction } from '../optics/transfer/transfer-function.ts';
import type { Volume } from '../volume/volume.ts';

/** Steps that are cast at once: their places are less than a macrocell from the middle one, also if cells are small. */
const stepsAtOnce = 4;

/** A ray whose opacity is above this shows nothing that comes behind. */
const opaque = 0.9995;

/** Whether something may be seen at a place of the unit cube, or less than half a macrocell from it. */
export type SeenCells = (x: number, y: number, z: number) => boolean;

/** The cells of a volume that show something, with those around them. */
export function findSeenCells(
  { macrocells, grid, slope, intercept }: Volume,
  transferFunction: TransferFunction,
): SeenCells {
  const { dimensions, low, high } = macrocells;
  const [cx, cy, cz] = dimensions;
  const shows = (a: number, b: number): boolean =>
    evaluate(transferFunction, a)[3] > 0 ||
    evaluate(transferFunction, b)[3] > 0 ||
    transferFunction.some(({ value, opacity }) => opacity > 0 && value >= a && value <= b);
  const near = new Uint8Array(cx * cy * cz);
  for (let k = 0; k < cz; k++)
    for (let j = 0; j < cy; j++)
      for (let i = 0; i < cx; i++) {
        const at = i + cx * (j + cy * k);
        if (!(low[at] <= high[at])) continue;
        const ends = [slope * low[at] + intercept, slope * high[at] + intercept];
        if (!shows(Math.min(...ends), Math.max(...ends))) continue;
        for (let z = Math.max(0, k - 1); z <= Math.min(cz - 1, k + 1); z++)
          for (let y = Math.max(0, j - 1); y <= Math.min(cy - 1, j + 1); y++)
            near.fill(1, Math.max(0, i - 1) + cx * (y + cy * z), Math.min(cx - 1, i + 1) + 1 + cx * (y + cy * z));
      }
  const [nx, ny, nz] = grid.dimensions.map((n) => n / macrocells.size);
  const cellOf = (share: number, n: number, cells: number): number =>
    Math.min(cells - 1, Math.max(0, Math.floor(share * n)));
  return (x, y, z) => near[cellOf(x, nx, cx) + cx * (cellOf(y, ny, cy) + cy * cellOf(z, nz, cz))] === 1;
}

/** Casts a ray by pieces of whole steps, of which those are left out that show nothing. */
export function castSeen(
  stages: RayStages,
  rays: RaySetup,
  isSeen: SeenCells,
): (x: number, y: number) => Premultiplied {
  const piece = { entry: 0, exit: 0 };
  const one: IntervalStage = () => ({ ...piece, behind: null });
  const cut: RayStages = { ...stages, intervals: [one] };
  return (x, y) => {
    const ray = rayThrough(rays, x, y);
    const { entry, exit } = stages.intervals.reduce((interval, stage) => stage(ray, interval), {
      entry: stages.eyeT,
      exit: Infinity,
      behind: null,
    } as ReturnType<IntervalStage>);
    const color: Premultiplied = [0, 0, 0, 0];
    const length = (stepsAtOnce * stages.step) / ray.lengthPerT;
    for (let from = entry; from < exit && color[3] < opaque; from += length) {
      // A rest that is shorter than a step belongs to the piece before it.
      const isLast = from + length * (1 + 1e-3 / stepsAtOnce) >= exit;
      const to = isLast ? exit : from + length;
      const middle = (from + to) / 2;
      const [px, py, pz] = ray.point.map((p, axis) => p + middle * ray.direction[axis]);
      if (isSeen(px, py, pz)) {
        Object.assign(piece, { entry: from, exit: to });
        composite(color, castRay(cut, ray));
      }
      if (isLast) break;
    }
    return color;
  };
}
