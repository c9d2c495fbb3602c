/// Voxels along i, j and k; for a polar grid, those of the lattice around it.
uniform vec3 uDimensions;

/// From a stored value to its share of the transfer function's domain: the scale, and the stored value of the domain's low end.
uniform vec2 uTableDomain;

/// The share of the domain for a stored value. The difference comes first, because it is exact near the low end.
/// Twin: optics/transfer/share-map.ts
float toShare(float stored) {
  return (stored - uTableDomain.y) * uTableDomain.x;
}
