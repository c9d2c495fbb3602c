// What is known of macrocells without their making, which pages leave to the worker.

/** Voxels along each edge of a macrocell. */
export const cellSize = 8;

/**
 * Tri-linear values between two samples a voxel apart leave the straight line between these by no more than this share of the
 * roughness around them: kinks at up to three faces of voxels, each met half way, and the twist inside of a voxel.
 */
export const offLine = 0.7;
