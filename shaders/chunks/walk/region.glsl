/// From the grid's unit cube to the unit cube of the region that is shown.
uniform mat3 uRegionTurn;
uniform vec3 uRegionShift;

/// A ray runs through the unit cube, and the region in it. Twin: optics/rays/ray-intervals.ts, boxInterval
Interval boxInterval(Ray ray, Interval interval) {
  vec2 whole = intersectUnitCube(ray.point, ray.direction);
  vec2 part = intersectUnitCube(uRegionTurn * ray.point + uRegionShift, uRegionTurn * ray.direction);
  interval.entry = max(max(whole.x, part.x), interval.entry);
  interval.exit = min(min(whole.y, part.y), interval.exit);
  return interval;
}
