/// A plane a column: normal . p = w for places p of the unit cube.
uniform mat4 uPlanes;

/// How each is painted. First row: 0 no plane, 1 grey, 2 the transfer function's colours; then of greys the share of the
/// table's domain that is black, and 1 / (white - black).
uniform mat4 uPlanePaints;

/// Paint what is seen at a place of a plane. False where there is nothing. Twin: optics/plane-slices.ts, planeInterval
bool paintPlane(vec3 p, vec4 paint, out vec3 color) {
  float value;
  bool valid = sampleVolume(p, value);
  float share = toShare(value);
  color = vec3(clamp((share - paint.y) * paint.z, 0.0, 1.0));
  if (paint.x < 1.5) return valid;
  vec4 seen = classifyValue(share);
  color = seen.rgb / max(seen.a, 1.0e-20);
  return valid && seen.a >= MIN_SLICE_OPACITY;
}

/// The nearest plane on which there are data ends a ray, and stands behind what is before it.
/// Twin: optics/plane-slices.ts, planeInterval
Interval planesInterval(Ray ray, Interval interval) {
  for (int i = 0; i < 4; i++) {
    vec4 paint = uPlanePaints[i];
    if (paint.x < 0.5) break;
    vec4 plane = uPlanes[i];
    float slope = dot(plane.xyz, ray.direction);
    float t = (plane.w - dot(plane.xyz, ray.point)) / (abs(slope) < 1.0e-20 ? 1.0e-20 : slope);
    if (t < interval.entry || t >= interval.exit || isCutOut(t)) continue;
    vec3 color;
    if (!paintPlane(ray.point + t * ray.direction, paint, color)) continue;
    interval.exit = t;
    interval.behind = vec4(color, 1.0);
  }
  return interval;
}
