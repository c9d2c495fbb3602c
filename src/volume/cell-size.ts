// What a page needs to know about macrocells, without the code that makes them, which runs in the worker.

/** Voxels along each edge of a macrocell: of volumes that are not large, and of all others. */
const [small, large] = [4, 8];

/** A volume with more small macrocells than this gets large ones: else, too much time is spent on finding what they show. */
const maxSmall = 2 ** 18;

/**
 * Voxels along each edge of a volume's macrocells. Small ones bound what is in them more closely, so rays skip more and
 * need fewer samples.
 * @param dimensions - voxels along i, j and k
 */
export function chooseCellSize(dimensions: readonly [number, number, number]): number {
  const cells = dimensions.reduce((product, n) => product * Math.ceil(n / small), 1);
  return cells <= maxSmall ? small : large;
}

/**
 * Between two samples that are one voxel apart, tri-linear values differ from the straight line by at most this share
 * of the roughness around them. Causes: kinks at up to three faces of voxels, each crossed half way, and the twist
 * inside a voxel.
 */
export const offLine = 0.7;
