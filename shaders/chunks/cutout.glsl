/// From the grid's unit cube to that of the box that is cut out.
uniform mat3 uCutoutTurn;
uniform vec3 uCutoutShift;

/// A box is cut out of a ray: it begins behind it, ends before it, or has a gap. Twin: optics/clip-intervals.ts, cutoutInterval
Interval cutoutInterval(Ray ray, Interval interval) {
  vec2 gap = intersectUnitCube(uCutoutTurn * ray.point + uCutoutShift, uCutoutTurn * ray.direction);
  if (gap.x >= gap.y || gap.y <= interval.entry || gap.x >= interval.exit) return interval;
  if (gap.x <= interval.entry) interval.entry = gap.y;
  else if (gap.y >= interval.exit) interval.exit = gap.x;
  else interval.gap = gap;
  return interval;
}
