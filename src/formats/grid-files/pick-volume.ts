import type { Vector3 } from '../../volume/matrix.ts';

/**
 * Copies the samples of one volume out of an array that holds more, or whose axes have another order. They are packed
 * together, i fastest. Bytes that are the volume already are returned as they are.
 * @param bytes - from the volume's first sample on
 * @param strides - samples from one voxel to the next along i, j and k
 */
export function pickVolume(
  bytes: Uint8Array<ArrayBuffer>,
  bytesPerSample: number,
  dimensions: Vector3,
  strides: Vector3,
): Uint8Array<ArrayBuffer> {
  const [nx, ny, nz] = dimensions;
  const isAll = nx * ny * nz * bytesPerSample === bytes.length;
  if (isAll && strides[0] === 1 && strides[1] === nx && strides[2] === nx * ny) return bytes;
  const picked = new Uint8Array(nx * ny * nz * bytesPerSample);
  let to = 0;
  for (let k = 0; k < nz; k++) {
    for (let j = 0; j < ny; j++) {
      for (let i = 0; i < nx; i++) {
        const from = (i * strides[0] + j * strides[1] + k * strides[2]) * bytesPerSample;
        for (let byte = 0; byte < bytesPerSample; byte++) picked[to++] = bytes[from + byte];
      }
    }
  }
  return picked;
}
