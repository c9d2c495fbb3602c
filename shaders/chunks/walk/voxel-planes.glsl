#ifndef PLANE_VOXELS
#define PLANE_VOXELS uDimensions
#endif

/// The planes of voxel centres that a line meets: between two of them, a tri-linear value is a cubic function of the length.
/// Twin: optics/rays/voxel-planes.ts
struct PlaneWalk {
  /// Where the line begins, in voxels (whole numbers at centres); perVoxel: the length of line for one voxel along each axis.
  vec3 origin;
  vec3 perVoxel;
  /// The line's direction along each axis: 1.0 or -1.0.
  vec3 side;
  /// The plane ahead along each axis.
  vec3 ahead;
};

/// origin: of the line, in the unit cube; forward: how far a unit of length moves it.
PlaneWalk enterPlanes(vec3 origin, vec3 forward) {
  vec3 way = forward * PLANE_VOXELS;
  vec3 safe = mix(way, vec3(1.0e-9), vec3(lessThan(abs(way), vec3(1.0e-9))));
  return PlaneWalk(origin * PLANE_VOXELS - 0.5, 1.0 / safe, 2.0 * step(vec3(0.0), safe) - 1.0, vec3(0.0));
}

/// Set the planes ahead for a place of the line.
void standAt(float at, inout PlaneWalk walk) {
  vec3 place = walk.side * (walk.origin + at / walk.perVoxel);
  walk.ahead = walk.side * (floor(place) + 1.0);
}

/// Lengths at which the line meets the planes ahead.
vec3 meetAhead(PlaneWalk walk) {
  return (walk.ahead - walk.origin) * walk.perVoxel;
}

/// The length at which the line met the last plane before these, along any axis.
float meetBehind(PlaneWalk walk) {
  vec3 met = (walk.ahead - walk.side - walk.origin) * walk.perVoxel;
  return max(max(met.x, met.y), met.z);
}

/// The length of the next plane, or the end of the line. Planes at this length are then behind.
float passNext(float end, inout PlaneWalk walk) {
  vec3 met = meetAhead(walk);
  float next = min(min(min(met.x, met.y), met.z), end);
  walk.ahead += walk.side * step(met, vec3(next));
  return next;
}
