import type { Vector3 } from './matrix.ts';

/** A part of a surface that short indices reach, as WebGL 1 wants it. */
export interface SurfacePart {
  /** World coordinates, x, y and z of each vertex. */
  readonly positions: Float32Array<ArrayBuffer>;
  /** Of each vertex, of length 1. */
  readonly normals: Float32Array<ArrayBuffer>;
  /** Three vertices of each triangle. */
  readonly indices: Uint16Array<ArrayBuffer>;
  /** Red, green and blue of each vertex, 0..1; null where all have one colour. */
  readonly colors: Float32Array<ArrayBuffer> | null;
}

/** A surface of triangles in the world. */
export interface Surface {
  readonly parts: readonly SurfacePart[];
  /** Corners of the box around it. */
  readonly low: Vector3;
  readonly high: Vector3;
  readonly triangles: number;
  /** What it was read from, for people. */
  readonly format: string;
  /** What is to be said of it, for who made the page; empty where there is nothing. */
  readonly notes: readonly string[];
  /** Of terrain. */
  readonly terrain?: TerrainFacts;
}

/** What is known of terrain. */
export interface TerrainFacts {
  /** The largest difference between the heights of the files and those of the surface, metres. */
  readonly error: number;
  /** Its root mean square, metres. */
  readonly meanError: number;
  /** Lowest and highest place of what is shown, metres above the sea. */
  readonly heights: readonly [lowest: number, highest: number];
  /** Share of what is shown where the files have no heights. */
  readonly voids: number;
}
