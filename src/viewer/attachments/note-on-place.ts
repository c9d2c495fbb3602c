import { corners } from '../../volume/grid.ts';
import type { GridFrame } from '../../volume/grid.ts';
import type { Vector3 } from '../../volume/matrix.ts';

/** A surface that is this many times larger than the volume is in other units. */
const tooLarge = 20;

/**
 * A message for an author whose surface is not where the volume is: it belongs to another file, has other units, or other axes.
 * @returns null where the surface is in the volume, or around it
 */
export function noteOnPlace(
  { low, high }: { readonly low: Vector3; readonly high: Vector3 },
  grid: GridFrame,
): string | null {
  const axes = [0, 1, 2].map((axis) => {
    const places = corners(grid).map((corner) => corner[axis]);
    return { surface: [low[axis], high[axis]], volume: [Math.min(...places), Math.max(...places)] } as const;
  });
  const meets = axes.every(({ surface, volume }) => surface[1] >= volume[0] && surface[0] <= volume[1]);
  const [own, its] = (['surface', 'volume'] as const).map((which) =>
    Math.hypot(...axes.map((axis) => axis[which][1] - axis[which][0])),
  );
  if (meets && own <= tooLarge * its) return null;
  const spans = (['surface', 'volume'] as const).map((which) =>
    axes.map((axis) => axis[which].map((x) => Number(x.toPrecision(4))).join(' to ')).join(', '),
  );
  return `the surface spans ${spans[0]} and the volume ${spans[1]}, as its world counts: of medical files millimetres. Is it of this volume, and in these units? space="ras" or space="lps" says which way its axes run`;
}
