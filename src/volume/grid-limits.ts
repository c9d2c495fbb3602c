// Apart from the code that checks them: the page needs only the numbers.

/** World units. A box this long still has a volume that float32 can hold, and so has a voxel that is 1 / this long. */
export const longest = 1e12;

/** Maximum number of voxels along an axis: far more than any device shows, and few enough to loop over their rows. */
export const maxVoxelsPerAxis = 2 ** 20;
