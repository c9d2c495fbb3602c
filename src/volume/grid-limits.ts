// Apart from what checks them: the page needs the numbers only.

/** World units: a box that is this long has a volume that float32 holds, and so has a voxel that is 1 / this long. */
export const longest = 1e12;

/** Most voxels along an axis: far more than any device shows, and few enough to be counted by their rows. */
export const maxVoxelsPerAxis = 2 ** 20;
