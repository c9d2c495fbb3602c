/// From the grid's unit cube to that of the box that is cut out.
uniform mat3 uCutoutTurn;
uniform vec3 uCutoutShift;

/// The gap in this pixel's ray: begin and end in its t; once the walk begins, in its length. If the ray is whole, both are beyond its end.
vec2 gap = vec2(1.0e30);

/// A box is cut out of a ray: the ray begins behind the box, ends before it, or has a gap. Twin: optics/rays/clip-intervals.ts, cutoutInterval
Interval cutoutInterval(Ray ray, Interval interval) {
  vec2 box = intersectUnitCube(uCutoutTurn * ray.point + uCutoutShift, uCutoutTurn * ray.direction);
  float slack = slackOf(ray.direction);
  if (box.x >= box.y || box.y <= interval.entry + slack || box.x >= interval.exit - slack) return interval;
  bool isFront = box.x <= interval.entry + slack;
  bool isBack = box.y >= interval.exit - slack;
  if (isFront) interval.entry = box.y;
  else if (isBack) interval.exit = box.x;
  else gap = box;
  if (isFront && isBack) interval.exit = min(interval.exit, interval.entry);
  return interval;
}

/// Where the first piece of a ray ends, as a length. A ray that would end inside the gap ends where the gap begins.
/// Twin: optics/rays/cast-ray.ts, pathOf
float endBeforeGap(float entry, float lengthPerT, inout Path path) {
  gap = (gap - entry) * lengthPerT;
  if (gap.y >= path.total - slackOf(path.forward)) path.total = min(path.total, gap.x);
  return min(path.total, gap.x);
}
