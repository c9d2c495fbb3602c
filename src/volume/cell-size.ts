/** A volume with more voxels than this has large macrocells: else, too much time is spent on finding what they show. */
const maxVoxels = 2 ** 24;

/**
 * Voxels along each edge of a volume's macrocells. Small ones bound what is in them more closely, so rays skip more and
 * need fewer samples.
 * @param dimensions - voxels along i, j and k
 */
export function chooseCellSize([nx, ny, nz]: readonly [number, number, number]): number {
  return nx * ny * nz > maxVoxels ? 8 : 4;
}
