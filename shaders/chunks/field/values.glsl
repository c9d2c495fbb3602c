/// Voxels along i, j and k; of a polar grid, of the lattice around it.
uniform vec3 uDimensions;

/// Stored value to share of the transfer function's domain: scale, and what is stored for its low end.
uniform vec2 uTableDomain;

/// Share of the domain that a stored value means; first the difference, which near the low end is exact.
/// Twin: optics/share-map.ts
float toShare(float stored) {
  return (stored - uTableDomain.y) * uTableDomain.x;
}
