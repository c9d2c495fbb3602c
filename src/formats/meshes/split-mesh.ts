import type { SurfacePart } from '../../volume/surface.ts';
import type { Mesh } from './mesh.ts';

/** Maximum number of vertices that 16-bit indices can address. */
export const maxPartVertices = 65_535;

/** Splits a mesh into parts of at most `maxPartVertices` vertices. Vertices that two parts need are in both. */
export function splitMesh({
  positions,
  normals,
  indices,
  colors,
}: Mesh & { readonly normals: Float32Array }): SurfacePart[] {
  const parts: SurfacePart[] = [];
  /**
   * For each vertex: its number in the current part, counted from 1, plus the offset at which that part's numbers
   * begin.
   */
  const names = new Uint32Array(positions.length / 3);
  const own = new Uint32Array(maxPartVertices);
  let [begin, count, base] = [0, 0, 0];
  let corners = new Uint16Array(Math.min(indices.length, 3 * maxPartVertices));
  const close = (end: number): void => {
    const pick = (numbers: Float32Array): Float32Array<ArrayBuffer> => {
      const picked = new Float32Array(3 * count);
      for (let i = 0; i < count; i++)
        for (let axis = 0; axis < 3; axis++) picked[3 * i + axis] = numbers[3 * own[i] + axis];
      return picked;
    };
    parts.push({
      positions: pick(positions),
      normals: pick(normals),
      indices: corners.slice(0, end - begin),
      colors: colors && pick(colors),
    });
    [begin, count, base] = [end, 0, base + count];
  };
  for (let i = 0; i < indices.length; i += 3) {
    if (count + 3 > maxPartVertices) close(i);
    if (i + 3 - begin > corners.length) {
      const room = new Uint16Array(2 * corners.length);
      room.set(corners);
      corners = room;
    }
    for (let corner = i; corner < i + 3; corner++) {
      const vertex = indices[corner];
      if (names[vertex] <= base) {
        own[count] = vertex;
        names[vertex] = base + ++count;
      }
      corners[corner - begin] = names[vertex] - base - 1;
    }
  }
  close(indices.length);
  return parts;
}
