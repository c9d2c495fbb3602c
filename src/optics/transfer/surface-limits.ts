/** The shader has room for at most this many surfaces. */
export const maxSurfaces = 4;
