import type { Pixels } from './between-pixels.ts';

/**
 * A pixel that an edge runs through gets more rays in addition to the one through its middle. These are their places, in pixels across and
 * up. All five form a lattice: each has its own of five rows and of five columns, so edges of any slope have five levels.
 */
export const edgeOffsets: readonly (readonly [number, number])[] = [
  [0.2, 0.4],
  [-0.4, 0.2],
  [0.4, -0.2],
  [-0.2, -0.4],
];

/**
 * Finds the quads of 2 x 2 pixels that an edge runs through: one of their pixels has a second difference above a limit
 * along its row or column.
 * @param picture - of bytes
 * @param max - the limit, in 1/255
 * @returns the numbers of the quads, row by row, beginning with the one at the first pixel
 */
export function findEdges({ data, width, height }: Pixels, max: number): Float32Array<ArrayBuffer> {
  const columns = Math.ceil(width / 2);
  const quads = new Uint8Array(columns * Math.ceil(height / 2));
  const bends = (before: number, at: number, after: number): boolean => {
    for (let c = 0; c < 4; c++) if (Math.abs(data[before + c] - 2 * data[at + c] + data[after + c]) > max) return true;
    return false;
  };
  const row = 4 * width;
  for (let y = 0; y < height; y++) {
    const [below, above] = [y > 0 ? row : 0, y + 1 < height ? row : 0];
    const first = (y >> 1) * columns;
    for (let x = 0; x < width; x++) {
      const at = y * row + 4 * x;
      if (quads[first + (x >> 1)] === 1) continue;
      if (bends(x > 0 ? at - 4 : at, at, x + 1 < width ? at + 4 : at) || bends(at - below, at, at + above))
        quads[first + (x >> 1)] = 1;
    }
  }
  const found = new Float32Array(quads.reduce((sum, one) => sum + one, 0));
  let count = 0;
  for (let quad = 0; quad < quads.length; quad++) if (quads[quad] === 1) found[count++] = quad;
  return found;
}

/**
 * Returns a picture in which the pixels of some quads have the mean of several rays.
 * @param pictures - all of one size, one for each ray of a pixel; the first has the rays through the middles
 * @param quads - see `findEdges`
 */
export function meanAtEdges(pictures: readonly ArrayLike<number>[], quads: Float32Array, width: number): Float64Array {
  const columns = Math.ceil(width / 2);
  const chosen = new Set(quads);
  return Float64Array.from(pictures[0], (middle, i) => {
    const [x, y] = [(i >> 2) % width, Math.floor((i >> 2) / width)];
    return chosen.has((y >> 1) * columns + (x >> 1))
      ? pictures.reduce((sum, one) => sum + one[i], 0) / pictures.length
      : middle;
  });
}
