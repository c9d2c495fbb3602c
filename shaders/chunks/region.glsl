/// The grid's unit cube to that of the region that is shown.
uniform mat3 uRegionTurn;
uniform vec3 uRegionShift;

/// Where a ray enters and leaves what is shown. Twin: optics/rays.ts, crossVolume
vec2 crossVolume(vec3 point, vec3 direction) {
  vec2 whole = intersectUnitCube(point, direction);
  vec2 part = intersectUnitCube(uRegionTurn * point + uRegionShift, uRegionTurn * direction);
  return vec2(max(whole.x, part.x), min(whole.y, part.y));
}
