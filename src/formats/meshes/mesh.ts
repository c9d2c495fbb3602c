/** The directions of a file's axes: to the patient's right, front and head, or to the left, back and head. */
export type MeshSpace = 'ras' | 'lps';

/** glTF's space: metres, y up, and the subject looks to +z, so that its right is at -x. */
export type FileSpace = MeshSpace | 'gltf';

/** A surface of triangles, as a file has it. */
export interface Mesh {
  /** x, y and z of each vertex. */
  readonly positions: Float32Array<ArrayBuffer>;
  /** Of each vertex, of length 1; null if the file has none. */
  readonly normals: Float32Array<ArrayBuffer> | null;
  /** Three vertices of each triangle. */
  readonly indices: Uint32Array<ArrayBuffer>;
  /** Red, green and blue of each vertex, 0..1; null if the file has none. */
  readonly colors: Float32Array<ArrayBuffer> | null;
  /** null if the file does not say it. */
  readonly space: FileSpace | null;
  /** The format's name in messages. */
  readonly format: string;
  /** What of the file is not in it, and would be seen, in words. */
  readonly left?: readonly string[];
}
