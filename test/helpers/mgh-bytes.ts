/** What a test changes in an MGH file. */
export interface MghFields {
  readonly version?: number;
  readonly dimensions?: readonly [number, number, number];
  readonly frames?: number;
  readonly type?: number;
  /** good_ras_flag. */
  readonly isPlaced?: boolean;
  readonly spacing?: readonly number[];
  /** Directions of i, j and k, and the centre: twelve numbers. */
  readonly place?: readonly number[];
  readonly samples?: Uint8Array;
}

/** An MGH file, 3 x 2 x 2 voxels of 8 bits unless told differently. */
export function mghBytes({
  version = 1,
  dimensions = [3, 2, 2],
  frames = 1,
  type = 0,
  isPlaced = true,
  spacing = [1, 1, 1],
  place = [-1, 0, 0, 0, 0, -1, 0, 1, 0, 0, 0, 0],
  samples = Uint8Array.from({ length: 12 }, (_, i) => i),
}: MghFields = {}): Uint8Array<ArrayBuffer> {
  const bytes = new Uint8Array(284 + samples.length);
  const view = new DataView(bytes.buffer);
  [version, ...dimensions, frames, type].forEach((n, i) => view.setInt32(4 * i, n));
  view.setInt16(28, isPlaced ? 1 : 0);
  [...spacing, ...place].forEach((n, i) => view.setFloat32(30 + 4 * i, n));
  bytes.set(samples, 284);
  return bytes;
}
