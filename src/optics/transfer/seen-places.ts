import { corners, unitToWorld } from '../../volume/grid.ts';
import type { GridFrame } from '../../volume/grid.ts';
import { transformPoint } from '../../volume/matrix.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import type { VolumeData } from '../../volume/volume.ts';
import { evaluate, largestOpacity } from './transfer-function.ts';
import type { TransferFunction } from './transfer-function.ts';

/** The largest number of samples along each edge: all samples of a large volume would take the page too long. */
const maxSamples = 96;

/** Number of steps that the range of values is divided into. */
const shades = 1023;

/** Matter with less opacity than this, or less than this share of the largest opacity, is only a haze and may be left out. */
const haze = { opacity: 0.005, share: 0.03 };

/**
 * Places around everything that is visible of a volume with a transfer function: the ends of the visible parts of rows of voxels, if they
 * are corners of a slice's outline. A radar's gates do not lie in rows, so its macrocells are used.
 * @param shown - a box along the world's axes, or the volume's own grid
 * @returns world coordinates; an empty list if nothing is visible
 */
export function findSeenPlaces(volume: VolumeData, appearance: TransferFunction, shown: GridFrame): Vector3[] {
  const {
    grid,
    samples,
    macrocells,
    slope,
    intercept,
    range: [min, max],
  } = volume;
  const cells =
    grid.kind === 'polar' ? macrocells : { dimensions: grid.dimensions, low: samples, high: samples, size: 1 };
  const [nx, ny, nz] = cells.dimensions;
  const toWorld = unitToWorld(grid);
  const ends = corners(shown);
  const limits = [0, 1, 2].map((axis) => [Math.min, Math.max].map((end) => end(...ends.map((corner) => corner[axis]))));

  const width = (max - min) / shades || 1;
  const visible = Math.min(haze.opacity, haze.share * largestOpacity(appearance));
  const isSeen = Uint8Array.from({ length: shades + 1 }, (_, i) =>
    Number(evaluate(appearance, min + i * width)[3] >= visible),
  );
  const shadeOf = (stored: number): number => Math.round((slope * stored + intercept - min) / width);
  const [scale, zero] = [slope / width, (intercept - min) / width];
  const showsVoxel = (at: number): boolean => isSeen[Math.round(scale * samples[at] + zero)] === 1; // NaN gives undefined.
  const showsCell = (at: number): boolean => {
    if (!(cells.low[at] <= cells.high[at])) return false; // no data
    const [a, b] = [shadeOf(cells.low[at]), shadeOf(cells.high[at])];
    for (let shade = Math.min(a, b); shade <= Math.max(a, b); shade++) if (isSeen[shade]) return true;
    return false;
  };
  const shows = grid.kind === 'polar' ? showsCell : showsVoxel;
  const edge = (cell: number, axis: number): number => Math.min(1, (cell * cells.size) / grid.dimensions[axis]);
  const placeOf = (i: number, j: number, k: number): Vector3 =>
    transformPoint(toWorld, [edge(i, 0), edge(j, 1), edge(k, 2)]);
  const isShown = (place: Vector3): boolean => place.every((x, axis) => x >= limits[axis][0] && x <= limits[axis][1]);

  const places: Vector3[] = [];
  const [dx, dy, dz] = cells.dimensions.map((n) => Math.ceil(n / maxSamples));
  for (let k = 0; k < nz; k += dz) {
    const [left, right] = [new Outline(-1), new Outline(1)];
    for (let j = 0; j < ny; j += dy) {
      const isThere = (i: number): boolean =>
        shows(i + nx * (j + ny * k)) && (shown === grid || isShown(placeOf(i + 0.5, j + 0.5, k + 0.5)));
      let first = 0;
      while (first < nx && !isThere(first)) first += dx;
      if (first >= nx) continue;
      let last = nx - 1;
      while (last > first && !isThere(last)) last -= dx;
      for (const y of [j, j + 1]) {
        left.add(first, y);
        right.add(last + 1, y);
      }
    }
    for (const [i, y] of [...left.corners, ...right.corners]) places.push(placeOf(i, y, k), placeOf(i, y, k + 1));
  }
  return places;
}

/**
 * One side of a slice's convex outline. Places are added by ascending y; the corners of the outline are kept. Only these can be farthest
 * out in any direction.
 */
class Outline {
  readonly corners: (readonly [x: number, y: number])[] = [];

  /** @param side - 1 for the side of large x, -1 for the other */
  constructor(readonly side: 1 | -1) {}

  add(x: number, y: number): void {
    const { corners, side } = this;
    const isWithin = ([ax, ay]: readonly [number, number], [bx, by]: readonly [number, number]): boolean =>
      side * ((bx - ax) * (y - ay) - (x - ax) * (by - ay)) <= 0;
    while (corners.length > 1 && isWithin(corners[corners.length - 2], corners[corners.length - 1])) corners.pop();
    corners.push([x, y]);
  }
}
