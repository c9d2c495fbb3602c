// What a page needs to know about macrocells, without the code that makes them, which runs in the worker.

/** Voxels along each edge of a macrocell. */
export const cellSize = 8;

/**
 * Between two samples that are one voxel apart, tri-linear values differ from the straight line by at most this share
 * of the roughness around them. Causes: kinks at up to three faces of voxels, each crossed half way, and the twist
 * inside a voxel.
 */
export const offLine = 0.7;
