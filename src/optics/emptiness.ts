import type { Macrocells } from '../volume/macrocells.ts';
import type { TransferFunction } from './transfer-function.ts';

/** Rings beyond this count as this: they have to fit a byte. */
const mostRings = 255;

/**
 * How far each macrocell is from anything that can be seen: 0 for a cell in which the transfer function shows something,
 * else the number of rings of cells around it, itself being the first, in which it shows nothing. A ray may cross those
 * without looking.
 *
 * Crossing several empty cells at once skips nothing: neighbouring cells share voxels, so the ranges of connected empty
 * cells overlap and lie in one and the same gap of the transfer function.
 * @param slope - data value = slope * stored value + intercept
 * @returns one byte a cell, i fastest
 * Source: the distance field of Deakin and Knoll, *Efficient ray casting of volumetric images using distance maps for
 * empty space skipping*, 2020
 */
export function measureEmptiness(
  cells: Macrocells,
  transferFunction: TransferFunction,
  { slope, intercept }: { slope: number; intercept: number },
): Uint8Array<ArrayBuffer> {
  const rings = new Uint8Array(cells.low.length);
  for (let cell = 0; cell < rings.length; cell++) {
    const a = slope * cells.low[cell] + intercept;
    const b = slope * cells.high[cell] + intercept;
    const hasData = cells.low[cell] <= cells.high[cell];
    rings[cell] = hasData && showsAny(transferFunction, Math.min(a, b), Math.max(a, b)) ? 0 : mostRings;
  }
  spread(rings, cells.dimensions);
  return rings;
}

/** Whether a transfer function shows any of the values between two, both included. */
export function showsAny(transferFunction: TransferFunction, low: number, high: number): boolean {
  const last = transferFunction.length - 1;
  if (low < transferFunction[0].value && transferFunction[0].opacity > 0) return true;
  if (high >= transferFunction[last].value && transferFunction[last].opacity > 0) return true;
  for (let i = 0; i < last; i++) {
    const from = transferFunction[i];
    const to = transferFunction[i + 1];
    if (from.opacity === 0 && to.opacity === 0) continue;
    // At a stop of opacity 0 there is nothing to see yet.
    const afterStart = from.opacity > 0 ? high >= from.value : high > from.value;
    const beforeEnd = to.opacity > 0 ? low <= to.value : low < to.value;
    if (afterStart && beforeEnd) return true;
  }
  return false;
}

/** Chebyshev distances by one pass forth and one back over half of the 26 neighbours each. */
function spread(rings: Uint8Array, [nx, ny, nz]: readonly [number, number, number]): void {
  const relax = (x: number, y: number, z: number, direction: 1 | -1): void => {
    const cell = x + nx * (y + ny * z);
    let least = rings[cell];
    for (const [dx, dy, dz] of half) {
      const [u, v, w] = [x - dx * direction, y - dy * direction, z - dz * direction];
      if (u < 0 || v < 0 || w < 0 || u >= nx || v >= ny || w >= nz) continue;
      least = Math.min(least, rings[u + nx * (v + ny * w)] + 1);
    }
    rings[cell] = least;
  };
  for (let z = 0; z < nz; z++) for (let y = 0; y < ny; y++) for (let x = 0; x < nx; x++) relax(x, y, z, 1);
  for (let z = nz - 1; z >= 0; z--) for (let y = ny - 1; y >= 0; y--) for (let x = nx - 1; x >= 0; x--) relax(x, y, z, -1);
}

/** The neighbours that a pass in the order of the cells has been at before. */
const half: readonly (readonly [number, number, number])[] = [-1, 0, 1]
  .flatMap((dz) => [-1, 0, 1].flatMap((dy) => [-1, 0, 1].map((dx) => [dx, dy, dz] as const)))
  .filter(([dx, dy, dz]) => dz > 0 || (dz === 0 && (dy > 0 || (dy === 0 && dx > 0))));
