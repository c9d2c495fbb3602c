/** More surfaces do not fit the shader. */
export const maxSurfaces = 4;
