/// From the grid's unit cube to that of the box that is cut out.
uniform mat3 uCutoutTurn;
uniform vec3 uCutoutShift;

/// Between these nothing is left of this pixel's ray: in its t, and as soon as it is walked by its length. Beyond all where it is whole.
vec2 gap = vec2(1.0e30);

/// A box is cut out of a ray: it begins behind it, ends before it, or has a gap. Twin: optics/clip-intervals.ts, cutoutInterval
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

/// Where the first piece of a ray ends, by its length. What ends within the gap ends where that begins. Twin: optics/cast-ray.ts, pathOf
float endBeforeGap(float entry, float lengthPerT, inout Path path) {
  gap = (gap - entry) * lengthPerT;
  if (gap.y >= path.total - slackOf(path.forward)) path.total = min(path.total, gap.x);
  return min(path.total, gap.x);
}
