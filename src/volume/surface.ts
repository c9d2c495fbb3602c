import type { Vector3 } from './matrix.ts';

/** A part of a surface that 16-bit indices can address, as WebGL 1 needs it. */
export interface SurfacePart {
  /** World coordinates, x, y and z of each vertex. */
  readonly positions: Float32Array<ArrayBuffer>;
  /** Of each vertex, of length 1. */
  readonly normals: Float32Array<ArrayBuffer>;
  /** Three vertices of each triangle. */
  readonly indices: Uint16Array<ArrayBuffer>;
  /** Red, green and blue of each vertex, 0..1; null if all have one colour. */
  readonly colors: Float32Array<ArrayBuffer> | null;
}

/** A surface of triangles in the world. */
export interface Surface {
  readonly parts: readonly SurfacePart[];
  /** Corners of the box around it. */
  readonly low: Vector3;
  readonly high: Vector3;
  readonly triangles: number;
  /** The format of its file, for people. */
  readonly format: string;
  /** Notes for the author of the page; empty if there are none. */
  readonly notes: readonly string[];
  /** Only for terrain. */
  readonly terrain?: TerrainFacts;
}

/** Numbers about terrain. */
export interface TerrainFacts {
  /** The largest difference between the heights of the files and those of the surface, metres. */
  readonly error: number;
  /** Its root mean square, metres. */
  readonly meanError: number;
  /** Lowest and highest point of the shown part, metres above the sea. */
  readonly heights: readonly [lowest: number, highest: number];
  /** Share of the shown part where the files have no heights. */
  readonly voids: number;
}
