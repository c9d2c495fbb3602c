import { unitToWorld } from '../../volume/grid.ts';
import type { GridFrame } from '../../volume/grid.ts';
import { length, transformDirection } from '../../volume/matrix.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import type { Samples } from '../../volume/volume.ts';
import { domainOf, emission } from '../transfer/emission.ts';
import type { TransferFunction } from '../transfer/transfer-function.ts';
import { fadeAtCuts } from './cut-fade.ts';
import type { CutFaces } from './cut-fade.ts';
import { keepLast } from './keep-last.ts';
import type { ShadeStage } from './ray-stages.ts';
import type { Ray } from './rays.ts';

/** The light that reaches each cell of a coarse grid from all sides. */
export interface AmbientLight {
  /** Cells along i, j and k of the volume, with `margin` cells outside of it on each side. */
  readonly dimensions: Vector3;
  /** For each cell, i fastest: 255 where a place keeps all of its light. */
  readonly light: Uint8Array<ArrayBuffer>;
  /** World length: a place has the light of a point so far in front of it, on the way to the eye. */
  readonly ahead: number;
}

/** What hides ambient light. */
export interface Hiding {
  readonly volume: {
    readonly grid: GridFrame;
    readonly samples: Samples;
    readonly slope: number;
    readonly intercept: number;
  };
  readonly transferFunction: TransferFunction;
  readonly referenceLength: number;
  readonly opacityFactor: number;
  readonly cuts: CutFaces;
}

/** Cells along the longest edge of a volume. The map has to be made again with each change of the transfer function. */
const maxCells = 64;

/** Open cells around the volume: a place at its face looks up light in front of the face. */
export const margin = 3;

/** Cells from a place to where its light is looked up. In the cell of a surface itself, light would depend on where the surface lies in it. */
const cellsAhead = 1.5;

/** Along each axis, so many voxels of a cell stand for it. */
const voxelsPerCell = 2;

/** Matter hides so many times as much ambient light as it hides of what is behind it: bones are thin, and their caves still have to be dark. */
const density = 3;

/** Cells until matter hides 1/e of what it hides next to it: in a closed room there would be no light at all. */
const reach = 16;

/** A place that sees this share of all directions keeps all of its light: just above a plane it is about so much. */
const open = 0.6;

/** The contrast of what sees less. */
const contrast = 2;

/** The share of light that no matter hides. */
const darkest = 0.1;

/** Columns of the table of what a value hides. */
const columns = 1024;

/**
 * The ambient light on a grid of at most 64 cells along an edge. A cell hides the mean of what its voxels hide; what a cell is hidden by is gathered
 * along 26 directions, one sweep through all cells for each, and fades with distance.
 * Source: Hernell, Ljung and Ynnerman 2010, local ambient occlusion; here on a coarse grid, and by sweeps.
 */
export function measureAmbientLight(hiding: Hiding): AmbientLight {
  const { grid } = hiding.volume;
  const m = unitToWorld(grid);
  const edges = [0, 1, 2].map((i) => length([m[i], m[4 + i], m[8 + i]]));
  const cell = Math.max(...edges) / maxCells;
  const cells = edges.map((edge, i) =>
    Math.max(1, Math.min(grid.dimensions[i], Math.round(edge / cell))),
  ) as unknown as Vector3;
  const dimensions = cells.map((n) => n + 2 * margin) as unknown as Vector3;
  return { dimensions, light: gatherLight(hideByCells(hiding, cells, cell), dimensions), ahead: cellsAhead * cell };
}

/** Which share of light each cell hides, 0..1, with the margin. */
function hideByCells(
  { volume, transferFunction, referenceLength, opacityFactor, cuts }: Hiding,
  cells: Vector3,
  cell: number,
): Float32Array {
  const { samples, slope, intercept, grid } = volume;
  const [low, high] = domainOf(transferFunction);
  const optical = (density * opacityFactor * cell) / referenceLength;
  const table = Float32Array.from(
    { length: columns },
    (_, i) =>
      -Math.expm1(-optical * emission(transferFunction, low + ((high - low) * i) / (columns - 1))[3]) /
      voxelsPerCell ** 3,
  );
  const scale = ((columns - 1) * slope) / (high - low);
  const first = ((columns - 1) * (intercept - low)) / (high - low) + 0.5;
  const [nx, ny] = grid.dimensions;
  const [px, py, pz] = cells.map((n, axis) =>
    Int32Array.from({ length: n * voxelsPerCell }, (_, i) =>
      Math.floor(((i + 0.5) * grid.dimensions[axis]) / (n * voxelsPerCell)),
    ),
  );
  const [cx, cy, cz] = cells;
  const [width, height] = [cx + 2 * margin, cy + 2 * margin];
  const hides = new Float32Array(width * height * (cz + 2 * margin));
  for (let k = 0; k < pz.length; k++) {
    const z = margin + ((k / voxelsPerCell) | 0);
    for (let j = 0; j < py.length; j++) {
      const row = nx * (py[j] + ny * pz[k]);
      const to = margin + width * (margin + ((j / voxelsPerCell) | 0) + height * z);
      for (let i = 0; i < px.length; i++) {
        const column = scale * samples[row + px[i]] + first;
        // NaN, which is no data, is not equal to itself.
        if (column === column)
          hides[to + ((i / voxelsPerCell) | 0)] += table[column < 0 ? 0 : column >= columns ? columns - 1 : column | 0];
      }
    }
  }
  const kept = fadeAtCuts(cuts, cells);
  for (let z = 0; z < cz; z++)
    for (let y = 0; y < cy; y++)
      for (let x = 0, at = margin + width * (y + margin + height * (z + margin)); x < cx; x++, at++)
        if (hides[at] > 0) hides[at] *= kept([(x + 0.5) / cx, (y + 0.5) / cy, (z + 0.5) / cz]);
  return hides;
}

function gatherLight(hides: Float32Array, [nx, ny, nz]: Vector3): Uint8Array<ArrayBuffer> {
  const sums = new Float32Array(hides.length);
  const hidden = new Float32Array(hides.length);
  for (let direction = 0; direction < 27; direction++) {
    const step = [(direction % 3) - 1, (Math.floor(direction / 3) % 3) - 1, Math.floor(direction / 9) - 1];
    const ahead = step[0] + nx * (step[1] + ny * step[2]);
    if (ahead === 0) continue;
    const fades = Math.exp(-length(step as unknown as Vector3) / reach);
    // Cells in such an order that the one ahead comes first. The outermost cells stay open.
    const down = ahead > 0;
    const way = down ? -1 : 1;
    for (let k = 1; k < nz - 1; k++) {
      for (let j = 1; j < ny - 1; j++) {
        const row = nx * ((down ? ny - 1 - j : j) + ny * (down ? nz - 1 - k : k));
        let at = row + (down ? nx - 2 : 1);
        for (let i = 2; i < nx; i++, at += way) {
          const own = hides[at + ahead];
          const all = fades * (own + (1 - own) * hidden[at + ahead]);
          hidden[at] = all;
          sums[at] += all;
        }
      }
    }
  }
  return Uint8Array.from(sums, (sum) => {
    const seen = Math.min(1, (1 - sum / 26) / open);
    return Math.round(255 * (darkest + (1 - darkest) * seen ** contrast));
  });
}

/** The ambient light at a place of the unit cube, 0..1. Twin: shaders/chunks/shade/ambient.glsl, ambientAt */
export function ambientAt({ dimensions, light }: AmbientLight): (place: Vector3) => number {
  const [nx, ny, nz] = dimensions;
  const cellOf = (x: number, n: number): number => Math.min(n - 1, Math.max(0, x * (n - 2 * margin) + margin - 0.5));
  return (place) => {
    const [x, y, z] = [cellOf(place[0], nx), cellOf(place[1], ny), cellOf(place[2], nz)];
    const [i, j, k] = [Math.floor(x), Math.floor(y), Math.floor(z)];
    let sum = 0;
    for (let corner = 0; corner < 8; corner++) {
      const [a, b, c] = [corner & 1, (corner >> 1) & 1, corner >> 2];
      const weight = (a ? x - i : 1 - x + i) * (b ? y - j : 1 - y + j) * (c ? z - k : 1 - z + k);
      if (weight > 0) sum += weight * light[i + a + nx * (j + b + ny * (k + c))];
    }
    return sum / 255;
  };
}

/**
 * Darkens what is hidden from the light that comes from all sides; a cut face keeps its colour. The middle of a piece counts for all of it.
 * Twin: shaders/chunks/shade/ambient.glsl
 */
export function ambientShade(map: AmbientLight, grid: GridFrame, cuts: CutFaces): ShadeStage {
  const ambient = ambientAt(map);
  const fade = fadeAtCuts(cuts, grid.dimensions);
  const toWorld = unitToWorld(grid);
  const aheadOf = keepLast((ray: Ray) => {
    const perWorld = map.ahead / length(transformDirection(toWorld, ray.direction));
    return ray.direction.map((x) => x * perWorld) as unknown as Vector3;
  });
  return ({ front, back }, seen, ray) => {
    if (!(seen[3] > 0)) return seen;
    const [a, b, ahead] = [front.point as Vector3, back.point as Vector3, aheadOf(ray)];
    const middle: Vector3 = [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2];
    const light = ambient([middle[0] - ahead[0], middle[1] - ahead[1], middle[2] - ahead[2]]);
    const share = 1 + fade(middle) * (light - 1);
    return [seen[0] * share, seen[1] * share, seen[2] * share, seen[3]];
  };
}
