/// Voxels along i, j and k; of a polar grid, of the lattice around it.
uniform vec3 uDimensions;

/// Stored value to share of the transfer function's domain: scale, offset.
uniform vec2 uTableDomain;
