// The box around a volume, and the part of it that is shown.
export type Box = readonly [number, number, number, number, number, number];

/**
 * Two corners of the box around a grid, along the axes of the world.
 * @param dimensions - voxels along i, j and k
 * @param matrix - row-major 4 x 4, from voxels to the world; whole numbers are the middles of voxels
 */
export function boxAround(dimensions: readonly number[], matrix: ArrayLike<number>): Box {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let corner = 0; corner < 8; corner++) {
    const at = dimensions.map((n, axis) => ((corner >> axis) & 1 ? n - 0.5 : -0.5));
    for (let row = 0; row < 3; row++) {
      const x = at.reduce((sum, one, axis) => sum + matrix[4 * row + axis] * one, matrix[4 * row + 3]);
      low[row] = Math.min(low[row], x);
      high[row] = Math.max(high[row], x);
    }
  }
  return [...low, ...high] as unknown as Box;
}

/** @param text - as the attribute `region` has it @returns all of the box where it is absent or can't be read */
export function readRegion(text: string | undefined, box: Box): Box {
  const numbers = (text ?? '').trim().split(/\s+/).map(Number);
  return numbers.length === 6 && numbers.every(Number.isFinite) ? (numbers as unknown as Box) : box;
}

/** @returns null for all of the box */
export function writeRegion(region: Box, box: Box): string | null {
  const isAll = region.every((x, i) => (i < 3 ? x <= box[i] : x >= box[i]));
  return isAll ? null : region.map((x) => Number(x.toPrecision(6))).join(' ');
}
