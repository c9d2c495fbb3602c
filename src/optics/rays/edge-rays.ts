import type { Pixels } from './between-pixels.ts';

/**
 * Where the rays of a pixel go that an edge runs through, beside the one through its middle: pixels across and up. With that they are a lattice
 * of which no two stand in the same of five rows or of five columns, so that edges of any slope have five levels.
 */
export const edgeOffsets: readonly (readonly [number, number])[] = [[0.2, 0.4], [-0.4, 0.2], [0.4, -0.2], [-0.2, -0.4]];

/**
 * Through which quads of 2 x 2 pixels of a picture edges run: one of them bends by more than a limit along its row or its column.
 * @param picture - of bytes
 * @param most - 1/255
 * @returns their numbers, row by row from that at the first pixel
 */
export function findEdges({ data, width, height }: Pixels, most: number): Float32Array<ArrayBuffer> {
  const columns = Math.ceil(width / 2);
  const quads = new Uint8Array(columns * Math.ceil(height / 2));
  const bends = (before: number, at: number, after: number): boolean => {
    for (let c = 0; c < 4; c++) if (Math.abs(data[before + c] - 2 * data[at + c] + data[after + c]) > most) return true;
    return false;
  };
  const row = 4 * width;
  for (let y = 0; y < height; y++) {
    const [below, above] = [y > 0 ? row : 0, y + 1 < height ? row : 0];
    const first = (y >> 1) * columns;
    for (let x = 0; x < width; x++) {
      const at = y * row + 4 * x;
      if (quads[first + (x >> 1)] === 1) continue;
      if (bends(x > 0 ? at - 4 : at, at, x + 1 < width ? at + 4 : at) || bends(at - below, at, at + above)) quads[first + (x >> 1)] = 1;
    }
  }
  const found = new Float32Array(quads.reduce((sum, one) => sum + one, 0));
  let count = 0;
  for (let quad = 0; quad < quads.length; quad++) if (quads[quad] === 1) found[count++] = quad;
  return found;
}

/**
 * A picture with the mean of several rays in the pixels of some quads.
 * @param pictures - of one size, by the rays that pixels have: those through their middles first
 * @param quads - see `findEdges`
 */
export function meanAtEdges(pictures: readonly ArrayLike<number>[], quads: Float32Array, width: number): Float64Array {
  const columns = Math.ceil(width / 2);
  const chosen = new Set(quads);
  return Float64Array.from(pictures[0], (middle, i) => {
    const [x, y] = [(i >> 2) % width, Math.floor((i >> 2) / width)];
    return chosen.has((y >> 1) * columns + (x >> 1)) ? pictures.reduce((sum, one) => sum + one[i], 0) / pictures.length : middle;
  });
}
