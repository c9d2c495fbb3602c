/** Maximum number of pixels of an image: 2^28 are 16,384 x 16,384, the largest texture of today's devices. */
export const maxPixels = 2 ** 28;
