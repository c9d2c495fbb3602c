/// The way of a ray through what is shown, by its length from there in bounding diameters. Twin: optics/ray-stages.ts
struct Path {
  /// Where it begins, in the unit cube; and what a unit of length brings.
  vec3 origin;
  vec3 forward;
  float total;
#ifdef GAP
  /// Between these the ray is cut out; beyond the total where it is not.
  vec2 gap;
#endif
};

/// Where the piece of the way begins and ends that a place is on.
vec2 pieceAround(Path path, float along) {
#ifdef GAP
  return along < path.gap.y ? vec2(0.0, min(path.gap.x, path.total)) : vec2(path.gap.y, path.total);
#else
  return vec2(0.0, path.total);
#endif
}

/// A piece of a ray between two samples.
struct Segment {
  Sample front;
  Sample back;
  /// Where it begins.
  float begin;
  /// Its length; 0 where what is known begins anew after empty space.
  float span;
};
