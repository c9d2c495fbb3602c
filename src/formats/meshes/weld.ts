import type { Mesh } from './mesh.ts';

/** Joins vertices of separate triangles that are at the same place. */
export function weld(mesh: Mesh): Mesh {
  const { positions, indices } = mesh;
  const count = positions.length / 3;
  for (let i = 0; i < positions.length; i++) positions[i] += 0; // -0 is 0.
  const bits = new Uint32Array(positions.buffer, positions.byteOffset, positions.length);
  let size = 1024;
  while (size < 2 * count) size *= 2;
  /** For each hash of a position: the number of its vertex, counted from 1; 0 for none. */
  const table = new Uint32Array(size);
  const places = new Float32Array(positions.length);
  const placeBits = new Uint32Array(places.buffer);
  const renamed = new Uint32Array(count);
  let found = 0;
  for (let vertex = 0; vertex < count; vertex++) {
    const [x, y, z] = [bits[3 * vertex], bits[3 * vertex + 1], bits[3 * vertex + 2]];
    let slot = hash(x, y, z) & (size - 1);
    for (; ; slot = (slot + 1) & (size - 1)) {
      const at = 3 * (table[slot] - 1);
      if (table[slot] === 0 || (placeBits[at] === x && placeBits[at + 1] === y && placeBits[at + 2] === z)) break;
    }
    if (table[slot] === 0) {
      places.set(positions.subarray(3 * vertex, 3 * vertex + 3), 3 * found);
      table[slot] = ++found;
    }
    renamed[vertex] = table[slot] - 1;
  }
  return { ...mesh, positions: places.slice(0, 3 * found), indices: indices.map((vertex) => renamed[vertex]) };
}

/** Mixes the bits of three numbers, so that positions on a lattice get different hashes. */
function hash(x: number, y: number, z: number): number {
  let mixed =
    Math.imul(x, 0x9e3779b1) ^
    Math.imul((y << 11) | (y >>> 21), 0x85ebca6b) ^
    Math.imul((z << 22) | (z >>> 10), 0xc2b2ae35);
  mixed ^= mixed >>> 15;
  mixed = Math.imul(mixed, 0x2c1b3c6d);
  return (mixed ^ (mixed >>> 13)) >>> 0;
}
