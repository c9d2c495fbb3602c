/** Which way the axes of a file run: to the patient's right, front and head, or to the left, back and head. */
export type MeshSpace = 'ras' | 'lps';

/** That of glTF: metres, y up, and what it shows looks to +z, so that its right is at -x. */
export type FileSpace = MeshSpace | 'gltf';

/** A surface of triangles, as a file has it. */
export interface Mesh {
  /** x, y and z of each vertex. */
  readonly positions: Float32Array<ArrayBuffer>;
  /** Of each vertex, of length 1; null where the file has none. */
  readonly normals: Float32Array<ArrayBuffer> | null;
  /** Three vertices of each triangle. */
  readonly indices: Uint32Array<ArrayBuffer>;
  /** Red, green and blue of each vertex, 0..1; null where the file has none. */
  readonly colors: Float32Array<ArrayBuffer> | null;
  /** null where the file does not say. */
  readonly space: FileSpace | null;
  /** For people. */
  readonly format: string;
  /** What of the file is not in it, and would be seen, in words. */
  readonly left?: readonly string[];
}
